// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "app/gallery/gallery_pages.h"
#include "style/value.h"

namespace edaha {
namespace {

constexpr std::size_t kColumns = 4;
constexpr int kThumbnail_px = 190;  // as shown: four fill the width that code hosts give a page

using Plates = std::vector<PlateReference>;

// Text that stands in a table's cell: a bar would end it, in code too.
std::string cell(const std::string& markdown) {
    std::string text;
    for (const char c : markdown) {
        if (c == '|' && !text.ends_with('\\')) text += '\\';
        text += c;
    }
    return text;
}

class MarkdownWriter {
  public:
    MarkdownWriter(const Gallery& gallery, std::span<const PlateFacts> facts)
        : gallery_(gallery), facts_(facts) {}

    std::string page(const GalleryPage& page) {
        text_ = "# " + markdown_text(page.title) + "\n";
        Plates singles;
        for (const Block& block : page.blocks) {
            const auto* const plate = std::get_if<PlateReference>(&block);
            if (plate != nullptr && gallery_.plates[plate->index].is_single()) {
                singles.push_back(*plate);
                continue;
            }
            add_grid(singles, true);
            singles.clear();
            std::visit([this](const auto& each) { add(each); }, block);
        }
        add_grid(singles, true);
        text_ += "\n[" + markdown_text(gallery_.title) + "](README.md)\n";
        return std::move(text_);
    }

    std::string contents() {
        text_ = "# " + markdown_text(gallery_.title) + "\n";
        if (!gallery_.description.empty()) add(gallery_.description);
        for (const GalleryPage& page : gallery_.pages) {
            text_ += fmt::format("\n## [{}]({}.md)\n", markdown_text(page.title), page.name);
            add_sample(page);
        }
        text_ +=
            "\nWritten by `edaha gallery`. [index.html](index.html) shows all of it in a browser, "
            "to search and to copy from.\n";
        return std::move(text_);
    }

  private:
    // The thumbnail, which leads to the picture.
    std::string image(const PlateReference& reference, int width_px) const {
        const Plate& plate = gallery_.plates[reference.index];
        return fmt::format(
            "<a href=\"{0}.svg\"><img src=\"{0}.png\" width=\"{1}\" alt=\"{2}\"></a>", plate.stem(),
            width_px, html_text(plate.alt()));
    }

    // Two rows of a table for each row of pictures: the pictures, what they are.
    void add_grid(const Plates& plates, bool with_commands) {
        if (plates.empty()) return;
        const std::size_t columns = std::min(plates.size(), kColumns);
        text_ += '\n';
        for (std::size_t i = 0; i < columns; ++i)
            text_ += "| ";
        text_ += "|\n";
        for (std::size_t i = 0; i < columns; ++i)
            text_ += "|:-:";
        text_ += "|\n";
        for (std::size_t row = 0; row < plates.size(); row += columns) {
            const std::size_t end = std::min(row + columns, plates.size());
            std::string pictures, labels;
            for (std::size_t i = row; i < row + columns; ++i) {
                pictures += "| " + (i < end ? cell(image(plates[i], kThumbnail_px)) + ' ' : "");
                labels += "| " + (i < end ? label(plates[i], with_commands) + ' ' : "");
            }
            text_ += fmt::format("{}|\n{}|\n", pictures, labels);
        }
    }

    std::string label(const PlateReference& reference, bool with_command) const {
        const Plate& plate = gallery_.plates[reference.index];
        std::string text = cell(to_markdown(plate.caption));
        if (!with_command) return text;
        if (!text.empty()) text += "<br>";
        return text + cell(markdown_code(plate.trees.front().tree.command));
    }

    // What a page begins with.
    void add_sample(const GalleryPage& page) {
        Plates singles;
        for (const Block& block : page.blocks) {
            const PlateReference* plate = std::get_if<PlateReference>(&block);
            if (const auto* group = std::get_if<ManualGroup>(&block); group && singles.empty()) {
                if (const auto first = first_plate(*group)) return add_image(*first);
            }
            if (plate == nullptr) continue;
            if (!gallery_.plates[plate->index].is_single()) {
                if (!singles.empty()) break;
                return add_image(*plate);
            }
            singles.push_back(*plate);
            if (singles.size() == kColumns) break;
        }
        add_grid(singles, false);
    }

    static std::optional<PlateReference> first_plate(const ManualGroup& group) {
        for (const ManualEntry& entry : group.entries) {
            if (entry.plate) return PlateReference{*entry.plate};
        }
        return std::nullopt;
    }

    void add_image(const PlateReference& reference) {
        text_ += '\n' + image(reference, shown_px(reference)) + '\n';
    }

    // Wide ones take the width that there is.
    int shown_px(const PlateReference& reference) const {
        constexpr int kMost_px = 830;
        return std::min(facts_[reference.index].thumbnail_width_px, kMost_px);
    }

    void add(const Line& line) { text_ += '\n' + to_markdown(line) + '\n'; }

    void add(const PlateReference& reference) {
        const Plate& plate = gallery_.plates[reference.index];
        add_image(reference);
        if (!plate.caption.empty()) add(plate.caption);
        text_ += "\n<details><summary>Draw them yourself</summary>\n\n```sh\n";
        for (const GalleryTree& tree : plate.trees)
            text_ += tree.tree.command + '\n';
        text_ += "```\n\n</details>\n";
    }

    void add(const Table& table) {
        if (table.rows.empty()) return;
        std::size_t columns = 0;
        for (const Table::Row& row : table.rows)
            columns = std::max(columns, row.cells.size());
        const bool has_head = table.rows.front().head;
        text_ += '\n';
        add_row(has_head ? table.rows.front() : Table::Row{}, columns);
        for (std::size_t i = 0; i < columns; ++i)
            text_ += "|---";
        text_ += "|\n";
        for (std::size_t i = has_head ? 1 : 0; i < table.rows.size(); ++i)
            add_row(table.rows[i], columns);
    }

    void add_row(const Table::Row& row, std::size_t columns) {
        for (std::size_t i = 0; i < columns; ++i) {
            const std::string text = i < row.cells.size() ? cell(to_markdown(row.cells[i])) : "";
            text_ += "| ";
            if (!text.empty()) text_ += fmt::format("{0}{1}{0} ", row.head ? "**" : "", text);
        }
        text_ += "|\n";
    }

    void add(const ManualGroup& group) {
        text_ += fmt::format("\n## {}: {}\n", group.group->name, group.group->help);
        for (const ManualEntry& entry : group.entries)
            add(entry);
    }

    void add(const ManualEntry& entry) {
        const Parameter& parameter = *entry.parameter;
        text_ += fmt::format("\n### {}\n\n{}\n\n", parameter.key(), markdown_text(parameter.help));
        text_ += '*' + kind_text(parameter) + '*';
        if (const std::string expected = expected_text(parameter); expected != "yes or no")
            text_ += " · " + markdown_text(expected);
        if (const std::string value = value_text(Style(), parameter); !value.empty())
            text_ += " · default " + markdown_code(value);
        text_ += " · " + markdown_text(parameter.source) + '\n';
        if (!entry.plate) return;
        add_image({*entry.plate});
        if (entry.circumstances.empty()) return;
        text_ += "\nShown with";
        for (const std::string& each : entry.circumstances)
            text_ += ' ' + markdown_code(each);
        text_ += '\n';
    }

    const Gallery& gallery_;
    std::span<const PlateFacts> facts_;
    std::string text_;
};

}  // namespace

std::string markdown_contents(const Gallery& gallery, std::span<const PlateFacts> facts) {
    return MarkdownWriter(gallery, facts).contents();
}

std::string markdown_page(const Gallery& gallery, const GalleryPage& page,
                          std::span<const PlateFacts> facts) {
    return MarkdownWriter(gallery, facts).page(page);
}

}  // namespace edaha
