// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_store.h"
#include "surface/surface.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace bspline_curve {

inline constexpr std::uint64_t kDefaultShellCacheBytes = 512ULL << 20U;

/// A folder of simplified shells, one file (shell_file.h) for each surface and parameters. Several
/// processes may use it at once. Nothing in it is trusted: what does not load is deleted.
class ShellCache : public ShellStore {
public:
    /// The folder is made when something is stored. Beyond `sizeLimitBytes` in all the shells that
    /// were not used for longest are deleted.
    explicit ShellCache(
        std::filesystem::path directory, std::uint64_t sizeLimitBytes = kDefaultShellCacheBytes
    );

    /// $BSPLINE_CURVE_CACHE/shells, else $XDG_CACHE_HOME/bspline_curve/shells, else
    /// ~/.cache/bspline_curve/shells. Nothing where the first is set but empty, which turns the
    /// cache off, or where there is no home.
    [[nodiscard]] static std::optional<std::filesystem::path> defaultDirectory();

    /// The cache in defaultDirectory().
    [[nodiscard]] static std::optional<ShellCache> ofUser();

    /// What is found counts as used now.
    [[nodiscard]] Found find(
        const Surface& surface,
        const std::shared_ptr<const ExtendedSurface>& extended,
        std::string_view parameters
    ) const override;

    [[nodiscard]] std::string store(
        const Surface& surface,
        const ExtendedSurface& extended,
        std::string_view parameters,
        const ShellBuild& build
    ) const override;

    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

private:
    [[nodiscard]] std::filesystem::path entryOf(
        const Surface& surface, std::string_view parameters
    ) const;
    void evict() const;

    std::filesystem::path directory_;
    std::uint64_t sizeLimitBytes_;
};

}  // namespace bspline_curve
