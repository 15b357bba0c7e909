// SPDX-License-Identifier: MIT
#include <bit>
#include <charconv>

#include "mesh/ply.h"
#include "mesh/ply_notes.h"

namespace edaha {
namespace {

class PlyWriter {
  public:
    PlyWriter(const Mesh& mesh, PlyKind kind) : mesh_(mesh), is_text_(kind == PlyKind::text) {}

    std::string run() {
        write_header();
        for (const Vec3& point : mesh_.points) {
            for (int axis = 0; axis < 3; ++axis)
                put(static_cast<float>(point[axis]));
            end_record();
        }
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            put(std::uint8_t{3});
            for (const std::uint32_t point : mesh_.triangles[t])
                put(point);
            if (!mesh_.uv.empty()) put_uv(mesh_.uv[t]);
            put(mesh_.part_of[t]);
            end_record();
        }
        return std::move(bytes_);
    }

  private:
    void write_header() {
        bytes_ = "ply\nformat ";
        bytes_ += is_text_ ? "ascii" : "binary_little_endian";
        bytes_ += " 1.0\n" + ply_notes(mesh_);
        bytes_ += "element vertex " + std::to_string(mesh_.points.size()) +
                  "\nproperty float x\nproperty float y\nproperty float z\n";
        bytes_ += "element face " + std::to_string(mesh_.triangles.size()) +
                  "\nproperty list uchar uint vertex_indices\n";
        if (!mesh_.uv.empty()) bytes_ += "property list uchar float texcoord\n";
        bytes_ += "property uint part\nend_header\n";
    }

    void put_uv(const std::array<glm::dvec2, 3>& uv) {
        put(std::uint8_t{6});
        for (const glm::dvec2& place : uv) {
            put(static_cast<float>(place.x));
            put(static_cast<float>(place.y));
        }
    }

    void put(float value) {
        if (!is_text_) return put_bytes(std::bit_cast<std::uint32_t>(value), 4);
        put_text(value);
    }
    void put(std::uint32_t value) {
        if (!is_text_) return put_bytes(value, 4);
        put_text(value);
    }
    void put(std::uint8_t value) {
        if (!is_text_) return put_bytes(value, 1);
        put_text(static_cast<unsigned>(value));
    }

    void put_bytes(std::uint32_t value, int count) {
        for (int i = 0; i < count; ++i)
            bytes_ += static_cast<char>(value >> (8 * i) & 0xff);
    }

    template <typename Number>
    void put_text(Number value) {
        char buffer[32];
        if (bytes_.back() != '\n') bytes_ += ' ';
        const char* const end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
        bytes_.append(buffer, static_cast<std::size_t>(end - buffer));
    }

    void end_record() {
        if (is_text_) bytes_ += '\n';
    }

    const Mesh& mesh_;
    bool is_text_;
    std::string bytes_;
};

}  // namespace

std::string write_ply(const Mesh& mesh, PlyKind kind) {
    return PlyWriter(mesh, kind).run();
}

}  // namespace edaha
