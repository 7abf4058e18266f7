// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/xml_tree.h"
#include "text/text_parsing.h"

namespace bspline_curve {

DrawingFile readDrawing(const std::filesystem::path& file, const std::vector<std::string>& layers) {
    const std::string extension = lowerCaseExtension(file);
    if (extension != ".svg" && extension != ".dxf") {
        refuseFile(file, "drawings are read from .svg and .dxf; save the drawing as one of these");
    }
    if (extension != ".dxf" && !layers.empty()) {
        refuseFile(file, "layers are chosen in .dxf alone");
    }
    const std::string bytes = readWholeFile(file);
    DrawingFile result = extension == ".dxf" ? drawingOfDxf(file, bytes, layers)
                                             : drawingOfSvg(file, xmlTreeOf(file, bytes));
    if (result.drawing.paths.empty()) {
        refuseFile(
            file,
            "has no path that is longer than 0; turn shapes and text into paths in your drawing "
            "program"
        );
    }
    return result;
}

}  // namespace bspline_curve
