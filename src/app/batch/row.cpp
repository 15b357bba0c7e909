// SPDX-License-Identifier: MIT
#include "app/batch/row.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "style/value.h"

namespace edaha {
namespace {

using Json = nlohmann::ordered_json;

// Whole numbers without a point, so that JSON and CSV show them alike.
Json number(double value) {
    if (std::abs(value) < 0x1p53 && std::floor(value) == value)
        return static_cast<std::int64_t>(value);
    return value;
}

Json thousandths(double value) {
    return number(std::round(value * 1000) / 1000);
}

Json value_of(const Style& style, const Parameter& parameter) {
    const std::string text = value_text(style, parameter);
    const bool is_number = std::holds_alternative<Number>(parameter.field) ||
                           std::holds_alternative<Integer>(parameter.field);
    return is_number ? number(*parse_number(text)) : Json(text);
}

std::string cell_text(const Json& cell) {
    if (cell.is_string()) return cell.get<std::string>();
    return cell.is_number_float() ? shortest_text(cell.get<double>()) : cell.dump();
}

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

template <class CellText>
std::string csv_line(const std::vector<std::string>& columns, const CellText& text_of) {
    std::string line;
    for (const std::string& column : columns) {
        if (&column != &columns.front()) line += ',';
        line += csv_cell(text_of(column));
    }
    return line + "\r\n";
}

}  // namespace

std::vector<std::string> column_names(const BatchPlan& plan) {
    std::vector<std::string> names{"file", "style", "seed"};
    if (plan.varies_palette()) names.emplace_back("palette");
    for (const Parameter* parameter : plan.differing())
        names.push_back(parameter->key());
    for (const char* name :
         {"width_mm", "height_mm", "branches", "leaves", "overlap", "nodes", "bytes", "recipe"})
        names.emplace_back(name);
    return names;
}

std::string row_json(const FileRow& row, const Variant& variant, const BatchPlan& plan) {
    const Style& style = variant.tree.style;
    Json json;
    json["file"] = row.file;
    json["style"] = style.name;
    json["seed"] = style.energy.variant.seed;
    if (plan.varies_palette()) json["palette"] = variant.palette;
    for (const Parameter* parameter : plan.differing())
        json[parameter->key()] = value_of(style, *parameter);
    json["width_mm"] = thousandths(row.measures.width_mm);
    json["height_mm"] = thousandths(row.measures.height_mm);
    json["branches"] = row.measures.branches;
    json["leaves"] = row.measures.leaves;
    json["overlap"] = thousandths(row.measures.overlap);
    json["nodes"] = row.measures.nodes;
    json["bytes"] = row.bytes;
    json["recipe"] = row.recipe;
    return json.dump();
}

std::optional<FileRow> parse_row(std::string_view line) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object()) return std::nullopt;
    FileRow row;
    try {
        row.file = json.at("file").get<std::string>();
        row.measures.width_mm = json.at("width_mm").get<double>();
        row.measures.height_mm = json.at("height_mm").get<double>();
        row.measures.branches = json.at("branches").get<std::size_t>();
        row.measures.leaves = json.at("leaves").get<std::size_t>();
        row.measures.overlap = json.at("overlap").get<double>();
        row.measures.nodes = json.at("nodes").get<std::size_t>();
        row.bytes = json.at("bytes").get<std::size_t>();
        row.recipe = json.at("recipe").get<std::string>();
    } catch (const Json::exception&) {
        return std::nullopt;
    }
    return row;
}

std::string row_csv(std::string_view line, const std::vector<std::string>& columns) {
    const Json json = Json::parse(line);
    return csv_line(columns, [&](const std::string& column) {
        const auto cell = json.find(column);
        return cell == json.end() ? std::string() : cell_text(*cell);
    });
}

std::string csv_head(const std::vector<std::string>& columns) {
    return csv_line(columns, [](const std::string& column) { return column; });
}

}  // namespace edaha
