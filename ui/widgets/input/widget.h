/// What a frame consists of, as plain data: every control with its place, and every text that was
/// drawn.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ui/widgets/look/geometry.h"

namespace hallux::ui {

enum class Role : std::uint8_t { Button, Field, Option, Checkbox, Row, Link, Area, Scroll };

/// Layers from the bottom to the top. While something lies on Popup or Modal, what is below cannot
/// be reached.
enum class Layer : std::uint8_t { Page, Popup, Modal, Toast, Tooltip };
inline constexpr int layer_count = 5;

struct Widget {
  /// Unique in its frame: "sign_in.login".
  std::string id = {};
  /// What a person would call it; never the content of a field.
  std::string label = {};
  /// Where it is laid out, in logical pixels.
  Rect rect = {};
  /// The part of it inside every clip around it; empty where it is scrolled away.
  Rect visible = {};
  Role role = Role::Button;
  Layer layer = Layer::Page;
  bool is_enabled = true;
  /// Of what is not enabled: why, as people are told it.
  std::string why_off = {};
  bool is_focusable = true;
  /// What Enter does on this screen.
  bool is_primary = false;
  /// A field in which Enter makes a new line.
  bool takes_new_line = false;
  /// The place one is at; in a group the option that Tab goes to.
  bool is_chosen = false;
  /// Arrows move inside a group, Tab visits it once.
  std::string group = {};
  /// Arrows follow the order of the group, not the places: points of a chart.
  bool is_in_sequence = false;
  /// The scroll region it lies in, as an index of the frame's widgets.
  int scroll = -1;
  /// An area that a wheel turns; else the wheel is of the region it lies in.
  bool takes_wheel = false;
  /// Of a scroll region: how far it can still be scrolled up and down.
  float room_above = 0.0F, room_below = 0.0F;
  /// A field that has something to complete: Tab is for it, and not for the focus.
  bool takes_tab = false;
  /// Tab visits it after all that do not come late.
  bool comes_late = false;
};

/// A text as it was drawn.
struct SeenText {
  std::string text = {};
  /// Its ink's line box.
  Rect rect = {};
  /// What it had to stay inside.
  Rect room = {};
  /// The part of it inside every clip around it.
  Rect visible = {};
  Layer layer = Layer::Page;
  /// An ellipsis stands for the rest.
  bool is_shortened = false;
  bool may_be_shortened = false;
  /// The text before it was shortened; empty where it was not.
  std::string whole = {};
  /// What is told of it while the pointer rests on it, in place of the whole; or "".
  std::string hint = {};
  /// As it is drawn: 1 is whole, below it shows through.
  float presence = 1.0F;
  /// It follows what moves and gives way to messages; they do not flee from it.
  bool gives_way = false;
};

/// What a person reads off the screen, or is told to do: a measured value, a reason, a hint.
struct ReadOut {
  /// "operate.force"; unique in its frame.
  std::string id = {};
  std::string text = {};
  Rect rect = {};
  Layer layer = Layer::Page;
};

struct FrameContent {
  /// In the order of drawing, which is the order of Tab.
  std::vector<Widget> widgets = {};
  std::vector<ReadOut> read_outs = {};
  std::vector<SeenText> texts = {};
  /// The widget that keys go to; "" for none.
  std::string focus = {};
};

/// The widget with this id, or null.
const Widget* find_widget(const FrameContent& content, std::string_view id) noexcept;

/// The topmost enabled or disabled widget under `point` that is not a scroll region, on the layers
/// that can be reached; null where there is none.
const Widget* widget_at(const FrameContent& content, Point point) noexcept;

/// The innermost scroll region or area under `point` that a wheel turns by so many notches
/// (positive: upwards): a region that is at its end passes them on to the one around it. Null where
/// there is none.
const Widget* turned_at(const FrameContent& content, Point point, float notches) noexcept;

/// The lowest layer that can be reached: Page, unless a menu or a question lies above it.
Layer reachable_layer(const FrameContent& content) noexcept;

}  // namespace hallux::ui
