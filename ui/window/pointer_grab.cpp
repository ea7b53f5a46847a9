#include "ui/window/pointer_grab.h"

#include <GLFW/glfw3.h>
#include <X11/Xlib.h>

// Of GLFW/glfw3native.h, which wants the headers of extensions that nobody here needs; a GLFW made
// for Wayland alone has neither.
extern "C" {
// NOLINTBEGIN(readability-identifier-naming): GLFW's own names
[[gnu::weak]] Display* glfwGetX11Display();
[[gnu::weak]] Window glfwGetX11Window(GLFWwindow* window);
// NOLINTEND(readability-identifier-naming)
}

namespace hallux::ui {

namespace {

/// Null where the window is not one of X.
Display* display_of_x() noexcept {
  return glfwGetX11Display == nullptr || glfwGetX11Window == nullptr ? nullptr
                                                                     : glfwGetX11Display();
}

}  // namespace

bool grab_pointer(GLFWwindow* window) noexcept {
  Display* const display = display_of_x();
  if (display == nullptr) return true;
  if (glfwGetWindowAttrib(window, GLFW_FOCUSED) == GLFW_FALSE) return false;
  // As GLFW grabs it: from the same program a second grab takes the place of the first.
  constexpr unsigned int heard = ButtonPressMask | ButtonReleaseMask | PointerMotionMask;
  const ::Window own = glfwGetX11Window(window);
  return XGrabPointer(display, own, True, heard, GrabModeAsync, GrabModeAsync, own, None,
                      CurrentTime) == GrabSuccess;
}

bool can_grab_pointer(GLFWwindow* window) noexcept {
  if (!grab_pointer(window)) return false;
  if (Display* const display = display_of_x(); display != nullptr) {
    XUngrabPointer(display, CurrentTime);
    XFlush(display);
  }
  return true;
}

}  // namespace hallux::ui
