// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace bspline_curve {

/// A scalar field on a mesh: one finite value per vertex. Copies share the values, and a designer
/// that gets the same field again need not look at it again.
class ScalarField {
public:
    /// No field at all.
    ScalarField() = default;

    /// NOLINTNEXTLINE(google-explicit-constructor): values are a field
    ScalarField(std::vector<double> values)
        : values_(
              values.empty() ? nullptr
                             : std::make_shared<const std::vector<double>>(std::move(values))
          ) {}

    [[nodiscard]] bool empty() const { return values_ == nullptr; }

    /// One per vertex of the mesh as the caller has it.
    [[nodiscard]] const std::vector<double>& values() const {
        static const std::vector<double> kNone;
        return values_ ? *values_ : kNone;
    }

    /// The same where it was made: a mesh that had to be mended has other vertices there. For the
    /// library's own use, see fieldOn().
    struct OnSurface {
        std::shared_ptr<const void> surface;  ///< which one
        std::vector<double> values;           ///< one per vertex of it
    };

    ScalarField(std::vector<double> values, std::shared_ptr<const OnSurface> onSurface)
        : ScalarField(std::move(values)) {
        onSurface_ = std::move(onSurface);
    }

    [[nodiscard]] const std::shared_ptr<const OnSurface>& onSurface() const { return onSurface_; }

    [[nodiscard]] const std::shared_ptr<const std::vector<double>>& shared() const {
        return values_;
    }

private:
    std::shared_ptr<const std::vector<double>> values_;
    std::shared_ptr<const OnSurface> onSurface_;
};

}  // namespace bspline_curve
