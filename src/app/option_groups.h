// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/options.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace edaha {

// Options that several commands share. Each keeps a reference to what parsing fills.

// "-o,--output"; `type` is what help calls the value. The last one counts if it is given twice.
CLI::Option* add_text(CLI::App& app, const std::string& names, std::string& value,
                      const std::string& type, const std::string& help);

// An option that sets a parameter of the style.
void add_setting(CLI::App& app, TreeOptions& tree, const std::string& option,
                 const std::string& key, const std::string& type);

// STYLE and --seed, and all below.
void add_tree(CLI::App& app, TreeOptions& tree);

// --set; --palette, --size and --background.
void add_assignments(CLI::App& app, TreeOptions& tree);
void add_page(CLI::App& app, TreeOptions& tree);

// What changes a style, whatever its seed: those too.
void add_changes(CLI::App& app, TreeOptions& tree);

void add_write(CLI::App& app, WriteOptions& write);
void add_json(CLI::App& app, Options& options);

}  // namespace edaha
