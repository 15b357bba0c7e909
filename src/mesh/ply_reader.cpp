// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>

#include "base/locate.h"
#include "base/quoted.h"
#include "mesh/ply.h"
#include "mesh/ply_notes.h"
#include "mesh/ply_values.h"
#include "mesh/polygon_soup.h"
#include "mesh/weld.h"

namespace edaha {
namespace {

constexpr double kMostCorners = 10'000;  // cutting one face takes their square
constexpr std::size_t kNoProperty = static_cast<std::size_t>(-1);

std::size_t find_property(const PlyElement& element, bool list,
                          std::initializer_list<std::string_view> names) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        if (property.is_list == list &&
            std::find(names.begin(), names.end(), property.name) != names.end())
            return i;
    }
    return kNoProperty;
}

class PlyReader {
  public:
    PlyReader(std::string_view bytes, const MeshReadParams& params)
        : bytes_(bytes),
          params_(params),
          header_(read_ply_header(bytes)),
          values_(bytes, header_) {}

    Mesh run() {
        for (const PlyElement& element : header_.elements) {
            element_ = &element;
            check_promise();
            if (!names_.insert(element.name).second)
                fail("the element " + quoted(element.name) + " comes twice");
            if (element.name == "vertex") {
                read_points();
            } else if (element.name == "face") {
                read_faces();
            } else {
                skip_element();
            }
        }
        if (soup_.faces.empty()) throw SyntaxError(0, "there are no faces");
        check_indices();
        describe_parts();
        Mesh mesh = mesh_of(std::move(soup_));
        if (params_.weld) weld_open(mesh);
        return mesh;
    }

    bool has_colours() const { return has_colours_; }

  private:
    [[noreturn]] void fail(const std::string& message) const {
        throw SyntaxError(element_->offset, message);
    }

    [[noreturn]] void fail_record(const std::string& message) const {
        throw SyntaxError(values_.is_text() ? values_.offset() : element_->offset, message);
    }

    // Before anything is reserved: does the file hold what its header promises?
    void check_promise() {
        const std::uint64_t count = element_->count;
        const std::uint64_t each =
            values_.is_text() ? 2 * element_->least_numbers() : element_->least_bytes();
        const std::uint64_t spare = values_.is_text() ? 1 : 0;  // no space after the last number
        if (count * each > values_.left() + spare)
            fail(std::to_string(count) + " records of " + quoted(element_->name) + " need " +
                 std::to_string(count * each) + " bytes at least, but " +
                 std::to_string(values_.left()) + " are left in the file");
        const std::uint64_t most = element_->name == "vertex" ? params_.most_points
                                   : element_->name == "face" ? params_.most_triangles
                                                              : count;
        if (count > most)
            fail(std::to_string(count) + " records of " + quoted(element_->name) +
                 " are too many (expected at most " + std::to_string(most) + ")");
        has_colours_ =
            has_colours_ || find_property(*element_, false, {"red", "diffuse_red"}) != kNoProperty;
    }

    // Reads one record; the single values go to record_, each list's to lists_.
    void read_record() {
        const std::vector<PlyProperty>& properties = element_->properties;
        for (std::size_t i = 0; i < properties.size(); ++i) {
            const PlyProperty& property = properties[i];
            if (!property.is_list) {
                record_[i] = values_.next(property.type);
            } else {
                read_list(property, lists_[i]);
            }
        }
    }

    void read_list(const PlyProperty& property, std::vector<double>& list) {
        const double count = values_.next(property.count_type);
        const double each = values_.is_text() ? 2 : static_cast<double>(size_of(property.type));
        const double spare = values_.is_text() ? 1 : 0;
        if (!(count >= 0) || count * each > static_cast<double>(values_.left()) + spare ||
            count != std::floor(count))
            fail_record("a list " + quoted(property.name) + " has more values than the file holds");
        list.resize(static_cast<std::size_t>(count));
        for (double& value : list)
            value = values_.next(property.type);
    }

    void begin_element() {
        record_.assign(element_->properties.size(), 0);
        lists_.assign(element_->properties.size(), {});
    }

    void skip_element() {
        begin_element();
        if (element_->properties.empty()) return;
        if (!values_.is_text() && !element_->has_lists())
            return values_.skip_bytes(element_->count * element_->least_bytes());
        for (std::uint64_t i = 0; i < element_->count; ++i)
            read_record();
    }

    void read_points() {
        begin_element();
        const std::size_t x = find_property(*element_, false, {"x"});
        const std::size_t y = find_property(*element_, false, {"y"});
        const std::size_t z = find_property(*element_, false, {"z"});
        if (std::max({x, y, z}) == kNoProperty) fail("points need properties x, y and z");
        const std::size_t u = find_property(*element_, false, {"s", "u", "texture_u"});
        const std::size_t v = find_property(*element_, false, {"t", "v", "texture_v"});
        uv_of_points_ = std::max(u, v) != kNoProperty;
        soup_.points.reserve(element_->count);
        if (uv_of_points_) soup_.uv.reserve(element_->count);
        for (std::uint64_t i = 0; i < element_->count; ++i) {
            read_record();
            soup_.points.emplace_back(record_[x], record_[y], record_[z]);
            if (uv_of_points_) soup_.uv.emplace_back(record_[u], record_[v]);
        }
    }

    void read_faces() {
        begin_element();
        const std::size_t corners =
            find_property(*element_, true, {"vertex_indices", "vertex_index"});
        if (corners == kNoProperty) fail("faces need a list vertex_indices");
        const std::size_t part = find_property(*element_, false, {"part"});
        const std::size_t uv =
            uv_of_points_ ? kNoProperty : find_property(*element_, true, {"texcoord"});
        soup_.faces.reserve(element_->count);
        soup_.corner_points.reserve(3 * element_->count);
        for (std::uint64_t i = 0; i < element_->count; ++i) {
            read_record();
            add_face(lists_[corners], part == kNoProperty ? 0 : record_[part]);
            if (uv != kNoProperty) add_face_uv(lists_[corners].size(), lists_[uv]);
        }
    }

    void add_face(const std::vector<double>& corners, double part) {
        const auto count = static_cast<double>(corners.size());
        if (count < 3 || count > kMostCorners)
            fail_record("a face has " + std::to_string(corners.size()) +
                        " corners (expected 3 to 10000)");
        const std::uint64_t most_parts =
            std::max<std::uint64_t>(element_->count, header_.comments.size());
        if (!(part >= 0 && part < static_cast<double>(most_parts)) || part != std::floor(part))
            fail_record("the index of a face's part is out of range (expected 0 to " +
                        std::to_string(most_parts - 1) + ")");
        triangles_ += corners.size() - 2;
        if (triangles_ > params_.most_triangles)
            fail_record("there are more than " + std::to_string(params_.most_triangles) +
                        " triangles");
        for (const double corner : corners) {
            if (!(corner >= 0 && corner < static_cast<double>(kNone)) ||
                corner != std::floor(corner))
                fail_record("a face's corner is no index of a point");
            const auto point = static_cast<std::uint32_t>(corner);
            soup_.corner_points.push_back(point);
            if (uv_of_points_) soup_.corner_uv.push_back(point);
            last_point_ = std::max(last_point_, point);
        }
        const auto index = static_cast<std::uint32_t>(part);
        part_count_ = std::max(part_count_, index + 1);
        soup_.faces.push_back({static_cast<std::uint32_t>(corners.size()), index});
        face_line_ = element_->offset;
    }

    // Two numbers a corner; a list of another length counts as none.
    void add_face_uv(std::size_t corners, const std::vector<double>& uv) {
        soup_.corner_uv.resize(soup_.corner_points.size() - corners, kNone);
        if (uv.size() != 2 * corners) return;
        for (std::size_t k = 0; k < corners; ++k) {
            soup_.corner_uv.push_back(static_cast<std::uint32_t>(soup_.uv.size()));
            soup_.uv.emplace_back(uv[2 * k], uv[2 * k + 1]);
        }
    }

    void check_indices() const {
        if (last_point_ < soup_.points.size()) return;
        throw SyntaxError(face_line_, "there is no point " + std::to_string(last_point_) +
                                          " (the file has " + std::to_string(soup_.points.size()) +
                                          ", counted from 0)");
    }

    void describe_parts() {
        PlyNotes notes = read_ply_notes(header_.comments);
        soup_.parts = std::move(notes.parts);
        soup_.parts.resize(part_count_);
        soup_.materials = std::move(notes.materials);
        if (soup_.materials.empty()) soup_.materials.emplace_back();
        for (MeshPart& part : soup_.parts) {
            if (part.material >= soup_.materials.size()) part.material = 0;
            if (part.parent >= static_cast<std::int64_t>(part_count_)) part.parent = -1;
        }
    }

    std::string_view bytes_;
    const MeshReadParams& params_;
    PlyHeader header_;
    PlyValues values_;
    const PlyElement* element_ = nullptr;
    std::vector<double> record_;
    std::vector<std::vector<double>> lists_;
    std::set<std::string> names_;
    PolygonSoup soup_;
    bool uv_of_points_ = false;
    bool has_colours_ = false;
    std::size_t triangles_ = 0;
    std::uint32_t last_point_ = 0;
    std::uint32_t part_count_ = 0;
    std::size_t face_line_ = 0;
};

}  // namespace

MeshInput read_ply(std::string_view bytes, const std::string& file, const MeshReadParams& params) {
    try {
        PlyReader reader(bytes, params);
        MeshInput result;
        result.mesh = reader.run();
        if (reader.has_colours()) {
            Problem& warning = result.warnings.emplace_back();
            warning.place.file = file;
            warning.message = "colours of points and faces are not read";
        }
        return result;
    } catch (const SyntaxError& error) {
        throw InputError({{place_of_offset(bytes, error.offset(), file), error.what()}});
    }
}

}  // namespace edaha
