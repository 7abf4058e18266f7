// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <EGL/egl.h>

namespace bspline_curve::test_support {

/// A context of OpenGL that draws into memory, of the pipeline that MeshLab uses, current as long
/// as it lives. Needs no display.
class OffscreenContext {
public:
    OffscreenContext(int width, int height);
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    /// Whether the machine can.
    [[nodiscard]] bool isThere() const { return isThere_; }

private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
    bool isThere_ = false;
};

}  // namespace bspline_curve::test_support
