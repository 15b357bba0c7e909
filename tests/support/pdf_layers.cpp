// SPDX-License-Identifier: MIT
#include "support/pdf_layers.h"

#include <stdexcept>

#define POINTERHOLDER_TRANSITION 4  // only std::shared_ptr, no warning of the older type
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFWriter.hh>

namespace edaha::test {
namespace {

// Reads from `bytes` as long as it lives.
void open(QPDF& pdf, const std::string& bytes) {
    pdf.processMemoryFile("test", bytes.data(), bytes.size());
}

QPDFObjectHandle shown_layers(QPDF& pdf) {
    return pdf.getRoot().getKey("/OCProperties").getKey("/D");
}

}  // namespace

std::vector<std::string> pdf_layers(const std::string& pdf_bytes) {
    QPDF pdf;
    open(pdf, pdf_bytes);
    std::vector<std::string> names;
    for (auto& group : shown_layers(pdf).getKey("/Order").getArrayAsVector()) {
        names.push_back(group.getKey("/Name").getUTF8Value());
    }
    if (pdf.anyWarnings()) throw std::runtime_error("qpdf has doubts about the file");
    return names;
}

std::string with_layer_off(const std::string& pdf_bytes, std::size_t index) {
    QPDF pdf;
    open(pdf, pdf_bytes);
    auto shown = shown_layers(pdf);
    const auto layer = shown.getKey("/Order").getArrayItem(static_cast<int>(index));
    shown.replaceKey("/OFF", QPDFObjectHandle::newArray({layer}));
    QPDFWriter writer(pdf);
    writer.setOutputMemory();
    writer.write();
    const auto buffer = writer.getBufferSharedPointer();
    return {reinterpret_cast<const char*>(buffer->getBuffer()), buffer->getSize()};
}

}  // namespace edaha::test
