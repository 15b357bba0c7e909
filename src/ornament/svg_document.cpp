// SPDX-License-Identifier: MIT
#include "ornament/svg_document.h"

#include <fmt/format.h>

#include "ornament/report.h"
#include "ornament/scan.h"

namespace edaha::svg {
namespace {

std::string explain(pugi::xml_parse_status status) {
    switch (status) {
        case pugi::status_no_document_element:
            return "there is no element (expected <svg>)";
        case pugi::status_unrecognized_tag:
            return "this is not a tag";
        case pugi::status_bad_pi:
            return "this <? is not closed by ?>";
        case pugi::status_bad_comment:
            return "this comment is not closed by -->";
        case pugi::status_bad_cdata:
            return "this CDATA is not closed by ]]>";
        case pugi::status_bad_doctype:
            return "this DOCTYPE is not closed by >";
        case pugi::status_bad_pcdata:
            return "text is not followed by a tag";
        case pugi::status_bad_start_element:
            return "this start tag is not closed by >";
        case pugi::status_bad_end_element:
            return "this end tag is not closed by >";
        case pugi::status_bad_attribute:
            return "this attribute is not name=\"value\"";
        default:
            return "cannot be read";
    }
}

// pugixml's offset is where the names begin to differ, or the end.
[[noreturn]] void refuse_mismatch(std::string_view text, std::size_t offset, Report& report) {
    const std::size_t tag = text.rfind("</", offset);
    const bool is_in_tag = tag != std::string_view::npos &&
                           text.substr(tag, offset - tag).find('>') == std::string_view::npos;
    if (!is_in_tag) {
        report.fail({text.size(), {}, false, 0}, "XML: the file ends, but not all its elements do");
    }
    Scanner scanner(text.substr(tag + 2));
    const std::string name(trimmed(scanner.take_until('>')));
    report.fail({tag, {}, false, 0},
                "XML: " + quoted("</" + name + ">") + " does not end the element that is open");
}

bool is_latin1(std::string_view text) {
    if (!text.starts_with("<?xml")) return false;
    const std::string head = lower_case(text.substr(0, text.find("?>")));
    return head.find("iso-8859-1") != std::string::npos ||
           head.find("windows-1252") != std::string::npos;
}

}  // namespace

std::string utf8_text(std::string_view text) {
    if (!is_latin1(text)) return std::string(text);
    std::string utf8;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x80U) {
            utf8 += c;
        } else {
            utf8 += static_cast<char>(0xC0U | (code >> 6U));
            utf8 += static_cast<char>(0x80U | (code & 0x3FU));
        }
    }
    return utf8;
}

SvgDocument::SvgDocument(std::string_view text, Report& report) {
    const auto refuse_if = [&](bool wrong, std::size_t offset, const std::string& message) {
        if (wrong) report.fail({offset, {}, false, 0}, message);
    };
    refuse_if(text.size() > kMostBytes, 0,
              fmt::format("the file has {} bytes (expected at most {})", text.size(), kMostBytes));
    refuse_if(text.find('\0') != std::string_view::npos, 0,
              "the file is not text in UTF-8 (there are zero bytes in it)");
    // Entities of a DTD are never resolved: pugixml knows the five of XML and numbers only.
    const pugi::xml_parse_result parsed =
        document_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
    const auto fault = static_cast<std::size_t>(parsed.offset);
    if (parsed.status == pugi::status_end_element_mismatch) refuse_mismatch(text, fault, report);
    refuse_if(!parsed, fault, "XML: " + explain(parsed.status));
    const std::string_view name = root().name();
    const std::size_t colon = name.rfind(':');
    prefix_ = colon == std::string_view::npos ? "svg:" : std::string(name.substr(0, colon + 1));
    refuse_if(element(root()) != "svg", offset_of(root()),
              quoted(name) + " is not an SVG drawing (expected <svg>)");
    index_elements(report);
}

std::string_view SvgDocument::element(pugi::xml_node node) const {
    const std::string_view name = node.name();
    if (name.starts_with(prefix_)) return name.substr(prefix_.size());
    return name.find(':') == std::string_view::npos ? name : std::string_view();
}

pugi::xml_node SvgDocument::find(std::string_view id) const {
    const auto found = by_id_.find(id);
    return found == by_id_.end() ? pugi::xml_node() : found->second;
}

std::vector<std::string> SvgDocument::ids() const {
    std::vector<std::string> all;
    for (const auto& [id, node] : by_id_)
        all.push_back(id);
    return all;
}

// Walks without recursion: it is what finds out whether the file is too deep for that.
void SvgDocument::index_elements(Report& report) {
    int depth = 1;
    for (pugi::xml_node node = root(); node;) {
        if (depth > kDeepest) {
            report.fail({offset_of(node), {}, false, 0},
                        fmt::format("{} is nested {} deep (expected at most {})",
                                    quoted(node.name()), depth, kDeepest));
        }
        if (const std::string_view id = node.attribute("id").value(); !id.empty()) {
            by_id_.emplace(id, node);
        }
        if (element(node) == "style") sheets_.push_back(node);
        if (element(node) == "script") scripts_.push_back(node);
        if (node.first_child()) {
            node = node.first_child();
            ++depth;
            continue;
        }
        while (node != root() && !node.next_sibling()) {
            node = node.parent();
            --depth;
        }
        node = node == root() ? pugi::xml_node() : node.next_sibling();
    }
}

}  // namespace edaha::svg
