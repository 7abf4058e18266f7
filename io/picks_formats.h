// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/files.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// The formats of picks, one function each; readPicks() chooses among them. Each throws InputError
// (UnreadableFile) naming file and place.
namespace bspline_curve {

[[nodiscard]] PicksFile picksOfPickPoints(
    const std::filesystem::path& file, const std::string& bytes
);
/// Blanks, commas or semicolons between the fields, whichever the first line has; # and // begin
/// comments. A line of names, and a label before the coordinates, as in CSV.
[[nodiscard]] PicksFile picksOfText(const std::filesystem::path& file, std::string_view bytes);
/// A list of 3D Slicer (.fcsv), in LPS.
[[nodiscard]] PicksFile picksOfSlicerList(
    const std::filesystem::path& file, std::string_view bytes
);
[[nodiscard]] PicksFile picksOfCsv(const std::filesystem::path& file, std::string_view bytes);
/// Ours, or the markups of 3D Slicer, whichever the file holds.
[[nodiscard]] PicksFile picksOfJson(const std::filesystem::path& file, const std::string& bytes);

/// The one markup of 3D Slicer with points in a document that has "markups".
[[nodiscard]] PicksFile picksOfMarkups(
    const std::filesystem::path& file, const nlohmann::json& document
);

/// [x, y, z]; `name` says in messages what that is.
[[nodiscard]] Vec3 pointOfJson(
    const std::filesystem::path& file, const nlohmann::json& value, const std::string& name
);

/// What an object says of corners among so many picks: a list of indices "corners", or nothing.
[[nodiscard]] std::vector<int> cornersOfJson(
    const std::filesystem::path& file, const nlohmann::json& object, std::size_t picks
);

/// What an object says of directions at so many picks: a list "tangents" as addTangents() writes
/// it, or nothing.
[[nodiscard]] PickDirections tangentsOfJson(
    const std::filesystem::path& file, const nlohmann::json& object, std::size_t picks
);

/// What an object says of how near a curve keeps to so many picks: a list "tolerances" of numbers
/// and texts, one for each, or nothing.
[[nodiscard]] PickTolerances tolerancesOfJson(
    const std::filesystem::path& file, const nlohmann::json& object, std::size_t picks
);

/// A coordinate of a file: a finite number.
[[nodiscard]] double coordinateOf(
    const std::filesystem::path& file, std::size_t line, std::string_view word
);

}  // namespace bspline_curve
