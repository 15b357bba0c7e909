// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "app/gallery/gallery.h"
#include "app/leaf_shelf.h"
#include "style/catalogue.h"

namespace edaha {

struct GallerySource {
    std::string text;
    std::string origin;            // for messages
    std::filesystem::path folder;  // where paths of styles and leaf drawings begin
};

// Reads a gallery.xml:
//   <gallery title description>      <page name title>          one folder of pictures
//   <text>                           paragraphs, see words.h
//   <picture name caption TREE>      one tree
//   <strip name caption height>      its <picture caption TREE> in one row, in one file
//   <sheet name caption width height columns lettering>    the same in cells of equal size
//   <poster name caption width lettering>    <row>s of them, of <picture>s, spread over the width
//   <sweep name caption height parameter values seeds TREE>    strips over "a | b | c"
//   <parameters groups height TREE>  an entry for each parameter, and a strip of its samples;
//     <for parameter values TREE>    what else is to be set to see one (or a group of them)
//   <table>, <row head>, <cell>
// TREE is style, seed, family, vary, look, palette, size, background="yes" and <set growth.energy=
// "400"/> or <set name="growth.energy" value="400"/> within. Each style is read once.
// Errors: InputError with every problem of the file and of the styles that it names.
Gallery read_gallery(const GallerySource& source, const Catalogue& catalogue, LeafShelf& leaves);

}  // namespace edaha
