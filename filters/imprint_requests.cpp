// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/imprint_requests.h"

#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "filters/binding_makers.h"
#include "filters/requests.h"

#include <cmath>

namespace bspline_curve {

Bindings<CurveUse> useBindings() {
    return {
        bound("surface_layer", &CurveUse::surface),
        bound("curve_layer", &CurveUse::curve),
    };
}

Bindings<Placing> placingBindings() {
    return {
        bound("max_distance", &Placing::distance),
        bound("project_curves", &Placing::project),
    };
}

Bindings<ImprintOptions> imprintBindings() {
    return {bound("snap", &ImprintOptions::snap)};
}

Bindings<CutWords> cutBindings() {
    using C = CutWords;
    return {
        chosen(
            "keep",
            &C::keep,
            Names<KeptParts>{
                {"all", KeptParts::All},
                {"largest", KeptParts::Largest},
                {"smallest", KeptParts::Smallest},
                {"inside", KeptParts::Inside},
                {"outside", KeptParts::Outside},
                {"seed", KeptParts::Seeds}
            }
        ),
        bound("seed", &C::seed),
        bound("drop_untouched", &C::dropUntouched),
        chosen(
            "fill",
            &C::fill,
            Names<FillKind>{
                {"none", FillKind::None}, {"flat", FillKind::Flat}, {"smooth", FillKind::Smooth}
            }
        ),
        bound("split", &C::split),
        bound("relief", &C::relief),
    };
}

Bindings<SegmentRequest> segmentBindings() {
    return {bound("split", &SegmentRequest::split)};
}

Bindings<OffsetOptions> offsetBindings() {
    return {
        bound("offset", &OffsetOptions::distance),
        chosen(
            "side",
            &OffsetOptions::sides,
            Names<OffsetSides>{
                {"both", OffsetSides::Both},
                {"left", OffsetSides::Left},
                {"right", OffsetSides::Right}
            }
        ),
    };
}

Bindings<OffsetRequest> bandBindings() {
    return {bound("select_band", &OffsetRequest::selectBand)};
}

CurveUse curveUse(const ParameterValues& values) {
    CurveUse use;
    readAll(values, useBindings(), use);
    readAll(values, placingBindings(), use.placing);
    checkLength("max_distance", use.placing.distance);
    use.mending = mendingOptions(values);
    return use;
}

void refuseChoice(const std::string& message) {
    throw InputError(InputErrorCode::BadOption, message);
}

ImprintRequest imprintRequest(const ParameterValues& values) {
    ImprintRequest request{.use = curveUse(values), .imprint = {}};
    readAll(values, imprintBindings(), request.imprint);
    request.imprint.validate();
    return request;
}

CutRequest cutRequest(const ParameterValues& values) {
    CutRequest request{.imprint = imprintRequest(values), .words = {}};
    const CutWords& choice = request.words;
    readAll(values, cutBindings(), request.words);
    if (choice.keep == KeptParts::All && choice.fill != FillKind::None) {
        refuseChoice(
            "the option fill needs the option keep: with all parts there is no hole to fill"
        );
    }
    if (!std::isfinite(choice.relief)) {
        refuseChoice("relief must be finite");
    }
    if (choice.relief != 0.0 && choice.keep == KeptParts::All) {
        refuseChoice("the option relief needs the option keep: which parts are meant");
    }
    if (choice.relief != 0.0 && choice.fill != FillKind::None) {
        refuseChoice("with relief the whole surface is kept, so there is no hole to fill");
    }
    return request;
}

SegmentRequest segmentRequest(const ParameterValues& values) {
    SegmentRequest request{.imprint = imprintRequest(values)};
    readAll(values, segmentBindings(), request);
    return request;
}

OffsetRequest offsetRequest(const ParameterValues& values) {
    OffsetRequest request{.use = curveUse(values), .offset = {}};
    readAll(values, offsetBindings(), request.offset);
    readAll(values, bandBindings(), request);
    checkLength("offset", request.offset.distance);
    return request;
}

namespace {

/// The parts that are kept, none: all.
std::optional<PartChoice> partChoice(const CutWords& words, const std::vector<Vec3>& toolPoints) {
    using Which = PartChoice::Which;
    PartChoice choice;
    choice.dropUntouched = words.dropUntouched;
    switch (words.keep) {
        case KeptParts::All:
            return std::nullopt;
        case KeptParts::Largest:
            choice.which = Which::Largest;
            return choice;
        case KeptParts::Smallest:
            choice.which = Which::Smallest;
            return choice;
        case KeptParts::Inside:
            choice.which = Which::Inside;
            return choice;
        case KeptParts::Outside:
            choice.which = Which::Outside;
            return choice;
        case KeptParts::Seeds:
            break;
    }
    choice.which = Which::Seeds;
    choice.seeds = words.seed.empty() ? toolPoints : parsePicksText(words.seed);
    if (choice.seeds.empty()) {
        refuseChoice(
            "keep is \"seed\", but there is no point: give points by the option seed, as \"x y z; "
            "x y z\", or pick them on the surface with Edit > PickPoints"
        );
    }
    return choice;
}

}  // namespace

CutChoice cutChoice(const CutWords& words, const std::vector<Vec3>& toolPoints) {
    CutChoice choice{
        .keep = partChoice(words, toolPoints),
        .split = words.split,
        .fill = std::nullopt,
        .relief = words.relief
    };
    if (words.fill != FillKind::None) {
        choice.fill = words.fill == FillKind::Flat ? FillShape::Flat : FillShape::Smooth;
    }
    return choice;
}

}  // namespace bspline_curve
