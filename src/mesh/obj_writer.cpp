// SPDX-License-Identifier: MIT
#include <charconv>
#include <numbers>

#include "mesh/materials.h"
#include "mesh/normals.h"
#include "mesh/obj.h"

namespace edaha {
namespace {

constexpr double kCrease = 50 * std::numbers::pi / 180;  // as FlattenParams' creases

class ObjWriter {
  public:
    explicit ObjWriter(const Mesh& mesh) : mesh_(mesh), normals_(corner_normals(mesh, kCrease)) {}

    std::string run(const std::string& materials_file) {
        text_.reserve(64 * (mesh_.points.size() + mesh_.triangles.size()));
        if (!materials_file.empty()) text_ += "mtllib " + materials_file + '\n';
        for (const Vec3& point : mesh_.points)
            write_numbers("v", {point.x, point.y, point.z});
        for (const auto& corners : mesh_.uv) {
            for (const glm::dvec2& uv : corners)
                write_numbers("vt", {uv.x, uv.y});
        }
        for (const Vec3& normal : normals_.normals)
            write_numbers("vn", {normal.x, normal.y, normal.z});
        write_faces(!materials_file.empty());
        return std::move(text_);
    }

  private:
    void write_numbers(const char* keyword, std::initializer_list<double> numbers) {
        text_ += keyword;
        for (const double number : numbers) {
            text_ += ' ';
            // Nine digits tell every float from its neighbours.
            append(number + 0.0, std::chars_format::general, 9);
        }
        text_ += '\n';
    }

    template <typename... Arguments>
    void append(Arguments... arguments) {
        char buffer[32];
        const char* const end = std::to_chars(buffer, buffer + sizeof buffer, arguments...).ptr;
        text_.append(buffer, static_cast<std::size_t>(end - buffer));
    }

    void write_faces(bool with_materials) {
        std::vector<std::vector<std::uint32_t>> of_part(mesh_.parts.size());
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
            of_part[mesh_.part_of[t]].push_back(t);
        for (std::size_t p = 0; p < of_part.size(); ++p) {
            const MeshPart& part = mesh_.parts[p];
            text_ += "g " + part.name + '\n';
            if (with_materials) text_ += "usemtl " + mesh_.materials[part.material].name + '\n';
            for (const std::uint32_t t : of_part[p])
                write_face(t);
        }
    }

    void write_face(std::uint32_t triangle) {
        text_ += 'f';
        for (std::size_t k = 0; k < 3; ++k) {
            text_ += ' ';
            append(mesh_.triangles[triangle][k] + 1);
            text_ += '/';
            if (!mesh_.uv.empty()) append(3 * std::size_t{triangle} + k + 1);
            text_ += '/';
            append(normals_.of[triangle][k] + 1);
        }
        text_ += '\n';
    }

    const Mesh& mesh_;
    CornerNormals normals_;
    std::string text_;
};

}  // namespace

ObjText write_obj(const Mesh& mesh, const std::string& materials_file) {
    ObjText result;
    result.obj = ObjWriter(mesh).run(materials_file);
    if (!materials_file.empty()) result.mtl = material_text(mesh);
    return result;
}

}  // namespace edaha
