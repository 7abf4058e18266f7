// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/designer.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace bspline_curve::test_support {

[[nodiscard]] inline CurveDesigner designerIn(ShellKind kind, TriangleMesh mesh) {
    return CurveDesigner(std::move(mesh), {.kind = kind});
}

/// Tests that hold in shells of every kind.
class EitherShell : public testing::TestWithParam<ShellKind> {
protected:
    [[nodiscard]] static CurveDesigner designerOn(TriangleMesh mesh) {
        return designerIn(GetParam(), std::move(mesh));
    }
};

inline const auto kEitherShell =
    testing::Values(ShellKind::Local, ShellKind::FullResolution, ShellKind::Simplified);

[[nodiscard]] inline std::string nameOf(ShellKind kind) {
    switch (kind) {
        case ShellKind::Simplified:
            return "Simplified";
        case ShellKind::FullResolution:
            return "FullResolution";
        case ShellKind::Local:
            return "Local";
    }
    return "";
}

[[nodiscard]] inline std::string nameOfShell(const testing::TestParamInfo<ShellKind>& instance) {
    return nameOf(instance.param);
}

}  // namespace bspline_curve::test_support
