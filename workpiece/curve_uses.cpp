// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/imprint.h"
#include "bspline_curve/offset.h"
#include "bspline_curve/parts.h"
#include "bspline_curve/progress.h"
#include "fill/based_parts.h"
#include "fill/capped_parts.h"
#include "fill/mesh_holes.h"
#include "fill/part_filling.h"
#include "fill/raised_parts.h"
#include "fill/thick_parts.h"
#include "fill/unjoined_parts.h"
#include "imprint/imprint.h"
#include "imprint/mesh_parts.h"
#include "imprint/part_choice.h"
#include "imprint/slits.h"
#include "imprint/unjoined_imprint.h"
#include "offset/offset_curves.h"
#include "shell/extended_surface.h"
#include "surface/lines_over_parted_edges.h"
#include "text/error_messages.h"
#include "utility/index_sets.h"
#include "utility/stopwatch.h"
#include "workpiece/imprint_source.h"
#include "workpiece/relief_profile.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

// Shares of the work, for progress only.
constexpr double kImprintedShare = 0.6;
constexpr double kExtendedShare = 0.1;
constexpr double kProfiledShare = 0.7;
/// Of closing all parts, until both sides of cuts have the same patches.
constexpr double kCappedShare = 0.7;
constexpr double kLinesShare = 0.8;     // of an offset, without its band
constexpr std::size_t kMostNamed = 10;  // faces, in a note

/// `count`: how many there are of what.
std::string namedFaces(const std::string& count, const std::vector<int>& faces) {
    std::string named;
    for (std::size_t i = 0; i < std::min(faces.size(), kMostNamed); ++i) {
        named += (i > 0 ? ", " : "") + std::to_string(faces[i]);
    }
    return count + named + (faces.size() > kMostNamed ? ", ..." : "");
}

std::string crossingNote(const std::vector<int>& faces) {
    return namedFaces(
        describeCount(faces.size(), "new face crosses", "new faces cross") +
            " others, since the rim allows no fill that does not: ",
        faces
    );
}

/// Of a solid that is no fill.
std::string solidCrossingNote(const std::vector<int>& faces, const std::string& remedy) {
    return namedFaces(
               describeCount(faces.size(), "face crosses", "faces cross") + " others: ", faces
           ) +
           "; " + remedy;
}

/// Of a wall or relief that had to be less than was asked for.
std::string lessNote(int vertices, double least) {
    return " at " + describeCount(static_cast<std::size_t>(vertices), "vertex", "vertices") +
           ", at least " + describeNumber(least) + ", since there is no more room";
}

FilledParts thickParts(
    const Imprint& imprint,
    const std::vector<int>& chosen,
    double thickness,
    std::vector<std::string>& notes,
    const Progress& progress
) {
    ThickParts thick = thickened(*imprint.joined, imprint.parts, chosen, thickness, progress);
    if (!thick.solid.crossing.empty()) {
        notes.push_back(solidCrossingNote(thick.solid.crossing, "take a smaller thickness"));
    }
    if (thick.thinner > 0) {
        notes.push_back(
            "the wall is thinner than asked" +
            lessNote(thick.thinner, thick.least * std::abs(thickness))
        );
    }
    return std::move(thick.solid);
}

/// `shares`: of the height, see raisedParts().
FilledParts reliefOf(
    const Imprint& imprint,
    const std::vector<int>& chosen,
    double height,
    const std::vector<double>& shares,
    std::vector<std::string>& notes,
    const Progress& progress
) {
    RaisedParts raised =
        raisedParts(*imprint.joined, imprint.parts, chosen, height, shares, progress);
    if (!raised.whole.crossing.empty()) {
        notes.push_back(solidCrossingNote(raised.whole.crossing, "take a smaller height"));
    }
    if (raised.lower > 0) {
        notes.push_back(
            "the relief is lower than asked" +
            lessNote(raised.lower, raised.least * std::abs(height))
        );
    }
    return std::move(raised.whole);
}

void tellOfFill(const FilledParts& filled, std::vector<std::string>& notes) {
    if (filled.openRims > 0) {
        notes.push_back(
            describeCount(static_cast<std::size_t>(filled.openRims), "rim stays", "rims stay") +
            " open, since the boundary of the mesh is part of " +
            (filled.openRims == 1 ? "it" : "them")
        );
    }
    if (!filled.crossing.empty()) {
        notes.push_back(crossingNote(filled.crossing) + "; move the curve");
    }
}

/// The parts that one mesh gets; adds what to say of them.
FilledParts partsMeant(
    const Imprint& imprint,
    const CutMesh& cut,
    const CutChoice& choice,
    const std::vector<int>& chosen,
    std::vector<std::string>& notes,
    const Progress& progress
) {
    if (choice.thickness != 0.0) {
        return thickParts(imprint, chosen, choice.thickness, notes, progress);
    }
    if (choice.base) {
        FilledParts solid = based(*imprint.joined, imprint.parts, chosen, *choice.base);
        if (!solid.crossing.empty()) {
            notes.push_back(
                solidCrossingNote(solid.crossing, "move the curve, or give the base a direction")
            );
        }
        return solid;
    }
    if (choice.relief == 0.0) {
        FilledParts taken =
            takenParts(*imprint.joined, cut, imprint.parts, chosen, choice.fill, progress);
        tellOfFill(taken, notes);
        return taken;
    }
    return reliefOf(imprint, chosen, choice.relief, {}, notes, progress);
}

/// What to say of curves that part nothing, where `isCut` what a cut did there; or nothing.
std::vector<std::string> slitNotes(const Imprint& imprint, bool isCut) {
    std::string note = describeSlits(slitsOf(*imprint.joined, imprint.parts), isCut);
    return note.empty() ? std::vector<std::string>() : std::vector{std::move(note)};
}

/// The parts that are not kept, ascending.
std::vector<int> droppedParts(const Imprint& imprint, const std::vector<int>& kept) {
    return indicesWhere<int>(imprint.parts.parts.size(), [&](std::size_t part) {
        return !std::ranges::binary_search(kept, static_cast<int>(part));
    });
}

/// What to say of components that are dropped though no curve parts them; or nothing.
std::string untouchedNote(const Imprint& imprint, const std::vector<int>& dropped) {
    const std::vector<int> parted = partedParts(*imprint.joined, imprint.parts);
    const auto count = std::ranges::count_if(dropped, [&](int part) {
        return !std::ranges::binary_search(parted, part);
    });
    return count == 0 ? std::string()
                      : "dropped: " + describeCount(
                                          static_cast<std::size_t>(count),
                                          "component that no curve parts",
                                          "components that no curve parts"
                                      );
}

CutMeshes::Piece pieceOf(const Imprint& imprint, std::vector<int> parts, FilledParts taken) {
    if (imprint.mesh != imprint.joined) {
        taken = unjoined(taken, *imprint.joined, *imprint.mesh);
    }
    return {std::move(parts), MadeMesh(imprint, std::move(taken))};
}

/// With all parts.
CutMeshes::Piece wholePiece(const Imprint& imprint, FilledParts made) {
    std::vector<int> parts(imprint.parts.parts.size());
    std::iota(parts.begin(), parts.end(), 0);
    return pieceOf(imprint, std::move(parts), std::move(made));
}

}  // namespace

Imprint imprintOf(
    Imprint::Source source,
    std::span<const SurfacePolyline> lines,
    const ImprintOptions& options,
    const GoOn& goOn
) {
    Stopwatch watch;
    const Surface& surface = *source.surface;
    Imprint result;
    result.joined = std::make_shared<const ImprintedMesh>(imprint(surface, lines, options, goOn));
    result.mesh = surface.provenance().hasInputCorners()
                      ? std::make_shared<const ImprintedMesh>(unjoined(surface, *result.joined))
                      : result.joined;
    result.source = std::make_shared<const Imprint::Source>(std::move(source));
    result.seconds = watch.lap();
    return result;
}

Imprint imprintOn(
    const Workpiece& workpiece,
    std::span<const SurfacePolyline> lines,
    const ImprintOptions& options,
    const Progress& progress
) {
    const auto goOn = [&] { report(progress, 0.0, "imprinting"); };
    goOn();
    JoinedLines joined = joinedFor(workpiece.parts().surface, lines);
    goOn();
    Imprint result = imprintOf({.surface = std::move(joined.surface)}, joined.lines, options, goOn);
    result.parts =
        partsOf(*result.joined, [&] { report(progress, kImprintedShare, "finding parts"); });
    report(progress, 1.0, "finding parts");
    return result;
}

MadeMesh wholeMesh(const Imprint& imprint) {
    return {imprint, wholeImprint(*imprint.mesh, imprint.parts)};
}

namespace {

/// Where the whole mesh is to be closed after a cut along curves that part nothing; or nothing.
std::optional<CutMeshes> cutThroughHandles(
    const Imprint& imprint, const CutChoice& choice, const Progress& progress
) {
    const bool isMeant = choice.fill && choice.relief == 0.0 && choice.keep &&
                         choice.keep->which == PartChoice::Which::Largest &&
                         partedParts(*imprint.joined, imprint.parts).empty();
    std::optional<CappedParts> capped =
        isMeant ? cappedOnBothSides(*imprint.joined, imprint.parts, progress) : std::nullopt;
    if (!capped) {
        return std::nullopt;
    }
    FilledParts& whole = capped->whole;
    CutMeshes result;
    result.filledHoles = static_cast<int>(whole.rims.size());
    result.doubledVertices =
        static_cast<int>(whole.firstNew.front() - std::ssize(imprint.joined->mesh.vertices));
    tellOfFill(whole, result.notes);
    result.pieces.push_back(wholePiece(imprint, std::move(whole)));
    return result;
}

/// Parts that become solids, each by itself: flat patches are the same on both sides of a cut where
/// the rims there have the same edges, unless they cross something on one side.
std::vector<FilledParts> closedParts(
    const Imprint& imprint,
    const std::vector<std::vector<int>>& perMesh,
    FillShape shape,
    std::vector<std::string>& notes,
    const Progress& progress
) {
    const ImprintedMesh& joined = *imprint.joined;
    const std::optional<CappedParts> capped =
        shape == FillShape::Flat
            ? cappedOnBothSides(joined, imprint.parts, partOf(progress, 0.0, kCappedShare))
            : std::nullopt;
    const Progress further = partOf(progress, kCappedShare, 1.0);
    std::vector<FilledParts> closed;
    bool isAnyFilled = false;
    for (std::size_t i = 0; i < perMesh.size(); ++i) {
        const std::vector<int>& chosen = perMesh[i];
        report(
            further, static_cast<double>(i) / static_cast<double>(perMesh.size()), "taking parts"
        );
        const bool isCapped =
            capped &&
            std::ranges::includes(capped->edges, edgesAround(joined, imprint.parts, chosen));
        FilledParts part = isCapped ? cappedParts(*capped, chosen) : FilledParts{};
        if (!isCapped || !part.crossing.empty()) {
            FilledParts own = filledWherePossible(
                joined, imprint.parts, chosen, shape, stepOf(further, i, perMesh.size())
            );
            if (!isCapped || own.crossing.size() < part.crossing.size()) {
                part = std::move(own);
            }
        }
        closed.push_back(std::move(part));
        tellOfFill(closed.back(), notes);
        isAnyFilled = isAnyFilled || !closed.back().rims.empty();
    }
    if (!isAnyFilled) {
        refuseNothingToFill();
    }
    return closed;
}

/// The whole mesh with a relief that has a profile.
CutMeshes profiledRelief(
    const Imprint& imprint,
    const PartChoice& kept,
    const CutChoice& choice,
    const Progress& progress
) {
    std::vector<int> chosen = chosenParts(*imprint.joined, imprint.parts, kept);
    const ProfiledImprint profiled =
        profiledImprint(imprint, chosen, choice, partOf(progress, 0.0, kProfiledShare));
    CutMeshes result;
    FilledParts whole = reliefOf(
        profiled.imprint,
        chosen,
        choice.relief,
        profiled.shares,
        result.notes,
        partOf(progress, kProfiledShare, 1.0)
    );
    result.pieces.push_back(pieceOf(profiled.imprint, std::move(chosen), std::move(whole)));
    return result;
}

}  // namespace

CutMeshes cutOn(const Imprint& imprint, const CutChoice& choice, const Progress& progress) {
    if (choice.fill && !choice.keep && !choice.split) {
        throw InputError(
            InputErrorCode::BadOption,
            "holes are to be filled, but all parts are kept in one mesh, which leaves none: choose "
            "parts to keep, or split the mesh"
        );
    }
    if (choice.relief != 0.0 && choice.keep && choice.profile != ReliefProfile::Step) {
        return profiledRelief(imprint, *choice.keep, choice, progress);
    }
    if (std::optional<CutMeshes> cut = cutThroughHandles(imprint, choice, progress)) {
        return *std::move(cut);
    }
    const auto goOn = [&] { report(progress, 0.0, "cutting"); };
    goOn();
    const CutMesh cut = openedAlongCurves(*imprint.joined);
    goOn();
    CutMeshes result;
    result.doubledVertices =
        static_cast<int>(cut.mesh.vertices.size() - imprint.joined->mesh.vertices.size());
    std::vector<std::vector<int>> perMesh;
    if (choice.keep && choice.relief != 0.0) {
        perMesh = {chosenParts(*imprint.joined, imprint.parts, *choice.keep)};
    } else {
        perMesh = partsPerMesh(*imprint.joined, imprint.parts, choice.keep, choice.split);
    }
    goOn();
    if (choice.keep && choice.relief == 0.0) {
        result.dropped = droppedParts(imprint, perMesh.front());
        const std::string note = untouchedNote(imprint, result.dropped);
        if (!note.empty()) {
            result.notes.push_back(note);
        }
    }
    goOn();
    std::vector<FilledParts> made;
    if (choice.fill && !choice.keep) {
        made = closedParts(imprint, perMesh, *choice.fill, result.notes, progress);
    } else {
        for (std::size_t i = 0; i < perMesh.size(); ++i) {
            const Progress step = stepOf(progress, i, perMesh.size());
            made.push_back(partsMeant(imprint, cut, choice, perMesh[i], result.notes, step));
        }
    }
    for (std::size_t i = 0; i < perMesh.size(); ++i) {
        result.filledHoles += static_cast<int>(made[i].rims.size());
        result.pieces.push_back(pieceOf(imprint, perMesh[i], std::move(made[i])));
    }
    for (std::string& note : slitNotes(imprint, !choice.keep)) {
        result.notes.push_back(std::move(note));
    }
    return result;
}

CutMeshes holesFilled(
    const Imprint& imprint, const HoleChoice& choice, FillShape shape, const Progress& progress
) {
    FilledParts filled = withHolesFilled(*imprint.joined, imprint.parts, choice, shape, progress);
    CutMeshes result;
    result.filledHoles = static_cast<int>(filled.rims.size());
    if (filled.openRims > 0) {
        result.notes.push_back(
            describeCount(static_cast<std::size_t>(filled.openRims), "hole stays", "holes stay") +
            " open"
        );
    }
    if (!filled.crossing.empty()) {
        result.notes.push_back(crossingNote(filled.crossing));
    }
    result.pieces.push_back(wholePiece(imprint, std::move(filled)));
    return result;
}

CutMeshes segmentsOf(const Imprint& imprint, bool split) {
    if (partedParts(*imprint.joined, imprint.parts).empty()) {
        refuseNothingParted();
    }
    CutMeshes result;
    result.notes = slitNotes(imprint, false);
    if (!split) {
        result.pieces.push_back({.parts = {}, .mesh = wholeMesh(imprint)});
        return result;
    }
    const CutMesh cut = cutAlongCurves(*imprint.joined);
    for (std::vector<int>& chosen :
         partsPerMesh(*imprint.joined, imprint.parts, std::nullopt, true)) {
        FilledParts taken = openParts(cut, imprint.parts, chosen);
        result.pieces.push_back(pieceOf(imprint, std::move(chosen), std::move(taken)));
    }
    return result;
}

bool OffsetLines::hasBeside(std::size_t line) const {
    return std::ranges::any_of(pieces, [&](const Piece& piece) {
        return static_cast<std::size_t>(piece.curve) == line;
    });
}

OffsetLines linesBeside(
    const Workpiece& workpiece,
    std::span<const SurfacePolyline> lines,
    const OffsetOptions& options,
    bool withBand,
    const Progress& progress
) {
    const Surface& surface = surfaceOf(workpiece);
    const ExtendedSurface extended = extendSurface(
        surface, ShellOptions().smoothingPasses, partOf(progress, 0.0, kExtendedShare)
    );
    const Progress drawing = partOf(progress, kExtendedShare, 1.0);
    OffsetLines result;
    result.band.resize(withBand ? workpiece.mesh().faces.size() : 0, 0);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Progress step = stepOf(drawing, i, lines.size());
        std::vector<FittedLine> fitted =
            offsetCurves(surface, extended, lines[i], options, partOf(step, 0.0, kLinesShare));
        for (FittedLine& line : fitted) {
            result.pieces.push_back({std::move(line), static_cast<int>(i)});
        }
        if (withBand) {
            const std::vector<char> within =
                facesWithin(surface, lines[i], options, partOf(step, kLinesShare, 1.0));
            for (std::size_t f = 0; f < within.size(); ++f) {
                result.band[f] = static_cast<char>(result.band[f] | within[f]);
            }
        }
    }
    return result;
}

std::vector<char> facesWithin(
    const Workpiece& workpiece,
    const SurfacePolyline& line,
    const OffsetOptions& options,
    const Progress& progress
) {
    return facesWithin(surfaceOf(workpiece), line, options, progress);
}

}  // namespace bspline_curve
