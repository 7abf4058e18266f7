// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/error.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace bspline_curve {

/// Elements of a file that cannot be used: they are left out, and one note counts them and names
/// the first.
class LeftOut {
public:
    /// The file must outlive this.
    explicit LeftOut(const std::filesystem::path& file) : file_(file) {}

    void add(std::size_t line, const std::string& reason);
    /// What refuseLine() of the file threw.
    void add(const InputError& error);

    [[nodiscard]] bool empty() const { return count_ == 0; }

    /// "a.dxf: 3 entities left out; the first, line 7: a radius that is not > 0".
    [[nodiscard]] std::string note(const std::string& one, const std::string& many) const;
    /// Throws InputError (UnreadableFile) of the first.
    [[noreturn]] void refuse() const;

private:
    const std::filesystem::path& file_;
    std::size_t count_ = 0;
    std::string first_;  // "line 7: why"
};

}  // namespace bspline_curve
