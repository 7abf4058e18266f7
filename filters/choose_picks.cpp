// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/choose_picks.h"

#include "bspline_curve/error.h"
#include "filters/utf8_path.h"

#include <string>
#include <vector>

namespace bspline_curve {

namespace {

[[noreturn]] void refusePicks(const std::string& message) {
    throw InputError(InputErrorCode::TooFewPicks, message);
}

std::vector<Vec3> picksOf(const PicksLayer& layer) {
    if (layer.hasFaces) {
        refusePicks(
            "picks_layer: layer \"" + layer.label +
            "\" has faces; a layer of picks has points only, in the order of the curve"
        );
    }
    return layer.points;
}

/// Whether there is a layer of picks that was left as the host offers it, where another surface was
/// chosen and the picks come from elsewhere.
bool isLeftOver(const CurveRequest& request, const PickCandidates& candidates) {
    const bool hasOthers =
        !request.picksText.empty() || !request.picksFile.empty() || !candidates.tool.empty();
    const std::optional<PicksLayer>& layer = candidates.layer;
    return hasOthers && layer.has_value() && layer->hasFaces && layer->isOffered;
}

/// The names of the parameters that give picks.
std::vector<std::string> sourcesNamed(
    const CurveRequest& request, const PickCandidates& candidates
) {
    std::vector<std::string> sources;
    if (!request.picksText.empty()) {
        sources.emplace_back("picks");
    }
    if (!request.picksFile.empty()) {
        sources.emplace_back("picks_file");
    }
    if (candidates.layer) {
        sources.emplace_back("picks_layer");
    }
    return sources;
}

}  // namespace

PicksFile choosePicks(const CurveRequest& request, PickCandidates candidates) {
    if (isLeftOver(request, candidates)) {
        candidates.layer.reset();
    }
    const std::vector<std::string> sources = sourcesNamed(request, candidates);
    if (sources.size() > 1) {
        std::string names = sources.front();
        for (std::size_t i = 1; i < sources.size(); ++i) {
            names += " and " + sources[i];
        }
        refusePicks("picks come from more than one option: " + names + "; use one of them");
    }
    if (!request.picksText.empty()) {
        return {.picks = parsePicksText(request.picksText), .closed = {}};
    }
    if (!request.picksFile.empty()) {
        return readPicks(utf8Path(request.picksFile));
    }
    if (candidates.layer) {
        return {.picks = picksOf(*candidates.layer), .closed = {}};
    }
    if (candidates.tool.empty()) {
        refusePicks(
            "no picks: pick points on the surface with Edit > PickPoints, or give one of the "
            "options "
            "picks, picks_file and picks_layer"
        );
    }
    return {.picks = candidates.tool, .closed = {}};
}

}  // namespace bspline_curve
