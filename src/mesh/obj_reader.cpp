// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/locate.h"
#include "base/quoted.h"
#include "mesh/materials.h"
#include "mesh/obj.h"
#include "mesh/polygon_soup.h"
#include "mesh/text_cursor.h"
#include "mesh/weld.h"

namespace edaha {
namespace {

constexpr std::size_t kMostProblems = 10;
constexpr std::uint32_t kMostCorners = 10'000;  // cutting one face takes their square

// What a mesh can do without.
const std::set<std::string_view> kLeftOut = {
    "vp",     "s",        "l",        "p",          "lod",       "bevel", "maplib",
    "usemap", "c_interp", "d_interp", "shadow_obj", "trace_obj", "mg"};

// An index that points further than the file has been read, which may still become true.
struct Forward {
    std::int64_t index = 0;
    std::size_t offset = 0;
};

class ObjReader {
  public:
    ObjReader(std::string_view text, const std::string& file, const MeshReadParams& params,
              const LoadMaterials& load_materials)
        : text_(text),
          file_(file),
          params_(params),
          load_materials_(load_materials),
          cursor_(text) {}

    MeshInput run() {
        soup_.points.reserve(std::min(text_.size() / 64, params_.most_points));
        soup_.corner_points.reserve(std::min(text_.size() / 16, 3 * params_.most_triangles));
        for (; !cursor_.at_end(); cursor_.next_line())
            read_line();
        check_forward(forward_point_, soup_.points.size(), "point");
        check_forward(forward_uv_, soup_.uv.size(), "place in (u,v)");
        if (problems_.empty() && soup_.faces.empty()) problem(text_.size(), "there are no faces");
        if (!problems_.empty()) throw InputError(std::move(problems_));
        name_materials();
        MeshInput result;
        result.mesh = mesh_of(std::move(soup_));
        if (params_.weld) weld_open(result.mesh);
        result.warnings = std::move(warnings_);
        return result;
    }

  private:
    void read_line() {
        if (cursor_.line_ends()) return;
        const std::size_t begin = cursor_.offset();
        const std::string_view keyword = cursor_.word();
        try {
            if (keyword == "v") {
                read_point(begin);
            } else if (keyword == "f") {
                read_face(begin);
            } else if (keyword == "vt") {
                read_uv();
            } else if (keyword != "vn") {
                read_other(keyword, begin);
            }
        } catch (const SyntaxError& error) {
            problem(error.offset(), error.what());
        }
    }

    void read_point(std::size_t begin) {
        const double x = cursor_.number(), y = cursor_.number(), z = cursor_.number();
        while (!cursor_.line_ends())  // a weight, which only curves use, or a colour
            cursor_.number();
        soup_.points.emplace_back(x, y, z);
        if (soup_.points.size() > params_.most_points)
            stop(begin, "there are more than " + std::to_string(params_.most_points) + " points");
    }

    void read_uv() {
        const double u = cursor_.number();
        const double v = cursor_.line_ends() ? 0 : cursor_.number();
        soup_.uv.emplace_back(u, v);
    }

    void read_face(std::size_t begin) {
        std::size_t corners = 0;
        for (; !cursor_.line_ends(); ++corners)
            read_corner();
        if (corners < 3 || corners > kMostCorners) {
            throw SyntaxError(begin, "a face has " + std::to_string(corners) +
                                         " corners (expected 3 to " + std::to_string(kMostCorners) +
                                         ")");
        }
        triangles_ += corners - 2;
        if (triangles_ > params_.most_triangles)
            stop(begin,
                 "there are more than " + std::to_string(params_.most_triangles) + " triangles");
        soup_.faces.push_back({static_cast<std::uint32_t>(corners), part()});
    }

    // point, point/uv, point//normal or point/uv/normal
    void read_corner() {
        const std::size_t begin = cursor_.offset();
        soup_.corner_points.push_back(index(soup_.points.size(), forward_point_, "point"));
        if (!take_slash()) return end_corner(begin);
        if (cursor_.peek() != '/') {
            soup_.corner_uv.resize(soup_.corner_points.size() - 1, kNone);
            soup_.corner_uv.push_back(index(soup_.uv.size(), forward_uv_, "place in (u,v)"));
        }
        if (take_slash() && !cursor_.integer()) fail_corner(begin);
        end_corner(begin);
    }

    bool take_slash() {
        if (cursor_.peek() != '/') return false;
        cursor_.advance();
        return true;
    }

    void end_corner(std::size_t begin) const {
        if (!cursor_.word_ends()) fail_corner(begin);
    }

    [[noreturn]] void fail_corner(std::size_t begin) const {
        throw SyntaxError(begin, cursor_.word_at(begin) +
                                     " is no corner (expected point, point/uv or point/uv/normal)");
    }

    std::uint32_t index(std::size_t count, Forward& forward, const char* what) {
        const std::size_t begin = cursor_.offset();
        const std::optional<std::int64_t> index = cursor_.integer();
        if (!index) fail_corner(begin);
        const auto known = static_cast<std::int64_t>(count);
        if (*index == 0 || *index < -known) fail_index(begin, *index, known, what);
        if (*index < 0) return static_cast<std::uint32_t>(known + *index);
        if (*index > known && *index > forward.index) forward = {*index, begin};
        return static_cast<std::uint32_t>(std::min<std::int64_t>(*index - 1, kNone));
    }

    [[noreturn]] static void fail_index(std::size_t at, std::int64_t index, std::int64_t count,
                                        const std::string& what) {
        const std::string most = std::to_string(count);
        throw SyntaxError(
            at, "there is no " + what + ' ' + std::to_string(index) +
                    (count == 0 ? " (there are none before it)"
                                : " (expected 1 to " + most + ", or -" + most + " to -1)"));
    }

    void check_forward(const Forward& forward, std::size_t count, const char* what) {
        if (forward.index <= static_cast<std::int64_t>(count)) return;
        try {
            fail_index(forward.offset, forward.index, static_cast<std::int64_t>(count), what);
        } catch (const SyntaxError& error) {
            problem(error.offset(), error.what());
        }
    }

    void read_other(std::string_view keyword, std::size_t begin) {
        if (keyword == "o" || keyword == "g") {
            (keyword == "o" ? object_ : group_) = cursor_.line_rest();
            if (keyword == "o") group_.clear();
            part_ = kNone;
        } else if (keyword == "usemtl") {
            material_ = cursor_.line_rest();
            part_ = kNone;
        } else if (keyword == "mtllib") {
            load_colours(std::string(cursor_.line_rest()), begin);
        } else if (!kLeftOut.contains(keyword) && warned_.size() < kMostProblems &&
                   warned_.insert(std::string(keyword)).second) {
            warn(begin, quoted(keyword) + " is not read");
        }
    }

    std::uint32_t part() {
        if (part_ != kNone) return part_;
        const auto [material, new_material] =
            materials_.try_emplace(material_, static_cast<std::uint32_t>(soup_.materials.size()));
        if (new_material) soup_.materials.push_back({material_, {}});
        std::string name = object_;
        if (!group_.empty() && group_ != object_) name += (name.empty() ? "" : "/") + group_;
        const auto [part, new_part] = parts_.try_emplace(
            {name, material->second}, static_cast<std::uint32_t>(soup_.parts.size()));
        if (new_part) {
            MeshPart& added = soup_.parts.emplace_back();
            added.name = std::move(name);
            added.material = material->second;
        }
        return part_ = part->second;
    }

    void load_colours(const std::string& name, std::size_t begin) {
        const std::optional<std::string> text =
            load_materials_ ? load_materials_(name) : std::nullopt;
        if (!text) return warn(begin, "the materials " + quoted(name) + " cannot be read");
        for (const auto& [material, colour] : read_material_colours(*text))
            colours_.insert_or_assign(material, colour);
    }

    void name_materials() {
        for (Material& material : soup_.materials) {
            const auto colour = colours_.find(material.name);
            if (colour != colours_.end()) material.colour = colour->second;
        }
    }

    void problem(std::size_t at, const std::string& message) {
        problems_.push_back({place_of_offset(text_, at, file_), message});
        if (problems_.size() >= kMostProblems) throw InputError(std::move(problems_));
    }

    [[noreturn]] void stop(std::size_t at, const std::string& message) {
        problems_.push_back({place_of_offset(text_, at, file_), message});
        throw InputError(std::move(problems_));
    }

    void warn(std::size_t at, const std::string& message) {
        warnings_.push_back({place_of_offset(text_, at, file_), message});
    }

    std::string_view text_;
    const std::string& file_;
    const MeshReadParams& params_;
    const LoadMaterials& load_materials_;
    TextCursor cursor_;
    PolygonSoup soup_;
    std::size_t triangles_ = 0;
    Forward forward_point_, forward_uv_;
    std::string object_, group_, material_;
    std::uint32_t part_ = kNone;
    std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> parts_;
    std::map<std::string, std::uint32_t> materials_;
    std::map<std::string, Colour> colours_;
    std::set<std::string> warned_;
    std::vector<Problem> problems_, warnings_;
};

}  // namespace

MeshInput read_obj(std::string_view text, const std::string& file, const MeshReadParams& params,
                   const LoadMaterials& load_materials) {
    return ObjReader(text, file, params, load_materials).run();
}

}  // namespace edaha
