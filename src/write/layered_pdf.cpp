// SPDX-License-Identifier: MIT
#include "write/layered_pdf.h"

#include <deque>

#define POINTERHOLDER_TRANSITION 4  // only std::shared_ptr, no warning of the older type
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include "base/number_text.h"
#include "write/xml_text.h"

namespace edaha {
namespace {

using Object = QPDFObjectHandle;

// Some programs want dates; any moment will do if it is always the same one.
constexpr const char* kDate = "D:20000101000000Z";

// A key of our own in the document's information: PDF 32000-1, 14.3.3.
constexpr const char* kRecipeKey = "/EdahaRecipe";

Object text_object(const std::string& text) {
    return Object::newUnicodeString(xml_safe(text));
}

class Assembly {
  public:
    explicit Assembly(const LayeredPdf& document) : document_(document) { pdf_.emptyPDF(); }

    std::string bytes();

  private:
    void add_layer(const PdfLayer& layer);
    Object form_of(const PdfLayer& layer);
    void add_page();
    void add_layer_list();
    void add_information();

    const LayeredPdf& document_;
    std::deque<QPDF> parts_;  // read from until all is written
    QPDF pdf_;
    std::vector<Object> groups_;  // bottom first
    Object forms_ = Object::newDictionary();
    Object properties_ = Object::newDictionary();
    std::string content_;
};

Object Assembly::form_of(const PdfLayer& layer) {
    QPDF& part = parts_.emplace_back();
    part.processMemoryFile("layer", layer.page_pdf.data(), layer.page_pdf.size());
    auto page = QPDFPageDocumentHelper(part).getAllPages().at(0);
    return pdf_.copyForeignObject(page.getFormXObjectForPage());
}

// 8.11.3.2: content between BDC and EMC belongs to the group that /OC names.
void Assembly::add_layer(const PdfLayer& layer) {
    const std::string number = std::to_string(groups_.size());
    Object group = Object::parse("<< /Type /OCG >>");
    group.replaceKey("/Name", text_object(layer.label));
    groups_.push_back(pdf_.makeIndirectObject(group));
    properties_.replaceKey("/Layer" + number, groups_.back());
    forms_.replaceKey("/Form" + number, form_of(layer));
    content_ += "/OC /Layer" + number + " BDC\n/Form" + number + " Do\nEMC\n";
}

void Assembly::add_page() {
    // Rounded down: readers count a pixel more for the least bit above a whole number of them.
    const auto side = [](double points) { return number_text(points - 0.5e-4, 4); };
    const std::string size = side(document_.width_pt) + ' ' + side(document_.height_pt);
    Object page = Object::parse("<< /Type /Page /MediaBox [0 0 " + size +
                                "] /Resources << >> /Group << /Type /Group /S /Transparency "
                                "/I true /CS /DeviceRGB >> >>");
    page.getKey("/Resources").replaceKey("/XObject", forms_);
    page.getKey("/Resources").replaceKey("/Properties", properties_);
    page.replaceKey("/Contents", Object::newStream(&pdf_, content_));
    QPDFPageDocumentHelper(pdf_).addPage(pdf_.makeIndirectObject(page), false);
}

void Assembly::add_layer_list() {
    if (groups_.empty()) return;
    const std::vector<Object> top_first(groups_.rbegin(), groups_.rend());
    Object shown = Object::parse("<< /Name (Layers) >>");
    shown.replaceKey("/Order", Object::newArray(top_first));
    shown.replaceKey("/ON", Object::newArray(top_first));
    Object list = Object::newDictionary();
    list.replaceKey("/OCGs", Object::newArray(top_first));
    list.replaceKey("/D", shown);
    pdf_.getRoot().replaceKey("/OCProperties", list);
}

void Assembly::add_information() {
    Object information = Object::newDictionary();
    const auto add = [&](const char* key, const std::string& text) {
        if (!text.empty()) information.replaceKey(key, text_object(text));
    };
    add("/Title", document_.title);
    add("/Subject", document_.subject);
    add("/Keywords", document_.keywords);
    add("/Creator", document_.creator);
    add(kRecipeKey, document_.recipe);
    information.replaceKey("/CreationDate", Object::newString(kDate));
    information.replaceKey("/ModDate", Object::newString(kDate));
    pdf_.getTrailer().replaceKey("/Info", pdf_.makeIndirectObject(information));
}

std::string Assembly::bytes() {
    for (const PdfLayer& layer : document_.layers)
        add_layer(layer);
    add_page();
    add_layer_list();
    add_information();
    QPDFWriter writer(pdf_);
    writer.setOutputMemory();
    writer.setDeterministicID(true);
    writer.setMinimumPDFVersion("1.5");  // layers
    writer.setObjectStreamMode(qpdf_o_generate);
    writer.write();
    const auto buffer = writer.getBufferSharedPointer();
    return {reinterpret_cast<const char*>(buffer->getBuffer()), buffer->getSize()};
}

}  // namespace

std::string join_layers(const LayeredPdf& document) {
    return Assembly(document).bytes();
}

std::string pdf_recipe(std::string_view pdf) {
    QPDF document;
    document.setSuppressWarnings(true);
    try {
        document.processMemoryFile("pdf", pdf.data(), pdf.size());
        Object information = document.getTrailer().getKey("/Info");
        if (!information.isDictionary() || !information.hasKey(kRecipeKey)) return "";
        return information.getKey(kRecipeKey).getUTF8Value();
    } catch (const QPDFExc&) {
        return "";
    }
}

}  // namespace edaha
