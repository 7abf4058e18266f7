// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"
#include "shell/simplify/component_test.h"
#include "shell/simplify/layer_grid.h"
#include "shell/simplify/patch_test.h"
#include "shell/simplify/prism_complex.h"
#include "shell/simplify/tracked_surface.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace bspline_curve {

/// Changes a valid shell into another valid shell, patch by patch: every operation of the
/// simplifier proposes prisms for a patch of the middle surface, and replace() puts them there if
/// all invariants hold afterwards. The outer walls of the patch stay as they are, so the part of
/// the surface in it stays the same, and the union of the old tracks holds every face that meets a
/// new prism.
class ShellEditor {
public:
    /// `start` has prism i over face i of the surface.
    ShellEditor(const TrackedSurface& surface, const Shell& start);

    ShellEditor(const ShellEditor&) = delete;
    ShellEditor& operator=(const ShellEditor&) = delete;
    ShellEditor(ShellEditor&&) = delete;
    ShellEditor& operator=(ShellEditor&&) = delete;
    ~ShellEditor() = default;

    [[nodiscard]] const TrackedSurface& surface() const { return surface_; }

    [[nodiscard]] const PrismComplex& complex() const { return complex_; }

    [[nodiscard]] int pillarCount() const { return static_cast<int>(isFrozen_.size()); }

    /// Pillars at the end of the shell stay as they are.
    [[nodiscard]] bool isFrozen(int pillar) const { return isFrozen_[pillar] != 0; }

    /// Enters all prisms anew into the grid that finds neighbours in space.
    void rebuildGrid(double cellSize) { grid_.rebuild(cellSize); }

    // ---- Proposals ----

    /// The prisms to be replaced, and those that are to take their place (pillars counter-clockwise
    /// from the top). Changed pillars are set in the complex first, see setPillar().
    std::vector<int> old;
    std::vector<Triangle> fresh;

    /// old: the prisms around a pillar; fresh: the same.
    void proposeStar(int pillar);

    [[nodiscard]] Pillar pillarAt(int pillar) const { return complex_.points.pillar(pillar); }

    void setPillar(int pillar, const Pillar& value) { complex_.points.set(pillar, value); }

    /// Puts `fresh` in the place of `old` if all invariants hold; else changes nothing (what
    /// setPillar() did is the caller's to undo).
    [[nodiscard]] bool replace();

    /// replace() with another pillar; the old one is restored where that fails.
    [[nodiscard]] bool replaceWith(int pillar, const Pillar& value);

    // ---- Figures ----

    /// 4 sqrt(3) area / (sum of squared edges) of a middle triangle: 1 where equilateral, 0 where
    /// degenerate.
    [[nodiscard]] double quality(const Triangle& pillars) const;

    /// The smallest quality in `fresh`.
    [[nodiscard]] double leastQuality() const;

    [[nodiscard]] double middleLength(int a, int b) const;

    /// Mean normal of the faces that meet `old`, by area.
    [[nodiscard]] Vec3 meanNormal();

    /// The nearest point on a line (through a point, along a unit direction) of the faces that meet
    /// `old`, seen from the top.
    [[nodiscard]] std::optional<Vec3> onSurface(const Vec3& point, const Vec3& direction);

    // ---- Changes so far ----

    /// Number of the last replacement, and of the last one that changed a prism around a pillar. An
    /// operation that failed would fail again until something changes.
    [[nodiscard]] int time() const { return time_; }

    [[nodiscard]] int changed(int pillar) const { return changed_[pillar]; }

private:
    void gatherFaces();

    const TrackedSurface& surface_;
    PrismComplex complex_;
    PatchTest test_;
    LayerGrid grid_;
    ComponentTest components_;
    std::vector<char> isFrozen_;
    std::vector<int> faces_;       // that meet `old`, after gatherFaces()
    std::vector<int> faceStamps_;  // of the last gatherFaces() that met a face
    int faceStamp_ = 0;
    int time_ = 0;
    std::vector<int> changed_;
};

}  // namespace bspline_curve
