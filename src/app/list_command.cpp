// SPDX-License-Identifier: MIT
#include <algorithm>
#include <ostream>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/solid_files.h"
#include "base/error.h"
#include "ornament/leaf.h"
#include "style/style_xml.h"

namespace edaha {
namespace {

using Json = nlohmann::ordered_json;

struct Entry {
    std::string name;
    std::string text;  // what it is, for a person
    Json json;
};

void print(const std::vector<Entry>& entries, const Options& options, Console& console) {
    if (options.json) {
        Json all = Json::array();
        for (const Entry& entry : entries)
            all.push_back(entry.json);
        console.out << all.dump(2) << '\n';
        return;
    }
    std::size_t width = 0;
    for (const Entry& entry : entries)
        width = std::max(width, entry.name.size());
    for (const Entry& entry : entries) {
        if (options.names || entry.text.empty()) {
            console.out << entry.name << '\n';
        } else {
            console.out << fmt::format("{:<{}}  {}\n", entry.name, width, entry.text);
        }
    }
}

Entry describe_style(const std::string& name, const Catalogue& catalogue) {
    Json json;
    json["name"] = name;
    std::string text;
    try {
        const SourceText source = catalogue.find_style(name);
        const Style style = read_style(source, catalogue);
        json["title"] = style.title;
        json["description"] = style.description;
        json["palettes"] = Json::array();
        for (const NamedPalette& palette : style.palettes)
            json["palettes"].push_back(palette.name);
        json["origin"] = source.origin;
        text = style.description.empty() ? style.title : style.description;
    } catch (const std::runtime_error&) {
        json["broken"] = true;
        text = "(broken: see edaha check)";
    }
    return {name, text, json};
}

Entry describe_leaf(const std::string& name, const Catalogue& catalogue) {
    Json json;
    json["name"] = name;
    std::string text;
    try {
        const SourceText source = catalogue.find_leaf(name);
        json["shapes"] = read_leaf(source.text, source.origin).leaf.shapes.size();
        json["origin"] = source.origin;
    } catch (const std::runtime_error&) {
        json["broken"] = true;
        text = "(broken: see edaha check)";
    }
    return {name, text, json};
}

template <class Describe>
int list(const std::vector<std::string>& names, const Options& options, Console& console,
         const Describe& describe) {
    std::vector<Entry> entries;
    for (const std::string& name : names)
        entries.push_back(options.names ? Entry{name, {}, name} : describe(name));
    print(entries, options, console);
    return 0;
}

// The problems of one file; true if it can be used.
bool check_file(const std::string& file, const Catalogue& catalogue, Console& console) {
    const bool is_leaf = file.ends_with(".svg");
    try {
        if (!is_leaf) {
            with_solid_files(read_style(catalogue.find_style(file), catalogue));
            return true;
        }
        const SourceText source = catalogue.find_leaf(file);
        for (const Problem& warning : read_leaf(source.text, source.origin).warnings)
            console.out << to_string(warning) << " (warning)\n";
        return true;
    } catch (const std::runtime_error& error) {
        console.out << error.what() << '\n';
        return false;
    }
}

}  // namespace

int list_styles(const Options& options, Console& console) {
    const Catalogue catalogue(console.user_folder);
    return list(catalogue.style_names(), options, console,
                [&](const std::string& name) { return describe_style(name, catalogue); });
}

int list_leaves(const Options& options, Console& console) {
    const Catalogue catalogue(console.user_folder);
    return list(catalogue.leaf_names(), options, console,
                [&](const std::string& name) { return describe_leaf(name, catalogue); });
}

int check_files(const Options& options, Console& console) {
    const Catalogue catalogue(console.user_folder);
    bool good = true;
    for (const std::string& file : options.files)
        good = check_file(file, catalogue, console) && good;
    return good ? 0 : 1;
}

}  // namespace edaha
