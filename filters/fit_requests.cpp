// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/fit_requests.h"

#include "filters/binding_makers.h"

namespace bspline_curve {

Bindings<FitRequest> fitBindings() {
    return {
        bound("surface_layer", &FitRequest::surface),
        chosen(
            "boundaries",
            &FitRequest::labels,
            Names<FaceLabels>{
                {"selected-faces", FaceLabels::Selection},
                {"face-quality", FaceLabels::FaceQuality},
                {"face-colour", FaceLabels::FaceColour},
                {"vertex-quality", FaceLabels::VertexQuality}
            }
        ),
    };
}

Bindings<FitOptions> fitOptionBindings() {
    return {
        boundLength("deviation", &FitOptions::deviation),
        bound("corner_angle", &FitOptions::cornerAngle)
    };
}

const std::vector<std::string>& fittedParameters() {
    static const std::vector<std::string> ids = {
        "degree",
        "tension",
        "samples",
        "max_segment_length",
        "distance_tolerance",
        "strict",
        "weld",
        "slits"
    };
    return ids;
}

FitRequest fitRequest(const ParameterValues& values) {
    FitRequest request;
    readAll(values, fitBindings(), request);
    readAll(values, fitOptionBindings(), request.fit);
    request.fit.validate();
    ParameterValues ofCurve(curveFilter());
    ofCurve.set("surface_layer", request.surface);
    ofCurve.set("field", std::string(kNoField));
    for (const std::string& id : fittedParameters()) {
        ofCurve.set(id, values.value(id));
    }
    request.curve = curveRequest(ofCurve);
    return request;
}

}  // namespace bspline_curve
