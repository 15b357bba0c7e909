// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/batch/plan.h"

namespace edaha {

// What a manifest says about a file besides what it was asked to be.
struct Measures {
    double width_mm = 0;
    double height_mm = 0;
    std::size_t branches = 0;
    std::size_t leaves = 0;
    double overlap = 0;
    std::size_t nodes = 0;
};

// One file. Lengths and overlap are told to the thousandth.
struct FileRow {
    std::string file;  // from the batch's folder
    std::size_t bytes = 0;
    std::string recipe;
    Measures measures;
};

// The names of all columns: file, style, seed, palette, parameters, measures.
std::vector<std::string> column_names(const BatchPlan& plan);

// A row as one line of JSON, without line end.
std::string row_json(const FileRow& row, const Variant& variant, const BatchPlan& plan);

// What is told of a file in such a line. Nothing for a line that is none.
std::optional<FileRow> parse_row(std::string_view line);

// The same row in CSV (RFC 4180), with CR LF; `columns` that it has not stay empty.
// Errors: nlohmann::json::exception if the line is no JSON object.
std::string row_csv(std::string_view line, const std::vector<std::string>& columns);
std::string csv_head(const std::vector<std::string>& columns);

}  // namespace edaha
