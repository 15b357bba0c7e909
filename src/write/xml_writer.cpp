// SPDX-License-Identifier: MIT
#include "write/xml_writer.h"

#include <cassert>

#include "write/xml_text.h"

namespace edaha {
namespace {

// What an AtomicFile takes without a copy.
constexpr std::size_t kBufferBytes = 1 << 16;

}  // namespace

XmlWriter::XmlWriter(const Sink& sink, bool compact)
    : sink_(sink), compact_(compact), buffer_(kBufferBytes) {}

inline void XmlWriter::put(std::string_view bytes) {
    if (bytes.size() >= kBufferBytes - used_) return put_split(bytes);
    used_ += bytes.copy(buffer_.data() + used_, bytes.size());
}

inline void XmlWriter::put(char byte) {
    buffer_[used_++] = byte;
    if (used_ == kBufferBytes) send();
}

// Every piece but the last is of the same size.
void XmlWriter::put_split(std::string_view bytes) {
    while (!bytes.empty()) {
        const std::size_t size = bytes.copy(buffer_.data() + used_, kBufferBytes - used_);
        used_ += size;
        bytes.remove_prefix(size);
        if (used_ == kBufferBytes) send();
    }
}

void XmlWriter::send() {
    if (used_ == 0) return;
    sink_(std::string_view(buffer_.data(), used_));
    sent_ += used_;
    used_ = 0;
}

inline void XmlWriter::end_start_tag() {
    assert(!holds_text_);
    if (!in_start_tag_) return;
    put('>');
    end_line();
    in_start_tag_ = false;
}

inline void XmlWriter::indent() {
    for (std::size_t left = compact_ ? 0 : names_.size(); left > 0; --left)
        put(' ');
}

inline void XmlWriter::end_line() {
    if (!compact_) put('\n');
}

void XmlWriter::declare() {
    put(R"(<?xml version="1.0" encoding="UTF-8"?>)");
    end_line();
}

void XmlWriter::open(std::string_view name, std::string_view attributes) {
    end_start_tag();
    indent();
    put('<');
    put(name);
    put(attributes);
    names_.push_back(name);
    in_start_tag_ = true;
}

void XmlWriter::attribute(std::string_view name, std::string_view value) {
    escaped_.clear();
    append_xml(escaped_, value, XmlPlace::attribute);
    plain_attribute(name, escaped_);
}

void XmlWriter::plain_attribute(std::string_view name, std::string_view value) {
    assert(in_start_tag_);
    put(' ');
    put(name);
    put("=\"");
    put(value);
    put('"');
}

void XmlWriter::text(std::string_view text) {
    assert(in_start_tag_);
    escaped_.clear();
    append_xml(escaped_, text, XmlPlace::text);
    put('>');
    put(escaped_);
    in_start_tag_ = false;
    holds_text_ = true;
}

void XmlWriter::close() {
    assert(!names_.empty());
    const std::string_view name = names_.back();
    names_.pop_back();
    if (in_start_tag_) {
        put(compact_ ? "/>" : " />");
    } else {
        if (!holds_text_) indent();
        put("</");
        put(name);
        put('>');
    }
    in_start_tag_ = holds_text_ = false;
    end_line();
}

void XmlWriter::text_element(std::string_view name, std::string_view content) {
    if (content.empty()) return;
    open(name);
    text(content);
    close();
}

std::size_t XmlWriter::finish() {
    assert(names_.empty());
    send();
    return sent_;
}

}  // namespace edaha
