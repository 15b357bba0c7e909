// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "app/gallery/gallery_pages.h"
#include "app/gallery/page_parts.h"
#include "app/version.h"
#include "style/value.h"

namespace edaha {
namespace {

std::string in_code(std::string_view text) {
    return "<code>" + html_text(text) + "</code>";
}

std::string size_text(std::size_t bytes) {
    constexpr std::size_t kMega = 1'000'000;
    if (bytes >= kMega) return fmt::format("{:.1f} MB", static_cast<double>(bytes) / kMega);
    return fmt::format("{} KB", std::max<std::size_t>(1, (bytes + 500) / 1000));
}

std::string colour_text(Colour colour) {
    return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

// Values for the places of page.html.
std::string fill(std::string_view page, const std::map<std::string, std::string>& values) {
    std::string text;
    while (true) {
        const std::size_t open = page.find("{{");
        text += page.substr(0, open);
        if (open == std::string_view::npos) return text;
        const std::size_t close = page.find("}}", open);
        text += values.at(std::string(page.substr(open + 2, close - open - 2)));
        page.remove_prefix(close + 2);
    }
}

class HtmlWriter {
  public:
    HtmlWriter(const Gallery& gallery, std::span<const PlateFacts> facts)
        : gallery_(gallery), facts_(facts) {}

    std::string write() {
        const PageParts parts = page_parts();
        return fill(
            parts.html,
            {{"mark", fmt::format("{}, {}", kPageMark, kVersion)},
             {"title", html_text(gallery_.title)},
             {"summary", html_text(to_plain(gallery_.description))},
             {"description",
              gallery_.description.empty() ? "" : "<p>" + html_of(gallery_.description) + "</p>\n"},
             {"css", std::string(parts.css)},
             {"script", std::string(parts.script)},
             {"kinds", kinds()},
             {"pages", pages()},
             {"sections", sections()},
             {"footer", fmt::format("Drawn by Edaha {}: {} pictures. Every one is a file "
                                    "beside this page.",
                                    kVersion, gallery_.plates.size())}});
    }

  private:
    // Links to other pages of the gallery lead to their sections.
    std::string html_of(Line line) const {
        for (Words& words : line) {
            const auto is_meant = [&](const GalleryPage& page) {
                return words.address == page.name + ".md";
            };
            const auto page = std::ranges::find_if(gallery_.pages, is_meant);
            if (page != gallery_.pages.end()) words.address = "#page-" + page->name;
        }
        return to_html(line);
    }

    // The kinds of tree that stand alone somewhere, by their titles.
    std::string kinds() const {
        std::vector<std::string> names;
        std::string text;
        for (const Plate& plate : gallery_.plates) {
            const Style& style = plate.trees.front().tree.style;
            if (!plate.is_single() || std::ranges::count(names, style.name) > 0) continue;
            names.push_back(style.name);
            text += fmt::format("<option value=\"{}\">{}</option>\n", html_text(style.name),
                                html_text(style.title));
        }
        return text;
    }

    std::string pages() const {
        std::string text;
        for (const GalleryPage& page : gallery_.pages) {
            text += fmt::format("<a href=\"#page-{0}\" data-show=\"{0}\">{1}</a>\n", page.name,
                                html_text(page.title));
        }
        return text;
    }

    std::string sections() {
        for (const GalleryPage& page : gallery_.pages) {
            text_ += fmt::format(
                "<section class=\"page\" id=\"page-{0}\" data-page=\"{0}\">\n"
                "<h2>{1}</h2>\n",
                page.name, html_text(page.title));
            page_ = page.name;
            bool in_grid = false;
            for (const Block& block : page.blocks) {
                const bool is_card = is_single(block);
                if (is_card != in_grid) text_ += is_card ? "<div class=\"grid\">\n" : "</div>\n";
                in_grid = is_card;
                std::visit([this](const auto& each) { add(each); }, block);
            }
            text_ += in_grid ? "</div>\n</section>\n" : "</section>\n";
        }
        return std::move(text_);
    }

    bool is_single(const Block& block) const {
        const auto* const plate = std::get_if<PlateReference>(&block);
        return plate != nullptr && gallery_.plates[plate->index].is_single();
    }

    void add(const Line& line) { text_ += "<p class=\"words\">" + html_of(line) + "</p>\n"; }

    void add(const PlateReference& reference) {
        const Plate& plate = gallery_.plates[reference.index];
        text_ += fmt::format("<figure class=\"{}\" {}>\n", plate.is_single() ? "card" : "strip",
                             item(plate));
        add_contents(reference.index);
        text_ += "</figure>\n";
    }

    // What makes an element one that the script finds: its name, and what it is found by.
    std::string item(const Plate& plate) const {
        std::string kinds, titles;
        for (const GalleryTree& tree : plate.trees) {
            const Style& style = tree.tree.style;
            if ((' ' + kinds + ' ').find(' ' + style.name + ' ') != std::string::npos) continue;
            kinds += (kinds.empty() ? "" : " ") + style.name;
            titles += ' ' + style.title;
        }
        const std::string words = plate.stem() + titles + ' ' + plate.keywords;
        return fmt::format(
            "id=\"{}\" data-item data-page=\"{}\" data-kinds=\"{}\" data-words=\"{}\"",
            plate.stem(), page_, html_text(kinds), html_text(words));
    }

    // Of a figure: the thumbnail, which leads to the picture, its caption, the commands.
    void add_contents(std::size_t index) {
        const Plate& plate = gallery_.plates[index];
        const PlateFacts& facts = facts_[index];
        if (!plate.is_single()) text_ += "<div class=\"scroll\">";
        text_ += fmt::format(
            "<a class=\"sheet\" href=\"{0}.svg\" data-size=\"{1}\" style=\"--paper: {2}\">"
            "<img src=\"{0}.png\" width=\"{3}\" height=\"{4}\" alt=\"{5}\" loading=\"lazy\"></a>",
            plate.stem(), size_text(facts.svg_bytes), colour_text(facts.paper),
            facts.thumbnail_width_px, facts.thumbnail_height_px, html_text(plate.alt()));
        text_ += plate.is_single() ? "\n" : "</div>\n";
        text_ += "<figcaption>" +
                 (plate.caption.empty() ? html_text(plate.name) : html_of(plate.caption));
        const std::string& kind = plate.trees.front().tree.style.title;
        if (plate.is_single() && kind != plate.alt())
            text_ += "<span class=\"kind\">" + html_text(kind) + "</span>";
        text_ += "</figcaption>\n<ul class=\"commands\">\n";
        for (const GalleryTree& tree : plate.trees) {
            text_ += "<li>";
            if (!tree.caption.empty()) text_ += "<span>" + html_text(tree.caption) + "</span>";
            text_ += in_code(tree.tree.command) + "</li>\n";
        }
        text_ += "</ul>\n";
    }

    void add(const Table& table) {
        text_ += "<div class=\"table\"><table>\n";
        for (const Table::Row& row : table.rows) {
            text_ += "<tr>";
            const char* const tag = row.head ? "th" : "td";
            for (const Line& line : row.cells)
                text_ += fmt::format("<{0}>{1}</{0}>", tag, html_of(line));
            text_ += "</tr>\n";
        }
        text_ += "</table></div>\n";
    }

    void add(const ManualGroup& group) {
        text_ += fmt::format(
            "<h3 class=\"group\" id=\"group-{0}\">{0}</h3>\n<p class=\"words\">{1}</p>\n",
            html_text(group.group->name), html_text(group.group->help));
        for (const ManualEntry& entry : group.entries)
            add(entry);
    }

    void add(const ManualEntry& entry) {
        const Parameter& parameter = *entry.parameter;
        const std::string key = html_text(parameter.key());
        text_ += "<article class=\"entry\" ";
        text_ += entry.plate ? item(gallery_.plates[*entry.plate])
                             : fmt::format(
                                   "id=\"{0}\" data-item data-page=\"{1}\" data-kinds=\"\" "
                                   "data-words=\"\"",
                                   key, page_);
        text_ += fmt::format(">\n<div>\n<h4><code>{}</code></h4>\n<p class=\"help\">{}</p>\n", key,
                             html_text(parameter.help));
        add_facts(entry);
        text_ += "</div>\n";
        if (entry.plate) {
            text_ += "<figure class=\"strip\">\n";
            add_contents(*entry.plate);
            text_ += "</figure>\n";
        }
        text_ += "</article>\n";
    }

    void add_facts(const ManualEntry& entry) {
        const Parameter& parameter = *entry.parameter;
        std::vector<std::string> facts{html_text(kind_text(parameter))};
        if (const std::string expected = expected_text(parameter); expected != facts.front())
            facts.push_back(html_text(expected));
        if (const std::string value = value_text(Style(), parameter); !value.empty())
            facts.push_back("default " + in_code(value));
        facts.push_back(html_text(parameter.source));
        if (!entry.circumstances.empty()) {
            std::string with = "shown with";
            for (const std::string& each : entry.circumstances)
                with += ' ' + in_code(each);
            facts.push_back(with);
        }
        text_ += fmt::format("<p class=\"facts\"><span>{}</span></p>\n",
                             fmt::join(facts, "</span><span>"));
    }

    const Gallery& gallery_;
    std::span<const PlateFacts> facts_;
    std::string text_;
    std::string page_;  // whose section is being written
};

}  // namespace

std::string html_page(const Gallery& gallery, std::span<const PlateFacts> facts) {
    return HtmlWriter(gallery, facts).write();
}

}  // namespace edaha
