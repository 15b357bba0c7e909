// SPDX-License-Identifier: MIT
#include "write/pdf.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "write/path_operators.h"
#include "write/pdf_content.h"
#include "write/pdf_objects.h"
#include "write/pdf_recipe.h"

namespace edaha {
namespace {

constexpr int kOpacityDecimals = 3;

// Some programs want dates; any moment will do if it is always the same one.
constexpr const char* kDate = "(D:20000101000000Z)";

std::string information(const Metadata& metadata) {
    std::string entries = "<<";
    const auto add = [&](const std::string& key, const std::string& text) {
        if (!text.empty()) entries += key + pdf_text(text);
    };
    add("/Title", metadata.title);
    add("/Subject", metadata.description);
    add("/Keywords", metadata.command);
    add("/Creator", metadata.version.empty() ? "edaha" : "edaha " + metadata.version);
    add(kPdfRecipeKey, metadata.recipe);
    return entries + "/CreationDate" + kDate + "/ModDate" + kDate + ">>";
}

// A side of a page. Rounded down: readers count a pixel more for the least bit above a whole number
// of them.
std::string side_text(double mm) {
    return number_text(mm * kPointsPerMm - 0.5e-4, 4);
}

std::string box_text(const Bounds& box, int decimals) {
    std::string text = "[";
    for (const double number : {box.min.x, box.min.y, box.max.x, box.max.y}) {
        append_number(text, number, decimals);
        text += ' ';
    }
    text.back() = ']';
    return text;
}

}  // namespace

struct PdfBook::State {
    State(Sink sink, Metadata about)
        : objects(std::move(sink)), metadata(std::move(about)), page_tree(objects.reserve()) {}

    void add_page(const Drawing& drawing, PdfInstances instances);
    void finish();

  private:
    struct LayerGroup {
        std::string label;
        int number;
    };

    std::string states_of(const std::set<std::string>& states);
    int form(const PdfForm& form);
    std::string forms_of(const std::vector<PdfForm>& forms);
    std::string groups_of(const std::vector<Layer>& layers);
    std::string layer_list() const;

    PdfObjects objects;
    Metadata metadata;
    int page_tree;
    std::vector<int> pages;
    std::vector<LayerGroup> groups;     // bottom first
    std::map<std::string, int> states;  // by name
    std::map<std::string, int> forms;   // by all that they hold
};

// 8.4.5: /ca is of fills, /CA of strokes.
std::string PdfBook::State::states_of(const std::set<std::string>& names) {
    if (names.empty()) return "";
    std::string entry = "/ExtGState<<";
    for (const std::string& name : names) {
        const auto [known, added] = states.try_emplace(name, 0);
        if (added) {
            const char* key = name[0] == 'f' ? "ca " : "CA ";
            const double opacity = std::stoi(name.substr(1)) / 1000.0;
            known->second = objects.write("<</Type/ExtGState/" + std::string(key) +
                                          number_text(opacity, kOpacityDecimals) + ">>");
        }
        entry += '/' + name + ' ' + pdf_reference(known->second);
    }
    return entry + ">>";
}

int PdfBook::State::form(const PdfForm& form) {
    const std::string entries = "/Type/XObject/Subtype/Form/BBox" +
                                box_text(form.box, form.decimals) + "/Resources<<" +
                                states_of(form.operators.states) + ">>";
    const auto [known, added] = forms.try_emplace(entries + form.operators.text, 0);
    if (added) {
        known->second = objects.reserve();
        objects.write_stream(known->second, {entries, form.operators.text});
    }
    return known->second;
}

std::string PdfBook::State::forms_of(const std::vector<PdfForm>& all) {
    if (all.empty()) return "";
    std::string entry = "/XObject<<";
    for (std::size_t i = 0; i < all.size(); ++i)
        entry += "/F" + std::to_string(i) + ' ' + pdf_reference(form(all[i]));
    return entry + ">>";
}

// 8.11.2. A label that no page before had goes above the one below it on this page.
std::string PdfBook::State::groups_of(const std::vector<Layer>& layers) {
    if (layers.empty()) return "";
    std::string entry = "/Properties<<";
    auto next = groups.begin();
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const std::string& label = layers[i].label;
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const LayerGroup& known) { return known.label == label; });
        if (group == groups.end()) {
            const int number = objects.write("<</Type/OCG/Name" + pdf_text(label) + ">>");
            group = groups.insert(next, {label, number});
        }
        entry += "/L" + std::to_string(i) + ' ' + pdf_reference(group->number);
        next = group + 1;
    }
    return entry + ">>";
}

void PdfBook::State::add_page(const Drawing& drawing, PdfInstances instances) {
    const PdfContent content = pdf_content(drawing, instances);
    const std::string resources =
        states_of(content.operators.states) + forms_of(content.forms) + groups_of(drawing.layers);
    const int stream = objects.reserve();
    objects.write_stream(stream, {"", content.operators.text,
                                  instances == PdfInstances::forms ? PdfObjects::Packing::quick
                                                                   : PdfObjects::Packing::small});
    pages.push_back(objects.write(
        "<</Type/Page/Parent " + pdf_reference(page_tree) + "/MediaBox[0 0 " +
        side_text(drawing.width_mm) + ' ' + side_text(drawing.height_mm) + "]/Resources<<" +
        resources + ">>/Group<</Type/Group/S/Transparency/I true/CS/DeviceRGB>>/Contents " +
        pdf_reference(stream) + ">>"));
}

std::string PdfBook::State::layer_list() const {
    if (groups.empty()) return "";
    std::string top_first = "[";
    for (auto group = groups.rbegin(); group != groups.rend(); ++group)
        top_first += pdf_reference(group->number) + ' ';
    top_first.back() = ']';
    return "/OCProperties<</OCGs" + top_first + "/D<</Name(Layers)/Order" + top_first + "/ON" +
           top_first + ">>>>";
}

void PdfBook::State::finish() {
    std::string kids;
    for (const int page : pages)
        kids += pdf_reference(page) + ' ';
    objects.write(page_tree,
                  "<</Type/Pages/Count " + std::to_string(pages.size()) + "/Kids[" + kids + "]>>");
    const int catalogue =
        objects.write("<</Type/Catalog/Pages " + pdf_reference(page_tree) + layer_list() + ">>");
    objects.finish(catalogue, objects.write(information(metadata)));
}

PdfBook::PdfBook(Sink sink, const Metadata& metadata)
    : state_(std::make_unique<State>(std::move(sink), metadata)) {}
PdfBook::~PdfBook() = default;
PdfBook::PdfBook(PdfBook&&) noexcept = default;

void PdfBook::add_page(const Drawing& drawing) {
    state_->add_page(drawing, PdfInstances::forms);
}

void PdfBook::finish() {
    state_->finish();
}

std::string pdf_bytes(const Drawing& drawing) {
    std::string bytes;
    PdfBook::State book([&](std::string_view piece) { bytes += piece; }, drawing.metadata);
    book.add_page(drawing, PdfInstances::paths);
    book.finish();
    return bytes;
}

}  // namespace edaha
