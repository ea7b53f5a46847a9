/// The moment that a replay shows: played, scrubbed, stepped, by mouse and by keys.
/// Inside this corner only.
#pragma once

#include <vector>

#include "ui/widgets/ui.h"

namespace hallux::ui {

class Player {
 public:
  /// `event_s` ascending: where stepping by event stops.
  void open(double duration_s, std::vector<double> event_s, double now_s);

  double now_s() const noexcept { return now_s_; }
  bool is_playing() const noexcept { return is_playing_; }
  void seek(double time_s) noexcept;
  /// Stops, and shows that moment.
  void look_at(double time_s) noexcept;

  /// Lets the time since the last frame pass, and hears the keys.
  void advance(Ui& ui);
  /// Buttons, clock, speeds, and the keys that do the same where there is room for them.
  void draw(Ui& ui, const Rect& line);

  static constexpr float height = 44.0F;

 private:
  void play_or_pause() noexcept;
  void step(double by_s) noexcept;
  void to_event(bool is_forwards) noexcept;
  void change_speed(int by) noexcept;
  void hear_keys(Ui& ui);
  void draw_speeds(Ui& ui, Rect& rest);
  void draw_keys(Ui& ui, const Rect& room) const;

  double duration_s_ = 0.001, now_s_ = 0.0, last_frame_s_ = 0.0;
  std::vector<double> event_s_;
  bool is_playing_ = false;
  /// As it is listed; 3 is as it was.
  int speed_ = 3;
};

}  // namespace hallux::ui
