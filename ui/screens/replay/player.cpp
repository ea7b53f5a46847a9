#include "ui/screens/replay/player.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

constexpr std::array<double, 6> speeds{0.1, 0.25, 0.5, 1.0, 2.0, 4.0};
constexpr std::array<std::string_view, 6> speed_texts{"0.1\xC3\x97", "0.25\xC3\x97", "0.5\xC3\x97",
                                                      "1\xC3\x97",   "2\xC3\x97",    "4\xC3\x97"};
constexpr double sample_s = 0.001, second_s = 1.0, ten_seconds_s = 10.0;
/// Two moments nearer than this are the same one.
constexpr double same_s = 0.0005;

}  // namespace

void Player::open(double duration_s, std::vector<double> event_s, double now_s) {
  duration_s_ = duration_s;
  event_s_ = std::move(event_s);
  look_at(now_s);
}

void Player::seek(double time_s) noexcept { now_s_ = std::clamp(time_s, 0.0, duration_s_); }

void Player::look_at(double time_s) noexcept {
  is_playing_ = false;
  seek(time_s);
}

void Player::play_or_pause() noexcept {
  is_playing_ = !is_playing_;
  if (is_playing_ && now_s_ >= duration_s_) now_s_ = 0.0;
}

void Player::step(double by_s) noexcept { look_at(now_s_ + by_s); }

void Player::to_event(bool is_forwards) noexcept {
  if (is_forwards) {
    const auto next = std::upper_bound(event_s_.begin(), event_s_.end(), now_s_ + same_s);
    look_at(next == event_s_.end() ? duration_s_ : *next);
    return;
  }
  const auto next = std::lower_bound(event_s_.begin(), event_s_.end(), now_s_ - same_s);
  look_at(next == event_s_.begin() ? 0.0 : *std::prev(next));
}

void Player::change_speed(int by) noexcept {
  speed_ = std::clamp(speed_ + by, 0, static_cast<int>(speeds.size()) - 1);
}

void Player::advance(Ui& ui) {
  const double passed_s = ui.time_s() - std::exchange(last_frame_s_, ui.time_s());
  hear_keys(ui);
  if (!is_playing_) return;
  seek(now_s_ + passed_s * speeds[static_cast<std::size_t>(speed_)]);
  if (now_s_ >= duration_s_) is_playing_ = false;
  ui.want_frame_in_s(0.0);
}

void Player::hear_keys(Ui& ui) {
  if (ui.shortcut({Key::Space}, ui.text("replay.play"))) play_or_pause();
  if (ui.shortcut({Key::Period}, ui.text("replay.sample_next"))) step(sample_s);
  if (ui.shortcut({Key::Comma}, ui.text("replay.sample_before"))) step(-sample_s);
  if (ui.shortcut({Key::N}, ui.text("replay.event_next"))) to_event(true);
  if (ui.shortcut(with_shift(Key::N), ui.text("replay.event_before"))) to_event(false);
  if (ui.shortcut({Key::Right}, ui.text("replay.second_next"))) step(second_s);
  if (ui.shortcut({Key::Left}, ui.text("replay.second_before"))) step(-second_s);
  if (ui.shortcut(with_shift(Key::Right), ui.text("replay.ten_next"))) step(ten_seconds_s);
  if (ui.shortcut(with_shift(Key::Left), ui.text("replay.ten_before"))) step(-ten_seconds_s);
  if (ui.shortcut({Key::RightBracket}, ui.text("replay.faster"))) change_speed(1);
  if (ui.shortcut({Key::LeftBracket}, ui.text("replay.slower"))) change_speed(-1);
  if (ui.shortcut({Key::Home}, ui.text("replay.to_begin"))) look_at(0.0);
  if (ui.shortcut({Key::End}, ui.text("replay.to_end"))) look_at(duration_s_);
}

void Player::draw(Ui& ui, const Rect& line) {
  Rect rest = line;
  const auto square = [&](float gap) {
    const Rect place = take_left(rest, 36.0F, gap);
    return Rect{place.x, place.mid_y() - 18.0F, 36.0F, 36.0F};
  };
  if (icon_button(ui, "replay.before", square(4.0F), {ui.text("replay.event_before"), Icon::Back}))
    to_event(false);
  const IconButtonSpec play{ui.text(is_playing_ ? "replay.pause" : "replay.play"),
                            is_playing_ ? Icon::Pause : Icon::Play, true};
  if (icon_button(ui, "replay.play", square(4.0F), play)) play_or_pause();
  if (icon_button(ui, "replay.next", square(16.0F), {ui.text("replay.event_next"), Icon::Next}))
    to_event(true);
  const std::string now = clock_tenths_text(now_s_);
  const std::string of = ui.texts().say("replay.of", {{"duration", clock_text(duration_s_)}});
  // The clock's room does not change with its digits: they are all equally wide.
  const float now_width = ui.width_of(Type::BodyStrong, now) + 2.0F;
  ui.canvas().text_in(take_left(rest, now_width, 8.0F), {Type::BodyStrong, ui.theme().text}, now);
  ui.canvas().text_in(take_left(rest, ui.width_of(Type::Small, of) + 2.0F, 20.0F),
                      {Type::Small, ui.theme().text_caption}, of);
  draw_speeds(ui, rest);
  draw_keys(ui, rest);
}

/// Side by side where there is room, else the one that is, pressed for the next.
void Player::draw_speeds(Ui& ui, Rect& rest) {
  const float width = segmented_width(ui, speed_texts);
  if (rest.w >= width) {
    const Rect place = take_left(rest, width, 24.0F);
    segmented(ui, "replay.speed", {place.x, place.mid_y() - 17.0F, place.w, 34.0F}, speed_texts,
              speed_);
    return;
  }
  const ButtonSpec speed{speed_texts[static_cast<std::size_t>(speed_)]};
  const float one = button_width(ui, speed);
  if (rest.w < one) return;
  const Rect place = take_left(rest, one, 24.0F);
  if (!button(ui, "replay.speed", {place.x, place.mid_y() - 17.0F, place.w, 34.0F}, speed)) return;
  speed_ = (speed_ + 1) % static_cast<int>(speeds.size());
  ui.want_frame_in_s(0.0);
}

void Player::draw_keys(Ui& ui, const Rect& room) const {
  const std::array<std::pair<std::string_view, std::string_view>, 3> keys{{
      {ui.text("key.space"), ui.text("replay.keys.play")},
      {".", ui.text("replay.keys.sample")},
      {"N", ui.text("replay.keys.event")},
  }};
  float width = 0.0F;
  for (const auto& [key, words] : keys)
    width += key_chip_width(ui, key) + ui.width_of(Type::Small, words) + 28.0F;
  if (width > room.w) return;
  Point at{room.right() - width + 20.0F, room.mid_y()};
  for (const auto& [key, words] : keys) {
    at.x += key_chip(ui, at, key) + 8.0F;
    at.x += ui.canvas().text(at, {Type::Small, ui.theme().text_secondary}, words) + 20.0F;
  }
}

}  // namespace hallux::ui
