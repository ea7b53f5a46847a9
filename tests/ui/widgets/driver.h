/// Drives a user interface without a window or OpenGL: presses by name, types, reads what is on the
/// screen.
///
/// A journey reads like what a person does:
///
///     Driver driver([&](Ui& ui) { draw_sign_in(ui, state); });
///     driver.click("sign_in.login");
///     driver.type("trainee-12");
///     driver.press(Key::Tab);
///     driver.type("secret");
///     driver.press(Key::Enter);
///     EXPECT_TRUE(driver.sees("Operations"));
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/ui.h"

namespace hallux::ui {

/// A clipboard of its own, so that tests leave the desktop's alone.
class MemoryClipboard : public Clipboard {
 public:
  std::string read() override { return text_; }
  void write(std::string_view text) override { text_ = text; }

 private:
  std::string text_;
};

struct DriverSetting {
  /// Device pixels.
  float width = 1440.0F, height = 900.0F;
  float scale = 1.0F;
  ThemeName theme = ThemeName::Dark;
  bool is_motion_reduced = true;
};

class Driver {
 public:
  using Draw = std::function<void(Ui&)>;

  /// Draws the first frames. `texts` outlives the driver.
  Driver(const Texts& texts, Draw draw, const DriverSetting& setting = {});

  /// Makes frames until nothing more is due at once (at most 200), each 1/60 s later than the last.
  void settle();
  /// Makes one frame, `seconds` later.
  void frame(double seconds = 1.0 / 60.0);
  /// Lets time pass and makes the frames that fall due in it.
  void wait(double seconds);

  // -- what a person does; each waits until the screen has settled
  /// Presses and releases in the middle of what is visible of the widget; scrolls to it first where
  /// it is out of sight.
  /// errors  fails the test and throws std::runtime_error where there is no such widget, or it
  ///         cannot be pressed
  void click(std::string_view id);
  void double_click(std::string_view id);
  void type(std::string_view text);
  void press(Key key, Modifiers modifiers = {});
  void move_to(Point place);
  void wheel(Point place, float notches);
  void drag(Point from, Point to, MouseButton button = MouseButton::Left);
  /// Hands over events without waiting: they may all meet one frame.
  void send(const std::vector<InputEvent>& events);
  void resize(float width, float height);

  // -- what is there
  const FrameContent& content() const { return ui_.shown(); }
  const Widget& widget(std::string_view id) const;
  bool has(std::string_view id) const { return find_widget(ui_.shown(), id) != nullptr; }
  /// True where a text with these words in it is visible; of a message in whichever lines.
  bool sees(std::string_view words) const;
  std::vector<std::string> texts() const;
  const std::string& focused() const { return ui_.focused(); }
  /// What is wrong with the frame as it is shown: texts cut off or outside their room, places in
  /// braces without a value, missing texts, an id twice, a control that cannot be seen though
  /// nothing scrolls it, one that is off without a reason. One line each.
  std::vector<std::string> faults() const;
  /// The ids of controls that are off and do not say why.
  std::vector<std::string> off_without_reason() const;
  /// Controls by id and texts that lie under a message, on the layers that can be reached; but for
  /// a view that fills most of the window.
  std::vector<std::string> covered_by_messages() const;
  Ui& ui() { return ui_; }
  MemoryClipboard& clipboard() { return clipboard_; }
  double time_s() const { return time_s_; }
  /// The event of a pointer that goes there, in logical pixels.
  InputEvent moved_to(Point place);

 private:
  Point middle_of(std::string_view id);
  static InputEvent pointer_event(EventKind kind, Point logical, float scale);

  MemoryClipboard clipboard_;
  Ui ui_;
  Draw draw_;
  EventQueue queue_;
  float width_, height_;
  Point pointer_;
  double time_s_ = 0.0;
};

/// The events of a press and release of a key; of a character; of a click at a place in device
/// pixels.
std::vector<InputEvent> key_events(Key key, Modifiers modifiers = {});
InputEvent character_event(char32_t character);
std::vector<InputEvent> click_events(Point device, MouseButton button = MouseButton::Left);

}  // namespace hallux::ui
