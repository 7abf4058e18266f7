// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/error_messages.h"
#include "web/core/calls.h"

#include <array>
#include <exception>
#include <new>
#include <utility>

namespace bspline_curve::web {

namespace {

// As Python names them.
constexpr std::array kCodeNames{
    std::pair(InputErrorCode::EmptyMesh, "empty-mesh"),
    std::pair(InputErrorCode::NonFiniteCoordinate, "non-finite-coordinate"),
    std::pair(InputErrorCode::IndexOutOfRange, "index-out-of-range"),
    std::pair(InputErrorCode::DegenerateFace, "degenerate-face"),
    std::pair(InputErrorCode::NonManifoldEdge, "non-manifold-edge"),
    std::pair(InputErrorCode::NonManifoldVertex, "non-manifold-vertex"),
    std::pair(InputErrorCode::InconsistentOrientation, "inconsistent-orientation"),
    std::pair(InputErrorCode::SelfIntersection, "self-intersection"),
    std::pair(InputErrorCode::TooFewPicks, "too-few-picks"),
    std::pair(InputErrorCode::PickTooFar, "pick-too-far"),
    std::pair(InputErrorCode::CoincidentPicks, "coincident-picks"),
    std::pair(InputErrorCode::PicksOnDifferentComponents, "picks-on-different-components"),
    std::pair(InputErrorCode::PickAvoided, "pick-avoided"),
    std::pair(InputErrorCode::NoPath, "no-path"),
    std::pair(InputErrorCode::BadField, "bad-field"),
    std::pair(InputErrorCode::BadOption, "bad-option"),
    std::pair(InputErrorCode::UnreadableFile, "unreadable-file"),
    std::pair(InputErrorCode::UnwritableFile, "unwritable-file"),
    std::pair(InputErrorCode::NoShell, "no-shell"),
};

constexpr RemedyWords kRemedyWords{
    .mend = "without the option strict the mesh is mended",
    .weld = "opened with the option weld of %, its components are joined"
};

std::string nameOfCode(InputErrorCode code) {
    for (const auto& [known, name] : kCodeNames) {
        if (code == known) {
            return name;
        }
    }
    return "input";
}

Json errorJson(std::string code, std::string message) {
    return {
        {"code", std::move(code)}, {"message", std::move(message)}, {"elements", Json::array()}
    };
}

}  // namespace

std::string messageOf(const std::string& message, const Remedy& remedy) {
    return withRemedy(message, remedy, kRemedyWords);
}

Json currentError() {
    try {
        throw;
    } catch (const InputError& error) {
        Json json = errorJson(nameOfCode(error.code()), messageOf(error.what(), error.remedy()));
        json["elements"] = error.elements();
        return json;
    } catch (const Cancelled&) {
        return errorJson("cancelled", "cancelled");
    } catch (const std::bad_alloc&) {
        return errorJson("memory", "there is not enough memory for this");
    } catch (const std::exception& error) {
        return errorJson("internal", error.what());
    }
}

}  // namespace bspline_curve::web
