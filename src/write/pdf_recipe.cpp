// SPDX-License-Identifier: MIT
#include "write/pdf_recipe.h"

#define POINTERHOLDER_TRANSITION 4  // only std::shared_ptr, no warning of the older type
#include <qpdf/QPDF.hh>

namespace edaha {

std::string pdf_recipe(std::string_view pdf) {
    QPDF document;
    document.setSuppressWarnings(true);
    document.setAttemptRecovery(false);  // half a file has none
    try {
        document.processMemoryFile("pdf", pdf.data(), pdf.size());
        QPDFObjectHandle information = document.getTrailer().getKey("/Info");
        if (!information.isDictionary() || !information.hasKey(kPdfRecipeKey)) return "";
        return information.getKey(kPdfRecipeKey).getUTF8Value();
    } catch (const QPDFExc&) {
        return "";
    }
}

}  // namespace edaha
