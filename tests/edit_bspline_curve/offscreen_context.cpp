// SPDX-License-Identifier: GPL-3.0-or-later
#include "offscreen_context.h"

#include <EGL/eglext.h>

#include <array>

namespace bspline_curve::test_support {

OffscreenContext::OffscreenContext(int width, int height) {
    const auto displayOf = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT")
    );
    if (displayOf == nullptr) {
        return;
    }
    display_ = displayOf(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    constexpr std::array kConfig = {
        EGL_SURFACE_TYPE,
        EGL_PBUFFER_BIT,
        EGL_RENDERABLE_TYPE,
        EGL_OPENGL_BIT,
        EGL_RED_SIZE,
        8,
        EGL_DEPTH_SIZE,
        24,
        EGL_NONE
    };
    const std::array size = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglInitialize(display_, nullptr, nullptr) == EGL_FALSE ||
        eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
        eglChooseConfig(display_, kConfig.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
        return;
    }
    surface_ = eglCreatePbufferSurface(display_, config, size.data());
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    isThere_ = eglMakeCurrent(display_, surface_, surface_, context_) == EGL_TRUE;
}

OffscreenContext::~OffscreenContext() {
    if (display_ == EGL_NO_DISPLAY) {
        return;
    }
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) {
        eglDestroyContext(display_, context_);
    }
    if (surface_ != EGL_NO_SURFACE) {
        eglDestroySurface(display_, surface_);
    }
    eglTerminate(display_);
}

}  // namespace bspline_curve::test_support
