// One window, one loop: wait, draw a frame, say what it showed. A frame is drawn only when
// something is due, an event, a time that was asked for, work that ended; a still screen costs
// nothing. Events are taken from GLFW as they come and by the frame one after the other. The map
// for tests may fall due alone, and draws nothing.
#include "ui/window/window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "ui/render/gl/software_renderer.h"
#include "ui/render/imgui_painter.h"
#include "ui/render/picture.h"
#include "ui/render/scene_painter.h"
#include "ui/widgets/ui_map.h"
#include "ui/window/glfw_events.h"
#include "ui/window/pointer_grab.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {
namespace {

constexpr double shortest_frame_s = 1.0 / 120.0;
/// Another program may hold the pointer for a while: how soon the display is asked again.
constexpr double capture_again_s = 1.0;

std::string last_glfw_fault() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason was given" : text;
}

class DesktopClipboard : public Clipboard {
 public:
  std::string read() override {
    const char* text = glfwGetClipboardString(nullptr);
    return text == nullptr ? std::string() : text;
  }
  void write(std::string_view text) override {
    glfwSetClipboardString(nullptr, std::string(text).c_str());
  }
};

// GLFW, from its start to its end.
class Library {
 public:
  Library() {
    share_processors_with_loop();
    if (glfwInit() == GLFW_FALSE)
      throw WindowError(
          "There is no display to open a window on (" + last_glfw_fault() +
          "). Start it from a desktop, or use a verb that needs no window: hallux --help");
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { glfwTerminate(); }
};

struct PlaceOnDesktop {
  int x = 0, y = 0, width = 0, height = 0;
};

}  // namespace

struct Window::State {
  Library library;
  WindowEvents events;
  DesktopClipboard clipboard;
  GLFWwindow* window = nullptr;
  std::unique_ptr<Ui> ui;
  std::unique_ptr<ImguiPainter> painter;
  std::unique_ptr<OpenGlScenePainter> scenes;
  std::optional<UiMap> map;
  bool (*is_asked_to_end)() noexcept = nullptr;
  std::array<GLFWcursor*, 3> cursors{};
  PointerShape shape = PointerShape::Arrow;
  std::optional<std::filesystem::path> picture;
  PlaceOnDesktop before_full_screen;
  bool is_full_screen = false;
  /// Until the display refuses: then it is asked again now and then.
  bool does_capture = true;
  double asked_to_capture_s = 0.0;
  long frames = 0;
  double map_due_in_s = std::numeric_limits<double>::infinity(), last_frame_s = -1.0;

  ~State() {
    scenes.reset();
    painter.reset();
    ui.reset();
    for (GLFWcursor* cursor : cursors) glfwDestroyCursor(cursor);
    if (window != nullptr) glfwDestroyWindow(window);
  }
};

namespace {

GLFWwindow* open_window(const WindowSetting& setting) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  GLFWwindow* window =
      glfwCreateWindow(setting.width, setting.height, setting.title.c_str(), nullptr, nullptr);
  if (window == nullptr)
    throw WindowError("The display offers no OpenGL 3.3 window (" + last_glfw_fault() +
                      "). Install a graphics driver, or libgl1-mesa-dri for the software renderer");
  return window;
}

}  // namespace

Window::Window(const Texts& texts, const WindowSetting& setting)
    : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.window = open_window(setting);
  glfwMakeContextCurrent(state.window);
  glfwSwapInterval(1);
  listen(state.window, state.events);
  state.cursors = {glfwCreateStandardCursor(GLFW_ARROW_CURSOR),
                   glfwCreateStandardCursor(GLFW_IBEAM_CURSOR),
                   glfwCreateStandardCursor(GLFW_HAND_CURSOR)};
  state.ui =
      std::make_unique<Ui>(texts, state.clipboard, ThemeName::Dark, state.events.content_scale);
  state.painter = std::make_unique<ImguiPainter>();
  state.scenes = std::make_unique<OpenGlScenePainter>();
  if (setting.write_ui_map) state.map.emplace(setting.write_ui_map);
  state.is_asked_to_end = setting.is_asked_to_end;
}

Window::~Window() = default;

void Window::close() noexcept { glfwSetWindowShouldClose(state_->window, GLFW_TRUE); }
void Window::keep_picture(std::filesystem::path file) { state_->picture = std::move(file); }
void Window::wake() noexcept { glfwPostEmptyEvent(); }
long Window::frames() const noexcept { return state_->frames; }

namespace {

// The display that most of the window lies on.
GLFWmonitor* monitor_of(GLFWwindow* window) {
  PlaceOnDesktop place;
  glfwGetWindowPos(window, &place.x, &place.y);
  glfwGetWindowSize(window, &place.width, &place.height);
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  GLFWmonitor* best = glfwGetPrimaryMonitor();
  int most = -1;
  for (int number = 0; number < count; ++number) {
    int x = 0, y = 0;
    glfwGetMonitorPos(monitors[number], &x, &y);
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[number]);
    const int across = std::min(place.x + place.width, x + mode->width) - std::max(place.x, x);
    const int down = std::min(place.y + place.height, y + mode->height) - std::max(place.y, y);
    if (across > 0 && down > 0 && across * down > most)
      most = across * down, best = monitors[number];
  }
  return best;
}

void change_full_screen(GLFWwindow* window, bool is_wanted, PlaceOnDesktop& before) {
  if (!is_wanted) {
    glfwSetWindowMonitor(window, nullptr, before.x, before.y, before.width, before.height,
                         GLFW_DONT_CARE);
    return;
  }
  GLFWmonitor* monitor = monitor_of(window);
  if (monitor == nullptr) return;
  glfwGetWindowPos(window, &before.x, &before.y);
  glfwGetWindowSize(window, &before.width, &before.height);
  const GLFWvidmode* mode = glfwGetVideoMode(monitor);
  glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}  // namespace

namespace {

void show_pointer(GLFWwindow* window, PointerShape shape,
                  const std::array<GLFWcursor*, 3>& cursors) {
  const bool is_hidden = shape == PointerShape::Hidden;
  glfwSetInputMode(window, GLFW_CURSOR, is_hidden ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
  if (!is_hidden) glfwSetCursor(window, cursors[static_cast<std::size_t>(shape)]);
}

}  // namespace

// One frame where there is something to draw on; a minimised window draws none and keeps its
// events.
void Window::draw_frame(Shell& shell) {
  State& state = *state_;
  int width = 0, height = 0, units = 0, ignored = 0;
  glfwGetFramebufferSize(state.window, &width, &height);
  glfwGetWindowSize(state.window, &units, &ignored);
  if (width <= 0 || height <= 0) return;
  state.events.pixels_per_unit =
      units > 0 ? static_cast<float>(width) / static_cast<float>(units) : 1.0F;
  shell.set_display_scale(state.events.content_scale);
  const double now_s = glfwGetTime();
  const bool is_touched = !state.events.queue.is_empty();
  state.ui->begin_frame(state.events.queue, static_cast<float>(width), static_cast<float>(height),
                        now_s);
  state.scenes->begin_frame({0, 0, 0, {width, height}}, is_touched);
  shell.draw(*state.ui, *state.scenes);
  state.ui->end_frame();
  const Color page = state.ui->theme().page;
  state.scenes->finish_frame({page.red, page.green, page.blue}, [&](float columns) {
    state.painter->draw(state.ui->draw_data(), state.ui->fonts_version(), columns);
  });
  if (state.picture)
    write_png(*std::exchange(state.picture, std::nullopt), read_pixels({0, 0, 0, {width, height}}));
  glfwSwapBuffers(state.window);
  ++state.frames;
  state.last_frame_s = now_s;
  settle_pointer(shell);
  if (state.is_full_screen != shell.preferences().is_full_screen) {
    state.is_full_screen = shell.preferences().is_full_screen;
    change_full_screen(state.window, state.is_full_screen, state.before_full_screen);
  }
}

// The pointer as the frame asked for it: caught, or of some shape.
void Window::settle_pointer(Shell& shell) {
  State& state = *state_;
  const double now_s = glfwGetTime();
  if (!state.does_capture && now_s > state.asked_to_capture_s + capture_again_s) {
    state.asked_to_capture_s = now_s;
    state.does_capture = can_grab_pointer(state.window);
  }
  state.ui->set_can_capture(state.does_capture && shell.preferences().captures_pointer);
  const bool is_wanted = !state.ui->captured_by().empty() && state.ui->can_capture();
  if (is_wanted != state.events.is_captured) {
    state.does_capture = set_captured(state.window, state.events, is_wanted);
    state.asked_to_capture_s = now_s;
    state.shape = PointerShape::Arrow;
    state.events.wants_frame = true;
  }
  if (state.events.is_captured || state.shape == state.ui->pointer_shape()) return;
  state.shape = state.ui->pointer_shape();
  show_pointer(state.window, state.shape, state.cursors);
}

// Returns once a frame should be drawn. In between only the map may fall due.
void Window::wait_for_frame() {
  State& state = *state_;
  for (;;) {
    const bool is_hidden = glfwGetWindowAttrib(state.window, GLFW_ICONIFIED) != 0;
    const double due_s =
        is_hidden ? std::numeric_limits<double>::infinity()
                  : state.last_frame_s + std::max(state.ui->next_frame_in_s(), shortest_frame_s);
    const double now_s = glfwGetTime();
    const bool is_due = !is_hidden && (state.events.wants_frame || !state.events.queue.is_empty() ||
                                       now_s >= due_s);
    const double map_due_s = now_s + state.map_due_in_s, until_s = std::min(due_s, map_due_s);
    if (is_due)
      glfwPollEvents();
    else if (std::isinf(until_s))
      glfwWaitEvents();
    else
      glfwWaitEventsTimeout(std::max(until_s - now_s, 0.0005));
    update_map();
    // Whatever ended the waiting early - an event, work that wakes the window - may be something to
    // show.
    const bool was_only_the_map = !is_due && glfwGetTime() >= map_due_s && glfwGetTime() < due_s &&
                                  state.events.queue.is_empty() && !state.events.wants_frame;
    const bool is_ending = glfwWindowShouldClose(state.window) != 0 || state.is_asked_to_end();
    if (is_ending || (!is_hidden && !was_only_the_map)) return;
  }
}

void Window::update_map() {
  State& state = *state_;
  if (state.map && state.frames > 0)
    state.map_due_in_s = state.map->update(state.ui->shown(), state.ui->scale(), glfwGetTime(),
                                           state.ui->captured_by());
}

// Asked to close, the window says why it stays where a screen may not be left. The system does not
// wait for an answer.
bool Window::is_closing(Shell& shell) {
  State& state = *state_;
  if (state.is_asked_to_end()) return true;
  if (glfwWindowShouldClose(state.window) == 0) return false;
  if (shell.may_leave(*state.ui)) return true;
  glfwSetWindowShouldClose(state.window, GLFW_FALSE);
  state.events.wants_frame = true;
  return false;
}

void Window::run(Shell& shell) {
  State& state = *state_;
  while (!is_closing(shell)) {
    wait_for_frame();
    if (is_closing(shell)) break;
    state.events.wants_frame = false;
    draw_frame(shell);
    update_map();
  }
}

}  // namespace hallux::ui
