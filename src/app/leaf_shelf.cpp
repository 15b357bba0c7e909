// SPDX-License-Identifier: MIT
#include "app/leaf_shelf.h"

#include "base/fingerprint.h"

namespace edaha {

LeafLoader LeafShelf::loader() {
    return [this](const std::string& name) { return leaf(name); };
}

const LeafShelf::Entry& LeafShelf::find(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    const auto known = entries_.find(name);
    if (known != entries_.end()) return known->second;
    const SourceText source = catalogue_.find_leaf(resolve_leaf(name, folder_));
    Fingerprint fingerprint;
    fingerprint.add(source.text);
    Entry entry{read_leaf(source.text, source.origin), fingerprint.text()};
    return entries_.emplace(name, std::move(entry)).first->second;
}

}  // namespace edaha
