// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "app/gallery/element_reader.h"
#include "app/gallery/gallery.h"
#include "app/gallery/tree_reader.h"

namespace edaha {

struct ManualReading {
    ElementReader& elements;
    TreeReader& trees;
    XmlProblems& problems;
    std::function<std::size_t(Plate)> keep;  // into the gallery: its index there
};

// What <parameters> stands for: the groups that it names, of each all parameters, with a strip over
// samples() or the values that a <for> gives. What a <for> for a group changes, one for a parameter
// changes again.
std::vector<ManualGroup> read_manual(const XmlElement& element, const ManualReading& reading);

}  // namespace edaha
