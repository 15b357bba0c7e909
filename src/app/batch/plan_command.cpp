// SPDX-License-Identifier: MIT
#include "app/batch/plan_command.h"

#include "app/shell_word.h"

namespace edaha {

std::string plan_command(const Options& options) {
    const BatchOptions& batch = options.batch;
    std::string text = "edaha batch";
    const auto add = [&](const std::string& option, const std::string& value) {
        if (!value.empty()) text += ' ' + option + ' ' + shell_word(value);
    };
    const auto add_flag = [&](const std::string& option, bool given) {
        if (given) text += ' ' + option;
    };
    for (const std::string& style : batch.sources)
        text += ' ' + shell_word(style);
    add("-n", batch.count);
    add("--seed-from", batch.seed_from);
    for (const Setting& setting : options.tree.settings)
        add(setting.option, setting.value);
    for (const std::string& assignment : options.tree.assignments)
        add("--set", assignment);
    for (const std::string& sweep : batch.sweeps)
        add("--sweep", sweep);
    add("--palette", options.tree.palette);
    add("--size", options.tree.size);
    add_flag("--background", options.tree.background);
    add("--format", options.format);
    add("--name", batch.name);
    add("--dpi", options.write.dpi);
    add("--width", options.write.width);
    add_flag("--expand", options.write.expand);
    add_flag("--swatches", options.write.swatches);
    add_flag(batch.sheet == "true" ? "--sheet" : "--sheet=" + batch.sheet, !batch.sheet.empty());
    return text;
}

}  // namespace edaha
