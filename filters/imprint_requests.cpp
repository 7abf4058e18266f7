// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/imprint_requests.h"

#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "filters/binding_makers.h"
#include "filters/requests.h"
#include "text/text_parsing.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
        bound("direction", &Placing::direction),
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
        chosen(
            "profile",
            &C::profile,
            Names<ReliefProfile>{
                {"step", ReliefProfile::Step},
                {"ramp", ReliefProfile::Ramp},
                {"round", ReliefProfile::Round}
            }
        ),
        bound("profile_width", &C::profileWidth),
        bound("stroke", &C::stroke),
        bound("thickness", &C::thickness),
        bound("base", &C::base),
        bound("base_direction", &C::baseDirection),
        bound("base_height", &C::baseHeight),
    };
}

Bindings<FillRequest> fillBindings() {
    using F = FillRequest;
    return {
        chosen(
            "shape",
            &F::shape,
            Names<FillShape>{{"smooth", FillShape::Smooth}, {"flat", FillShape::Flat}}
        ),
        bound("max_length", &F::mostLength),
        bound("max_edges", &F::mostEdges),
        bound("seed", &F::seed),
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

Bindings<PointsRequest> pointsBindings() {
    using R = PointsRequest;
    return {
        bound("count", &R::count), bound("distances", &R::distances), bound("at_picks", &R::atPicks)
    };
}

CurveUse curveUse(const ParameterValues& values) {
    CurveUse use;
    readAll(values, useBindings(), use);
    readAll(values, placingBindings(), use.placing);
    checkLength("max_distance", use.placing.distance);
    static_cast<void>(use.placing.projection());
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

namespace {

/// The base that is meant, if one is.
std::optional<PartBase> baseOf(const CutWords& words) {
    if (!words.isBased()) {
        return std::nullopt;
    }
    PartBase base{.length = words.base, .direction = std::nullopt, .height = std::nullopt};
    if (!words.baseDirection.empty()) {
        base.direction = parseDirection(words.baseDirection, "base_direction");
        if (words.base == 0.0) {
            base.height = words.baseHeight;
        }
    }
    return base;
}

/// Of walls and bases.
void checkSolid(const CutWords& words) {
    const bool isThick = words.thickness != 0.0;
    if (!isThick && !words.isBased()) {
        return;
    }
    checkLength("base", words.base);
    if (!std::isfinite(words.thickness) || !std::isfinite(words.baseHeight)) {
        refuseChoice("thickness and base_height must be finite");
    }
    if (words.keep == KeptParts::All && !words.split) {
        refuseChoice(
            "the options thickness and base need the option keep or split: which parts are meant"
        );
    }
    if ((isThick && words.isBased()) || words.relief != 0.0 || words.fill != FillKind::None) {
        refuseChoice("the options thickness, base, fill and relief exclude each other");
    }
    static_cast<void>(baseOf(words));
}

}  // namespace

CutRequest cutRequest(const ParameterValues& values) {
    CutRequest request{.imprint = imprintRequest(values), .words = {}};
    CutWords& choice = request.words;
    readAll(values, cutBindings(), choice);
    if (choice.stroke != 0.0 && choice.relief != 0.0 && choice.keep == KeptParts::All) {
        choice.keep = KeptParts::Inside;  // a slot, or a ridge
    }
    if (choice.keep == KeptParts::All && !choice.split && choice.fill != FillKind::None) {
        refuseChoice(
            "the option fill needs the option keep or split: with all parts in one mesh there is "
            "no hole to fill"
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
    checkLength("profile_width", choice.profileWidth);
    if (choice.relief == 0.0 &&
        (choice.profile != ReliefProfile::Step || choice.profileWidth != 0.0)) {
        refuseChoice("the options profile and profile_width need the option relief");
    }
    checkLength("stroke", choice.stroke);
    checkSolid(choice);
    return request;
}

HoleChoice FillRequest::choice() const {
    HoleChoice result;
    if (mostLength > 0.0) {
        result.mostLength = mostLength;
    }
    if (mostEdges > 0) {
        result.mostEdges = mostEdges;
    }
    if (!seed.empty()) {
        const std::vector<Vec3> points = parsePicksText(seed);
        if (points.size() != 1) {
            refuseChoice("seed must be one point, as \"x y z\"");
        }
        result.seed = points.front();
    }
    return result;
}

FillRequest fillRequest(const ParameterValues& values) {
    FillRequest request;
    request.use.surface = values.get<LayerId>("surface_layer");
    request.use.mending = mendingOptions(values);
    readAll(values, fillBindings(), request);
    checkLength("max_length", request.mostLength);
    if (request.mostEdges < 0) {
        refuseChoice(
            "max_edges is " + std::to_string(request.mostEdges) + ", but must not be negative"
        );
    }
    static_cast<void>(request.choice());
    return request;
}

SegmentRequest segmentRequest(const ParameterValues& values) {
    SegmentRequest request{.imprint = imprintRequest(values)};
    readAll(values, segmentBindings(), request);
    return request;
}

PointsRequest pointsRequest(const ParameterValues& values) {
    PointsRequest request{.use = curveUse(values)};
    readAll(values, pointsBindings(), request);
    const auto most = static_cast<int>(values.filter().parameter("count").max.value_or(0.0));
    if (request.count < 1 || request.count > most) {
        refuseChoice(
            "count is " + std::to_string(request.count) + ", but must be in [1, " +
            std::to_string(most) + "]"
        );
    }
    if (request.atPicks && !request.distances.empty()) {
        refuseChoice("the options distances and at_picks exclude each other");
    }
    static_cast<void>(parseDistances(request.distances));
    return request;
}

std::vector<double> parseDistances(const std::string& text) {
    std::vector<double> distances;
    if (trimmed(text).empty()) {
        return distances;
    }
    for (const std::string_view word : splitAt(text, ',')) {
        const std::optional<double> distance = parseNumber(word);
        if (!distance || !std::isfinite(*distance)) {
            refuseChoice(
                "distances has " + inQuotes(word) + ", but must be numbers with commas between them"
            );
        }
        distances.push_back(*distance);
    }
    return distances;
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
        .relief = words.relief,
        .profile = words.profile,
        .profileWidth = words.profileWidth,
        .thickness = words.thickness,
        .base = baseOf(words)
    };
    if (words.fill != FillKind::None) {
        choice.fill = words.fill == FillKind::Flat ? FillShape::Flat : FillShape::Smooth;
    }
    return choice;
}

}  // namespace bspline_curve
