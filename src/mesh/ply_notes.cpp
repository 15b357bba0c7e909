// SPDX-License-Identifier: MIT
#include "mesh/ply_notes.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "base/quoted.h"

namespace edaha {
namespace {

std::string_view take_word(std::string_view& text) {
    text = trimmed(text);
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(word.size());
    return word;
}

template <typename Whole>
std::optional<Whole> take_whole(std::string_view& text, int base = 10) {
    const std::string_view word = take_word(text);
    const char* const end = word.data() + word.size();
    Whole value = 0;
    const auto [stop, error] = std::from_chars(word.data(), end, value, base);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

std::string hex(Colour colour) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t c : {colour.r, colour.g, colour.b})
        text += {kDigits[c >> 4], kDigits[c & 15]};
    return text;
}

void read_material(std::string_view note, PlyNotes& notes) {
    if (take_whole<std::size_t>(note) != notes.materials.size()) return;
    std::string_view after = note;
    Material material;
    if (take_word(after) != "none") {
        const std::optional<std::uint32_t> rgb = take_whole<std::uint32_t>(note, 16);
        if (!rgb) return;
        material.colour =
            Colour{static_cast<std::uint8_t>(*rgb >> 16), static_cast<std::uint8_t>(*rgb >> 8),
                   static_cast<std::uint8_t>(*rgb)};
        after = note;
    }
    material.name = trimmed(after);
    notes.materials.push_back(std::move(material));
}

void read_part(std::string_view note, PlyNotes& notes) {
    if (take_whole<std::size_t>(note) != notes.parts.size()) return;
    const auto order = take_whole<std::uint32_t>(note);
    const auto parent = take_whole<std::int32_t>(note);
    const auto material = take_whole<std::uint32_t>(note);
    if (!order || !parent || !material) return;
    MeshPart part;
    part.name = trimmed(note);
    part.order = *order;
    part.parent = *parent;
    part.material = *material;
    notes.parts.push_back(std::move(part));
}

}  // namespace

PlyNotes read_ply_notes(const std::vector<std::string>& comments) {
    PlyNotes notes;
    for (const std::string& comment : comments) {
        std::string_view note = comment;
        const std::string_view kind = take_word(note);
        if (kind == "material") read_material(note, notes);
        if (kind == "part") read_part(note, notes);
    }
    return notes;
}

std::string ply_notes(const Mesh& mesh) {
    std::string text;
    for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
        const Material& material = mesh.materials[i];
        text += "comment material " + std::to_string(i) + ' ' +
                (material.colour ? hex(*material.colour) : "none") + ' ' + material.name + '\n';
    }
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        const MeshPart& part = mesh.parts[i];
        text += "comment part " + std::to_string(i) + ' ' + std::to_string(part.order) + ' ' +
                std::to_string(part.parent) + ' ' + std::to_string(part.material) + ' ' +
                part.name + '\n';
    }
    return text;
}

}  // namespace edaha
