// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace bspline_curve {

struct PicksFile {
    std::vector<Vec3> picks;     ///< finite, in the order of the file
    std::optional<bool> closed;  ///< what the file says about it, if it can
    std::vector<int> corners{};  ///< indices of picks
};

/// The ends of names of files of picks, for help and messages.
inline constexpr std::string_view kPicksExtensions =
    ".pp, .json, .mrk.json, .fcsv, .csv, .xyz, .txt, .asc";

/// Picked points by extension:
///   .pp        MeshLab's PickPoints (points that are not active are left out)
///   .json      {"picks": [[x, y, z], …], "closed": true or false, "corners": [0, …]}: indices of
///              picks that are corners; other keys are left alone
///   .mrk.json  (or .json) the markups of 3D Slicer: the placed control points of the one Fiducial,
///              Curve, ClosedCurve or Line that has any, in LPS; curves and lines say whether they
///              are closed
///   .fcsv      a list of 3D Slicer, in LPS
///   .xyz       (or .txt, .asc) x y z per line with blanks, commas or semicolons between them, more
///              columns are left alone; # and // start comments
///   .csv       commas, semicolons or tabs; a first line of names chooses the columns x, y, z, also
///              as "x [mm]" and "Points:0"; without one, a text in the first column is a label;
///              with semicolons decimal commas may be used
/// Throws InputError (UnreadableFile) naming file, line (where there are lines) and reason.
[[nodiscard]] PicksFile readPicks(const std::filesystem::path& file);

/// "x y z; x y z; …", also with line ends for semicolons and with commas between coordinates. Empty
/// text: no picks. Throws InputError (UnreadableFile) naming the pick, from 0, and what is wrong
/// with it.
[[nodiscard]] std::vector<Vec3> parsePicksText(std::string_view text);

}  // namespace bspline_curve
