// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "style/catalogue.h"
#include "style/style.h"

namespace edaha {

// Style files: <tree name="oak" title="Oak" models="energy" extends="base"> with one element a
// parameter group, one attribute a parameter, and further <palette name="dark"> that change some
// colours of the main one. What a file leaves out is as in the style that it extends, or the
// default; elements of lists (<burl/>) take the place of all of that list. The main palette is
// settled before the named ones, whichever file they stand in.

// Errors: InputError with every problem of the file, and of the files that it extends, in their
// order. Styles that extend each other in a circle, or more than 16 deep, are problems.
Style read_style(const SourceText& source, const Catalogue& catalogue);

// The complete style, defaults too (they may change in a later version), in the table's order; it
// extends nothing. Groups of 3D models are left out where all is default. read_style(to_xml(s)) is
// s, but for angles that no decimal number of degrees gives exactly: those move by an ulp, once.
std::string to_xml(const Style& style);

// "growth.energy=800", as on the command line. Errors: InputError with every problem, its place
// being `where` ("--set"); the style is then unchanged.
void set_parameters(Style& style, std::span<const std::string> assignments,
                    const std::string& where);

// Makes a named palette the main one. Errors: InputError if there is none of that name.
void choose_palette(Style& style, const std::string& name);

}  // namespace edaha
