// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "drawing/page_params.h"
#include "drawing/palette.h"
#include "energy/growth_params.h"
#include "energy/look_params.h"
#include "flatten/flatten_params.h"
#include "ornament/ornament_params.h"
#include "ornament/sprig_params.h"
#include "prism/prism_params.h"
#include "proproot/prop_root_params.h"
#include "style/models.h"
#include "surface/surface_params.h"

namespace edaha {

// Another set of colours for the same tree, complete.
struct NamedPalette {
    std::string name;
    Palette palette;
};

// One kind of tree: what every stage needs, in the stages' own units. Style files fill it
// (style_xml.h), value by value as the parameter table says (parameter.h).
struct Style {
    std::string name;         // as in a file name: "cherry"
    std::string title;        // as on a page: "Cherry"
    std::string description;  // a sentence
    std::vector<Model> models{Model::energy};
    EnergyParams energy;
    PrismParams prism;
    PropRootParams prop_root;
    SurfaceParams surface;
    SprigParams sprig;
    FlattenParams flatten;
    LookParams look;
    OrnamentParams leaf;
    OrnamentParams blossom;
    OrnamentParams fruit;
    Palette palette;
    PageParams page;
    std::vector<NamedPalette> palettes;  // in the order of the file
};

}  // namespace edaha
