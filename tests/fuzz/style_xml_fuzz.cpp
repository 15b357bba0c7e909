// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>

#include "base/error.h"
#include "style/style_xml.h"

// Any bytes as a style file: read, or refused with problems that have a place. What is read is
// written and read again as the same.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    using namespace edaha;
    const Catalogue catalogue;
    const SourceText source{std::string(reinterpret_cast<const char*>(data), size), "fuzz.xml", {}};
    try {
        const std::string xml = to_xml(read_style(source, catalogue));
        const Style again = read_style({xml, "again.xml", {}}, catalogue);
        if (to_xml(again) != xml) std::abort();
    } catch (const InputError& error) {
        if (error.problems().empty()) std::abort();
        for (const Problem& problem : error.problems()) {
            if (problem.place.line < 1 || problem.message.empty()) std::abort();
        }
    }
    return 0;
}
