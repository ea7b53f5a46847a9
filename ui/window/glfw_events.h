/// Puts what GLFW reports into our event queue, in order. Inside this corner only.
#pragma once

#include "ui/widgets/input/event_queue.h"

struct GLFWwindow;

namespace hallux::ui {

/// Where the callbacks of one window put what they hear; the window's user pointer names it.
struct WindowEvents {
  EventQueue queue;
  /// The window must be drawn although nobody did anything: uncovered, resized.
  bool wants_frame = true;
  /// Of the display it is on.
  float content_scale = 1.0F;
  /// Framebuffer pixels per unit of the pointer's position.
  float pixels_per_unit = 1.0F;
  /// Where the last event put the pointer, in GLFW's units. What the display says now may be ahead
  /// of the events: a press that waited while a frame was made must meet what it was aimed at.
  double pointer_x = 0.0, pointer_y = 0.0;
  /// Where it was put when it was let go: of a move to that very place GLFW tells nothing.
  double freed_x = 0.0, freed_y = 0.0;
  /// The pointer is seen nowhere and only its way is told.
  bool is_captured = false;
};

/// Sets every callback; `events` outlives the window.
void listen(GLFWwindow* window, WindowEvents& events);

/// Captures the pointer, or lets it go where it was caught. False where the display does not
/// capture; then it is free.
bool set_captured(GLFWwindow* window, WindowEvents& events, bool is_captured);

}  // namespace hallux::ui
