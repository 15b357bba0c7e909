// SPDX-License-Identifier: MIT
#include "app/batch/manifest.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "app/batch/row.h"
#include "app/version.h"
#include "base/atomic_file.h"
#include "base/error.h"

namespace edaha {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kRowsBegin = "\"files\": [";
constexpr const char* kRowsEnd = "]}";

// A head is some lines; a file that shows no rows after so many is another's.
constexpr int kMostHeadLines = 20;

Json to_json(const ManifestHead& head) {
    Json json;
    json["edaha"] = head.version;
    json["command"] = head.command;
    json["recipe"] = head.recipe;
    json["variants"] = head.variants;
    if (!head.shard.is_all()) json["shard"] = shard_text(head.shard);
    json["formats"] = head.formats;
    json["columns"] = head.columns;
    return json;
}

ManifestHead from_json(const Json& json) {
    ManifestHead head;
    head.version = json.at("edaha").get<std::string>();
    head.command = json.at("command").get<std::string>();
    head.recipe = json.at("recipe").get<std::string>();
    head.variants = json.at("variants").get<std::size_t>();
    head.formats = json.at("formats").get<std::vector<std::string>>();
    head.columns = json.at("columns").get<std::vector<std::string>>();
    if (json.contains("shard")) head.shard = parse_shard(json.at("shard").get<std::string>());
    return head;
}

std::string head_lines(const ManifestHead& head) {
    std::string text = "{\n";
    const Json json = to_json(head);
    for (const auto& [key, value] : json.items())
        text += '"' + key + "\": " + value.dump() + ",\n";
    return text + kRowsBegin;
}

}  // namespace

ManifestHead manifest_head(const BatchPlan& plan, const Shard& shard) {
    ManifestHead head{kVersion, plan.command(), plan.recipe(), plan.variants(), {}, {}, shard};
    for (const Format format : plan.formats())
        head.formats.emplace_back(name(format));
    head.columns = column_names(plan);
    return head;
}

std::string manifest_path(const std::string& folder, const Shard& shard) {
    return (std::filesystem::path(folder) / ("manifest" + shard_infix(shard))).string();
}

void write_manifest(const std::string& folder, const ManifestHead& head, const NextRow& next_row) {
    const std::string path = manifest_path(folder, head.shard);
    AtomicFile json(path + ".json");
    AtomicFile csv(path + ".csv");
    json.write(head_lines(head));
    csv.write(csv_head(head.columns));
    const char* between = "\n";
    while (const auto row = next_row()) {
        json.write(between + *row);
        csv.write(row_csv(*row, head.columns));
        between = ",\n";
    }
    json.write(std::string("\n") + kRowsEnd + '\n');
    json.commit();
    csv.commit();
}

ManifestReader::ManifestReader(const std::string& path) : path_(path), file_(path) {
    if (!file_) throw IoError("cannot read '" + path + "': " + std::strerror(errno));
    std::string text, line;
    for (int lines = 0; lines < kMostHeadLines && std::getline(file_, line); ++lines) {
        text += line;
        if (line == kRowsBegin) break;
    }
    const Json json = Json::parse(text + kRowsEnd, nullptr, false);
    if (line != kRowsBegin || !json.is_object()) fail();
    try {
        head_ = from_json(json);
    } catch (const Json::exception&) {
        fail();
    } catch (const UsageError&) {  // of its shard
        fail();
    }
}

std::optional<std::string> ManifestReader::next_row() {
    std::string line;
    if (!std::getline(file_, line)) fail();
    if (line == kRowsEnd) return std::nullopt;
    if (line.ends_with(',')) line.pop_back();
    if (!parse_row(line)) fail();
    return line;
}

void ManifestReader::fail() const {
    throw IoError("'" + path_ + "' is no manifest that edaha batch wrote");
}

}  // namespace edaha
