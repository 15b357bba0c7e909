// SPDX-License-Identifier: MIT
#include "write/pdf.h"

#include "write/canvas.h"
#include "write/layered_pdf.h"

namespace edaha {

std::string pdf_bytes(const Drawing& drawing) {
    constexpr double kPointsPerMm = 72 / 25.4;
    const Metadata& metadata = drawing.metadata;
    LayeredPdf document;
    document.width_pt = drawing.width_mm * kPointsPerMm;
    document.height_pt = drawing.height_mm * kPointsPerMm;
    document.title = metadata.title;
    document.subject = metadata.description;
    document.keywords = metadata.command;
    document.recipe = metadata.recipe;
    document.creator = metadata.version.empty() ? "edaha" : "edaha " + metadata.version;
    for (const Layer& layer : drawing.layers) {
        Canvas canvas(Canvas::Kind::pdf, document.width_pt, document.height_pt);
        canvas.draw(drawing, layer, kPointsPerMm);
        document.layers.push_back({layer.label, canvas.finish()});
    }
    return join_layers(document);
}

}  // namespace edaha
