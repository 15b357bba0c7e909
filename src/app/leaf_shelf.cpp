// SPDX-License-Identifier: MIT
#include "app/leaf_shelf.h"

#include "base/fingerprint.h"

namespace edaha {

DrawingLoader LeafShelf::loader() {
    return {[this](const std::string& name) { return leaf(name); },
            [this](const std::string& name) { return bark(name); }};
}

SourceText LeafShelf::source_of(const std::string& name) const {
    return catalogue_.find_leaf(resolve_leaf(name, folder_));
}

const LeafImport& LeafShelf::leaf(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    const auto known = leaves_.find(name);
    if (known != leaves_.end()) return known->second;
    const SourceText source = source_of(name);
    return leaves_.emplace(name, read_leaf(source.text, source.origin)).first->second;
}

const BarkImport& LeafShelf::bark(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    const auto known = barks_.find(name);
    if (known != barks_.end()) return known->second;
    const SourceText source = source_of(name);
    return barks_.emplace(name, read_bark(source.text, source.origin)).first->second;
}

std::string LeafShelf::fingerprint(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    std::string& known = fingerprints_[name];
    if (known.empty()) {
        Fingerprint fingerprint;
        fingerprint.add(source_of(name).text);
        known = fingerprint.text();
    }
    return known;
}

}  // namespace edaha
