/// One window's user interface, drawn frame by frame: who was pressed, where the keyboard is, what
/// was drawn.
///
/// A screen is a function that draws controls by name with the components of this room; each
/// answers whether it was pressed in this frame. Between two frames only the names connect: events
/// are resolved against the frame that the person saw. Picture of one frame:
///
///     begin_frame(queue)   events -> pressed, focus, edits      (against the last frame's content)
///       button(ui, "x")    draws, registers, answers            (into this frame's content)
///     end_frame()          this frame's content becomes the one people see
///
/// Keyboard: Tab and Shift+Tab visit every control, arrows move inside a group, Space presses what
/// has the ring, Enter presses it too and else the screen's primary button. The ring shows after
/// Tab or an arrow and hides on a mouse press.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/canvas.h"
#include "ui/widgets/input/interaction.h"
#include "ui/widgets/look/theme.h"
#include "ui/widgets/texts/text_edit.h"
#include "ui/widgets/texts/texts.h"

struct ImDrawData;

namespace hallux::ui {

/// What happened to a control in this frame.
struct Response {
  bool is_hovered = false, is_held = false;
  /// Keys go here.
  bool has_focus = false;
  /// And the person steers by keyboard.
  bool shows_ring = false;
  PressedBy pressed_by = PressedBy::Nothing;
  /// The second of two quick clicks.
  bool is_double = false;
  /// 0-1, eased.
  float hover = 0.0F;

  bool is_pressed() const noexcept { return pressed_by != PressedBy::Nothing; }
};

/// What the pointer did in an area that is no control: the view of the bone, a chart.
struct AreaResponse {
  bool is_hovered = false;
  std::array<bool, mouse_button_count> is_down{};
  /// Since the last frame, while the button was held from inside.
  std::array<Point, mouse_button_count> dragged{};
  /// Pressed and let go, without having been dragged away.
  std::array<bool, mouse_button_count> clicked{};
  /// The second of two quick clicks, left.
  bool is_double = false;
  /// It has the pointer, which moves nothing else: its way since the last frame.
  bool is_captured = false;
  Point way;
  Point pointer;
  /// Notches.
  float wheel = 0.0F;
};

struct Shortcut {
  Chord chord;
  std::string label = {};
  Layer layer = Layer::Page;

  bool operator==(const Shortcut&) const = default;
};

/// What the mouse does on a screen besides pressing controls, in words.
struct MouseGesture {
  std::string input = {}, label = {};
  Layer layer = Layer::Page;
};

enum class PointerShape : std::uint8_t {
  Arrow,
  Text,
  Hand,
  /// What the pointer leads stands for it, or the picture carries it.
  Hidden
};

class Ui {
 public:
  /// errors  std::runtime_error where no font is installed
  Ui(const Texts& texts, Clipboard& clipboard, ThemeName theme, float scale);
  Ui(const Ui&) = delete;
  Ui& operator=(const Ui&) = delete;
  ~Ui();

  // -- the frame, called by the window or a test
  /// Takes events up to the one that changes the screen. `width` and `height` are device pixels,
  /// `time_s` only grows.
  void begin_frame(EventQueue& queue, float width, float height, double time_s);
  void end_frame();
  const ImDrawData& draw_data() const;
  /// Seconds until a frame is due without any event: 0 now, infinity never.
  double next_frame_in_s() const noexcept;
  /// What the last finished frame showed.
  const FrameContent& shown() const noexcept { return shown_; }
  /// Where this frame's messages will stand over what the screen draws: what follows something that
  /// moves gives way to them.
  void set_messages_at(std::vector<Rect> places) noexcept { messages_at_ = std::move(places); }
  const std::vector<Rect>& messages_at() const noexcept { return messages_at_; }
  /// What this frame has drawn so far.
  const FrameContent& drawn() const noexcept { return building_; }
  /// Counts the font pictures made; the painter takes a new one where it changed.
  int fonts_version() const noexcept { return fonts_version_; }
  PointerShape pointer_shape() const noexcept { return pointer_shape_; }

  // -- settings; scale and theme take effect with the next frame
  void set_scale(float scale) noexcept { wanted_scale_ = scale; }
  void set_theme(ThemeName name) noexcept { theme_ = make_theme(name); }
  void set_reduced_motion(bool is_reduced) noexcept { is_motion_reduced_ = is_reduced; }
  float scale() const noexcept { return fonts_->scale(); }

  // -- for components and screens, inside a frame
  Canvas& canvas() noexcept { return *canvas_; }
  const Theme& theme() const noexcept { return theme_; }
  const Texts& texts() const noexcept { return *texts_; }
  /// A text of the catalogue; see Texts.
  std::string_view text(std::string_view id) const { return texts_->text(id); }
  /// Logical pixels of one line.
  float width_of(Type type, std::string_view line) const noexcept;
  /// Logical pixels of a text broken into lines of this width.
  float paragraph_height(Type type, std::string_view text, float width) const;
  Rect display() const noexcept { return display_; }
  double time_s() const noexcept { return time_s_; }
  Point pointer() const noexcept { return input_.pointer; }
  /// Since anybody last moved, pressed or typed anything.
  double untouched_s() const noexcept { return time_s_ - input_.touched_s; }
  /// What took the person's hands away since the last frame: the pointer left the window, keys go
  /// elsewhere.
  bool has_pointer_left() const noexcept { return input_.has_pointer_left; }
  bool has_lost_keys() const noexcept { return input_.has_lost_keys; }
  /// No pointer in this frame: something that it leads stands for it.
  void hide_pointer() noexcept { is_pointer_hidden_ = true; }
  /// The picture of this frame carries the pointer instead of the desktop: where it consists of two
  /// eyes' pictures, each has one at its place.
  void carry_pointer() noexcept { is_pointer_carried_ = true; }
  /// The area has the pointer from the next frame on, for as long as it asks again in each: no edge
  /// stops its way, buttons and wheel are the area's, and it is seen nowhere. Nothing where the
  /// window cannot do so.
  void capture_pointer(std::string_view area);
  /// The area that asked in the last finished frame; empty: none. The window follows it.
  const std::string& captured_by() const noexcept { return shown_capture_; }
  /// The window says that it cannot capture, or can again.
  void set_can_capture(bool can) noexcept { can_capture_ = can; }
  bool can_capture() const noexcept { return can_capture_; }
  Modifiers modifiers() const noexcept { return input_.modifiers; }
  bool is_motion_reduced() const noexcept { return is_motion_reduced_; }

  /// Registers a control and tells what happened to it. The caller fills id, label, rect, role and
  /// the flags.
  Response control(Widget widget);
  /// `takes_wheel`: it is turned by the wheel; else what it lies in scrolls.
  AreaResponse area(std::string_view id, std::string_view label, const Rect& rect,
                    bool takes_wheel = true);
  /// Tells accessibility tools and tests what stands there to be read; the caller draws it.
  void tell(std::string_view id, std::string_view text, const Rect& rect);
  /// Events for the field `id` in this frame, and what it remembers of its editing.
  std::vector<FieldEvent> field_events(const std::string& id) const;
  TextEdit& text_edit(const std::string& id);
  /// The path of what was dropped on the window in this frame, for the first field that asks;
  /// nothing from below a menu or a question.
  std::optional<std::string> take_dropped();
  Clipboard& clipboard() noexcept { return *clipboard_; }

  /// True once, in the frame in which the chord was pressed and nothing else took it. A chord that
  /// writes a letter does not come while a field has the focus; none comes from below a menu or a
  /// question. The label is listed under F1.
  bool shortcut(Chord chord, std::string_view label);
  /// The same for what goes on while its key is held: how often the keyboard repeated it since the
  /// last frame.
  int shortcut_repeats(Chord chord, std::string_view label);
  /// The key of this frame's shortcut was held already; what turns on and off does not listen to
  /// that.
  bool is_key_held_on() const noexcept { return input_.is_key_held_on; }
  const std::vector<Shortcut>& shortcuts() const noexcept { return shown_shortcuts_; }
  /// The same for the mouse: both ids of texts; listed under F1.
  void note_gesture(std::string_view input_id, std::string_view label_id) {
    building_gestures_.push_back(
        {std::string(text(input_id)), std::string(text(label_id)), canvas_->layer()});
  }
  const std::vector<MouseGesture>& gestures() const noexcept { return shown_gestures_; }

  void focus(std::string_view id);
  const std::string& focused() const noexcept { return input_.focus; }
  /// The ring is shown: the last thing done was done by key.
  bool is_steered_by_keys() const noexcept { return input_.is_ring_shown; }
  /// Gives `id` the focus when the screen or question it belongs to appears.
  void focus_first(std::string_view id);
  /// The focus was moved in this frame by an arrow held with Shift (lists extend their selection).
  bool focus_was_extended() const noexcept { return input_.is_focus_extended; }

  /// Opens a region that scrolls; everything until end_scroll lies in it. Returns how far it is
  /// scrolled down.
  float begin_scroll(std::string_view id, std::string_view label, const Rect& view,
                     float content_height);
  void end_scroll();
  /// Scrolls a region by so much, or so that what lies there comes to its top; as far as it goes.
  void scroll_by(std::string_view id, float distance);
  void scroll_to(std::string_view id, float offset);

  /// 0 to 1, moving towards 1 while `is_on` and back else, in `duration_s`; at once where motion is
  /// reduced.
  float eased(const std::string& id, bool is_on, float duration_s);
  /// Seconds that the pointer rests on the control.
  double hovered_for_s(std::string_view id) const noexcept;
  /// Asks for another frame in so many seconds at the latest.
  void want_frame_in_s(double seconds) noexcept;

 private:
  struct Motion {
    float value = 0.0F;
    bool is_touched = false;
  };
  struct ScrollState {
    float offset = 0.0F, content_height = 0.0F;
    Rect view;
    bool is_touched = false;
  };

  void build_fonts();
  void forget_last_frame();
  void settle_focus();
  void scroll_to_focus(const std::string& id, ScrollState& state);
  void draw_scroll_bar(const std::string& id, ScrollState& state);
  void settle_pointer();
  void tell_what_was_cut();

  const Texts* texts_;
  Clipboard* clipboard_;
  Theme theme_;
  float wanted_scale_;
  bool is_motion_reduced_ = false;
  int fonts_version_ = 0;
  struct ImGuiOwner;
  std::unique_ptr<ImGuiOwner> imgui_;
  std::unique_ptr<FontAtlas> fonts_;
  std::unique_ptr<Canvas> canvas_;

  Rect display_;
  double time_s_ = 0.0, last_time_s_ = 0.0, due_in_s_ = 0.0;
  FrameContent shown_, building_;
  std::vector<Rect> messages_at_;
  std::vector<Shortcut> shown_shortcuts_, building_shortcuts_;
  std::vector<MouseGesture> shown_gestures_, building_gestures_;

  Interaction input_;
  bool is_pointer_hidden_ = false, is_pointer_carried_ = false, can_capture_ = true;
  std::string building_capture_, shown_capture_;
  std::string first_focus_, shown_first_focus_;
  std::map<Layer, std::string> focus_below_;
  PointerShape pointer_shape_ = PointerShape::Arrow;

  std::map<std::string, Motion> motions_;
  std::map<std::string, TextEdit> edits_of_;
  std::map<std::string, ScrollState> scrolls_;
  std::vector<std::pair<std::string, int>> open_scrolls_;
};

}  // namespace hallux::ui
