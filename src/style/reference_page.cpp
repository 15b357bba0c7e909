// SPDX-License-Identifier: MIT
#include "style/reference_page.h"

#include <fmt/core.h>

#include "style/parameter.h"
#include "style/value.h"

namespace edaha {
namespace {

constexpr const char* kIntroduction = R"(# What a style can set

Written by `edaha explain --markdown`. In a style file each group is an element and each parameter
an attribute of it, `<growth energy="400"/>`; on the command line it is `--set growth.energy=400`.
Leaves, blossom and fruit have the same parameters. "Paper" is Mama and Nakajima, "Tree Drawing
System for Illustration based on Energy Model"; what Edaha adds to it has the source "Edaha".

The root's attribute `models` says what grows: `energy` (if it is left out), `prism`, `prop-root`, or
prop roots below another one, `prop-root energy`.

- A *number* may have an exponent: `1e6`. Lengths are millimetres, angles are degrees.
- A *range* is `0.1 0.9` or `0.1..0.9`: a value is drawn from it each time. One number is a range too.
- A *list by order* is `0 20 45`: for the trunk, its limbs, theirs; the last holds for all above.
- A *colour* is `#rrggbb`. Further `<palette name="dark">` elements change some colours of the main one.
- A *drawing* is a name that `edaha leaves` lists, or an SVG file beside the style.
)";

std::string in_code(const std::string& text) {
    return text.empty() ? text : '`' + text + '`';
}

}  // namespace

std::string reference_page() {
    std::string page = kIntroduction;
    for (const ParameterGroup& group : parameter_groups()) {
        page += fmt::format("\n## {}: {}\n\n", group.name, group.help);
        page += "| parameter | kind | values | default | meaning | source |\n";
        page += "|---|---|---|---|---|---|\n";
        for (const Parameter& parameter : group.parameters) {
            page += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", parameter.key(),
                                kind_text(parameter), expected_text(parameter),
                                in_code(value_text(Style(), parameter)), parameter.help,
                                parameter.source);
        }
    }
    return page;
}

}  // namespace edaha
