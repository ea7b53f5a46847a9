/// The lessons of the first flight: the one at hand, and how the others ended.
/// Inside this corner only.
///
///     look -> approach -> start -> stroke -> withdraw -> second pass -> take out -> over
///       each by its deed, or skipped;  '<--------- begin again, on an uncut block
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hallux::ui {

enum class Lesson : std::uint8_t { Look, Approach, Start, Stroke, Withdraw, SecondPass, TakeOut };
inline constexpr std::size_t lesson_count = 7;

enum class LessonEnd : std::uint8_t { Open, Done, Skipped };

class FlightLessons {
 public:
  bool are_over() const noexcept { return number_ == lesson_count; }
  /// From 0; the count of lessons after the last.
  std::size_t number() const noexcept { return number_; }
  /// needs   not over
  Lesson at_hand() const noexcept { return static_cast<Lesson>(number_); }
  LessonEnd end_of(Lesson lesson) const noexcept { return ends_[static_cast<std::size_t>(lesson)]; }

  /// Ends the one at hand; the next is at hand.
  /// needs   not over
  void end(LessonEnd how) noexcept { ends_[number_++] = how; }
  /// The block is uncut again: all that is done to it is to be done again.
  void begin_again() noexcept {
    while (number_ > static_cast<std::size_t>(Lesson::Approach)) ends_[--number_] = LessonEnd::Open;
  }

 private:
  std::array<LessonEnd, lesson_count> ends_{};
  std::size_t number_ = 0;
};

}  // namespace hallux::ui
