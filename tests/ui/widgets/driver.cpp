#include "tests/ui/widgets/driver.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "ui/widgets/texts/text_layout.h"

namespace hallux::ui {
namespace {

/// What stands for a text that the catalogue has not.
constexpr std::string_view missing_text = "[missing text]";

[[noreturn]] void refuse(const std::string& fault) {
  ADD_FAILURE() << fault;
  throw std::runtime_error(fault);
}

std::string named(const FrameContent& content) {
  std::string names;
  for (const Widget& widget : content.widgets) names += " " + widget.id;
  return names;
}

void check_text(const SeenText& seen, std::vector<std::string>& faults) {
  if (seen.is_shortened && !seen.may_be_shortened)
    faults.push_back("cut off: \"" + seen.whole + "\" to \"" + seen.text + "\"");
  const bool leaves_across =
      seen.rect.x < seen.room.x - 1.5F || seen.rect.right() > seen.room.right() + 1.5F;
  const bool leaves_down =
      seen.rect.y < seen.room.y - 3.0F || seen.rect.bottom() > seen.room.bottom() + 3.0F;
  if (leaves_across || leaves_down) faults.push_back("outside its room: \"" + seen.text + "\"");
  if (seen.text.find('{') != std::string::npos)
    faults.push_back("a place without a value: \"" + seen.text + "\"");
  if (seen.text == missing_text) faults.push_back("a text that the catalogue has not");
}

}  // namespace

Driver::Driver(const Texts& texts, Draw draw, const DriverSetting& setting)
    : ui_(texts, clipboard_, setting.theme, setting.scale),
      draw_(std::move(draw)),
      width_(setting.width),
      height_(setting.height) {
  ui_.set_reduced_motion(setting.is_motion_reduced);
  frame();
  settle();
}

void Driver::frame(double seconds) {
  time_s_ += seconds;
  ui_.begin_frame(queue_, width_, height_, time_s_);
  draw_(ui_);
  ui_.end_frame();
}

void Driver::settle() {
  for (int count = 0; count < 200; ++count) {
    if (queue_.is_empty() && ui_.next_frame_in_s() > 0.0) return;
    frame();
  }
}

void Driver::wait(double seconds) {
  const double until_s = time_s_ + seconds;
  while (time_s_ + ui_.next_frame_in_s() < until_s)
    frame(std::max(ui_.next_frame_in_s(), 1.0 / 60.0));
  frame(std::max(until_s - time_s_, 0.0));
  settle();
}

InputEvent Driver::pointer_event(EventKind kind, Point logical, float scale) {
  InputEvent event;
  event.kind = kind;
  event.position = {logical.x * scale, logical.y * scale};
  return event;
}

const Widget& Driver::widget(std::string_view id) const {
  const Widget* found = find_widget(ui_.shown(), id);
  if (found == nullptr)
    refuse("no widget '" + std::string(id) + "'; there are:" + named(ui_.shown()));
  return *found;
}

// Turns the wheel over the region the widget lies in until it is in sight.
Point Driver::middle_of(std::string_view id) {
  for (int turn = 0; turn < 200; ++turn) {
    const Widget& target = widget(id);
    if (target.visible.h >= std::min(target.rect.h, 8.0F) && !target.visible.is_empty())
      return target.visible.centre();
    if (target.scroll < 0) break;
    const Widget& region = ui_.shown().widgets[static_cast<std::size_t>(target.scroll)];
    wheel(region.visible.centre(), target.rect.mid_y() > region.rect.mid_y() ? -1.0F : 1.0F);
  }
  refuse("the widget '" + std::string(id) + "' cannot be brought into sight");
}

void Driver::click(std::string_view id) {
  const Point place = middle_of(id);
  if (!widget(id).is_enabled) refuse("the widget '" + std::string(id) + "' is disabled");
  const Widget* under = widget_at(ui_.shown(), place);
  if (under == nullptr || under->id != id)
    refuse("'" + std::string(id) + "' is covered by '" +
           (under == nullptr ? "nothing" : under->id) + "'");
  send(click_events({place.x * ui_.scale(), place.y * ui_.scale()}));
  settle();
}

void Driver::double_click(std::string_view id) {
  const Point place = middle_of(id);
  for (int count = 0; count < 2; ++count)
    send(click_events({place.x * ui_.scale(), place.y * ui_.scale()}));
  settle();
}

void Driver::type(std::string_view text) {
  for (std::size_t place = 0; place < text.size();)
    queue_.push(character_event(next_code_point(text, place)));
  settle();
}

void Driver::press(Key key, Modifiers modifiers) {
  send(key_events(key, modifiers));
  settle();
}

/// Where an area has caught the pointer, it only goes the way.
InputEvent Driver::moved_to(Point place) {
  const Point way{place.x - pointer_.x, place.y - pointer_.y};
  pointer_ = place;
  const bool is_captured = !ui_.captured_by().empty();
  return pointer_event(is_captured ? EventKind::CapturedMoved : EventKind::PointerMoved,
                       is_captured ? way : place, ui_.scale());
}

void Driver::move_to(Point place) {
  queue_.push(moved_to(place));
  frame();
  settle();
}

void Driver::wheel(Point place, float notches) {
  InputEvent event = pointer_event(EventKind::Wheel, place, ui_.scale());
  event.wheel = notches;
  queue_.push(event);
  frame();
  frame();
  settle();
}

void Driver::drag(Point from, Point to, MouseButton button) {
  InputEvent press = pointer_event(EventKind::ButtonPressed, from, ui_.scale());
  InputEvent release = pointer_event(EventKind::ButtonReleased, to, ui_.scale());
  press.button = release.button = button;
  queue_.push(press);
  frame();
  pointer_ = from;
  queue_.push(moved_to(to));
  frame();
  queue_.push(release);
  frame();
  settle();
}

void Driver::send(const std::vector<InputEvent>& events) {
  for (const InputEvent& event : events) queue_.push(event);
}

void Driver::resize(float width, float height) {
  width_ = width;
  height_ = height;
  frame();
  settle();
}

bool Driver::sees(std::string_view words) const {
  for (const SeenText& seen : ui_.shown().texts)
    if (seen.text.find(words) != std::string::npos || seen.whole.find(words) != std::string::npos)
      return true;
  // A toast breaks its words into lines; its control says them whole.
  for (const Widget& widget : ui_.shown().widgets)
    if (widget.layer == Layer::Toast && widget.label.find(words) != std::string::npos) return true;
  return false;
}

std::vector<std::string> Driver::texts() const {
  std::vector<std::string> result;
  for (const SeenText& seen : ui_.shown().texts)
    result.push_back(seen.is_shortened ? seen.whole : seen.text);
  return result;
}

std::vector<std::string> Driver::faults() const {
  std::vector<std::string> faults;
  for (const SeenText& seen : ui_.shown().texts) check_text(seen, faults);
  for (const std::string& id : off_without_reason())
    faults.push_back("off without a reason: " + id);
  std::set<std::string> ids;
  for (const Widget& widget : ui_.shown().widgets) {
    if (!ids.insert(widget.id).second) faults.push_back("an id twice: " + widget.id);
    if (widget.visible.is_empty() && widget.scroll < 0)
      faults.push_back("out of sight: " + widget.id);
    if (widget.label.empty()) faults.push_back("without a label: " + widget.id);
  }
  return faults;
}

std::vector<std::string> Driver::off_without_reason() const {
  std::vector<std::string> ids;
  for (const Widget& widget : ui_.shown().widgets)
    if (!widget.is_enabled && (widget.why_off.empty() || widget.why_off == missing_text))
      ids.push_back(widget.id);
  return ids;
}

std::vector<std::string> Driver::covered_by_messages() const {
  constexpr float view_share = 0.4F;
  const FrameContent& shown = ui_.shown();
  const Rect display = ui_.display();
  const Layer lowest = reachable_layer(shown);
  std::vector<std::string> covered;
  for (const Widget& told : shown.widgets) {
    if (told.layer != Layer::Toast || told.role != Role::Area) continue;
    const auto note = [&](const std::string& what, Layer layer, const Rect& visible) {
      const bool counts = layer >= lowest && layer < Layer::Toast;
      if (counts && !intersection(told.visible, visible).is_empty())
        covered.push_back(told.id + " over " + what);
    };
    for (const Widget& widget : shown.widgets) {
      const bool is_view = widget.role == Role::Area &&
                           widget.visible.w * widget.visible.h > view_share * display.w * display.h;
      const bool is_beside = widget.visible.w >= display.w && widget.visible.h >= display.h;
      if (widget.role != Role::Scroll && !is_view && !is_beside)
        note(widget.id, widget.layer, widget.visible);
    }
    for (const SeenText& seen : shown.texts) note(seen.text, seen.layer, seen.visible);
  }
  return covered;
}

std::vector<InputEvent> key_events(Key key, Modifiers modifiers) {
  InputEvent press;
  press.kind = EventKind::KeyPressed;
  press.key = key;
  press.modifiers = modifiers;
  InputEvent release = press;
  release.kind = EventKind::KeyReleased;
  return {press, release};
}

InputEvent character_event(char32_t character) {
  InputEvent event;
  event.kind = EventKind::Character;
  event.character = character;
  return event;
}

std::vector<InputEvent> click_events(Point device, MouseButton button) {
  InputEvent move, press, release;
  move.kind = EventKind::PointerMoved;
  press.kind = EventKind::ButtonPressed;
  release.kind = EventKind::ButtonReleased;
  move.position = press.position = release.position = device;
  press.button = release.button = button;
  return {move, press, release};
}

}  // namespace hallux::ui
