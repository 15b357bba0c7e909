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

The root's attribute `models` says what grows: `energy` (if it is left out), `prism`, `prop-root`,
`surface`, or prop roots below another one, `prop-root energy`.

- A *number* may have an exponent: `1e6`. Lengths are millimetres, angles are degrees.
- A *range* is `0.1 0.9` or `0.1..0.9`: a value is drawn from it each time. One number is a range too.
- A *list by order* is `0 20 45`: for the trunk, its limbs, theirs; the last holds for all above.
- A *colour* is `#rrggbb`. Further `<palette name="dark">` elements change some colours of the main one.
- A *drawing* is a name that `edaha leaves` lists, or an SVG file beside the style.
- A *mesh* is an OBJ or PLY file beside the style.
- A *point* is `x y z` in space, y up.
- `<burl/>`, `<hollow/>` and `<obstacle/>` may stand there any number of times; in a style that extends
  another they take the place of all the other's. The text of `<rules>` is the L-system of surface growth:
  `edaha explain rules`.
)";

std::string in_code(const std::string& text) {
    return text.empty() ? text : '`' + text + '`';
}

std::string section(const std::string& name, const std::string& help,
                    std::span<const Parameter> parameters) {
    std::string text = fmt::format("\n## {}: {}\n\n", name, help);
    text += "| parameter | kind | values | default | meaning | source |\n";
    text += "|---|---|---|---|---|---|\n";
    for (const Parameter& parameter : parameters) {
        text +=
            fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", parameter.key(),
                        kind_text(parameter), expected_text(parameter),
                        in_code(value_text(Style(), parameter)), parameter.help, parameter.source);
    }
    return text;
}

}  // namespace

std::string reference_page() {
    std::string page = kIntroduction;
    for (const ParameterGroup& group : parameter_groups())
        page += section(group.name, group.help, group.parameters);
    for (const ParameterList& list : parameter_lists())
        page += section(list.name, list.help, list.parameters);
    return page;
}

}  // namespace edaha
