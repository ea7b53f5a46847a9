#include "ui/render/gl/headless_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>

#include "ui/render/gl/graphics_error.h"

namespace hallux::ui {

namespace {

constexpr const char* mend =
    "install libegl-mesa0 and libgl1-mesa-dri, or run where an OpenGL 3.3 driver is";

[[noreturn]] void fail(const std::string& what) {
  throw GraphicsError("pictures need OpenGL 3.3 without a window, but " + what + "; " + mend);
}

EGLDisplay open_display() {
  if (!epoxy_has_egl()) fail("there is no EGL library");
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    fail("this EGL has no surfaceless platform");
  }
  const EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
    fail("EGL's surfaceless display does not start");
  }
  return display;
}

EGLContext open_context(EGLDisplay display) {
  constexpr std::array<EGLint, 3> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  eglBindAPI(EGL_OPENGL_API);
  // Without EGL_SURFACE_TYPE a window would be asked for, which a surfaceless display has none of.
  constexpr std::array<EGLint, 5> any{EGL_SURFACE_TYPE, 0, wanted[0], wanted[1], EGL_NONE};
  if (eglChooseConfig(display, any.data(), &config, 1, &count) != EGL_TRUE || count < 1) {
    return EGL_NO_CONTEXT;
  }
  constexpr std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                          3,
                                          EGL_CONTEXT_MINOR_VERSION,
                                          3,
                                          EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                          EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                          EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
}

}  // namespace

HeadlessContext::HeadlessContext() : display_(open_display()) {
  context_ = open_context(display_);
  if (context_ == EGL_NO_CONTEXT) fail("EGL gives no OpenGL 3.3 core context");
  if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
    eglDestroyContext(display_, context_);
    fail("EGL does not make a context current without a surface");
  }
}

HeadlessContext::~HeadlessContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  // The display stays open: EGL has one for the whole process, and another context may live on it.
}

std::string renderer_name() { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

bool is_software_renderer() {
  const std::string name = renderer_name();
  return name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos ||
         name.find("SWR") != std::string::npos;
}

}  // namespace hallux::ui
