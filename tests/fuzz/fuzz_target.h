// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

// What the fuzzer and the tests of its corpus call, in one table.
namespace bspline_curve::fuzz {

/// Takes bytes that somebody else chose. An InputError is an answer; whatever else is thrown, and
/// what the sanitizers find, is a defect.
struct FuzzTarget {
    std::string_view name;  ///< also the folder of its corpus
    void (*run)(std::string_view bytes);
    /// Whether memory must stay in proportion to the bytes: they are a file.
    bool isReader = true;
};

[[nodiscard]] std::span<const FuzzTarget> fuzzTargets();

/// The target of that name, or null.
[[nodiscard]] const FuzzTarget* findTarget(std::string_view name);

/// Throws what nobody catches where a result does not hold together.
inline void require(bool holds, const char* what) {
    if (!holds) {
        throw std::logic_error(std::string("does not hold: ") + what);
    }
}

// ---- one function per target ----

void readPlyBytes(std::string_view bytes);
void readObjBytes(std::string_view bytes);
void readOffBytes(std::string_view bytes);
void readStlBytes(std::string_view bytes);

/// Picks; the first byte chooses the format.
void readPicksBytes(std::string_view bytes);

void readCurveBytes(std::string_view bytes);  ///< .json of a curve
/// Curves in formats of others, read onto a mesh; the first byte chooses the format.
void readForeignCurveBytes(std::string_view bytes);
void readDrawingBytes(std::string_view bytes);  ///< .svg or .dxf; the first byte chooses
/// Curves to go on with; the first byte chooses the format.
void openDrawnBytes(std::string_view bytes);
void readShellBytes(std::string_view bytes);  ///< a file of the cache of shells

void readFieldBytes(std::string_view bytes);    ///< .npy or text; the first byte chooses
void readFaceIdsBytes(std::string_view bytes);  ///< likewise
void readJobsBytes(std::string_view bytes);     ///< jobs.csv
void readResultsBytes(std::string_view bytes);  ///< results of a batch, and reports of curves

/// A mesh, picks and options, drawn from the bytes: a curve, and that curve imprinted.
void drawCurve(std::string_view bytes);

}  // namespace bspline_curve::fuzz
