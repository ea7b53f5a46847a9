/// Whether the display lends the pointer to this window. Inside this corner only.
#pragma once

struct GLFWwindow;

namespace hallux::ui {

/// Takes the pointer for this window, so that GLFW catches it for certain: GLFW asks likewise and
/// does not look at the answer, and catches nothing while another window has the keyboard. False
/// where that is so, or another program holds the pointer; then nothing has changed. Displays that
/// are not X11 are taken at their word.
bool grab_pointer(GLFWwindow* window) noexcept;
/// Whether grab_pointer would succeed now; the pointer stays free.
bool can_grab_pointer(GLFWwindow* window) noexcept;

}  // namespace hallux::ui
