// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <Eigen/Core>

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

// What DXF files hold (Autodesk, DXF reference): pairs of a group code and a value, a line each.
namespace bspline_curve {

struct DxfPair {
    int code = 0;
    std::string_view value;
    std::size_t line = 0;
};

/// Bits of the flags (code 70) of polylines and of their vertices.
struct DxfFlag {
    static constexpr int kClosed = 1;
    static constexpr int kSplineFit = 4;
    static constexpr int kIn3d = 8;
    static constexpr int kMesh = 16 | 64;
    static constexpr int kSplineFrame = 16;  // of a vertex
};

/// One entity, or a vertex of a polyline: its name and its pairs. Its functions throw InputError
/// (UnreadableFile) naming the line where a value is no finite number.
class DxfEntity {
public:
    DxfEntity(const std::filesystem::path& file, std::string_view name, std::size_t line)
        : file_(&file), name_(name), line_(line) {}

    void add(const DxfPair& pair) { pairs_.push_back(pair); }

    [[nodiscard]] std::string_view name() const { return name_; }

    [[nodiscard]] std::size_t line() const { return line_; }

    [[nodiscard]] const std::vector<DxfPair>& pairs() const { return pairs_; }

    [[nodiscard]] double number(const DxfPair& pair) const;
    /// The values of the first pair, and of all pairs, with a code.
    [[nodiscard]] double numberOf(int code, double otherwise) const;
    [[nodiscard]] std::vector<double> numbersOf(int code) const;
    [[nodiscard]] std::string_view textOf(int code) const;
    [[nodiscard]] int flags() const;
    /// A whole number, cut to the range of int.
    [[nodiscard]] int integerOf(int code, int otherwise) const;
    /// A point, whose axes are `code`, `code` + 10 and `code` + 20.
    [[nodiscard]] Vec3 pointOf(int code) const;
    /// The axes of its own coordinates, by the arbitrary axis algorithm of the reference.
    [[nodiscard]] Eigen::Matrix3d axes() const;

    /// Throws InputError (UnreadableFile) naming its line.
    [[noreturn]] void refuse(const std::string& reason) const;

private:
    const std::filesystem::path* file_;
    std::string_view name_;
    std::size_t line_;
    std::vector<DxfPair> pairs_;
};

struct DxfContent {
    std::vector<DxfEntity> entities;  ///< of the section ENTITIES
    std::vector<DxfEntity> blocks;    ///< of the section BLOCKS: BLOCK, its entities, ENDBLK, …
    std::vector<DxfEntity> tables;    ///< of the section TABLES: TABLE, LAYER, …
};

/// The entities of a file, whose bytes must stay. Throws InputError (UnreadableFile) where it is no
/// DXF text.
[[nodiscard]] DxfContent dxfContent(const std::filesystem::path& file, std::string_view bytes);

}  // namespace bspline_curve
