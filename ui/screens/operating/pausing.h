/// Running, paused, or waiting for room on the disk. Inside this corner only.
///
///     runs --pause--> paused --the disk is full--> waits for room
///       '<--go on-----' '<-------room again------------'
///
/// A full disk ends in a pause: nobody knows where the hand is by the time that there is room.
#pragma once

namespace hallux::ui {

/// The cause of a pause, as people are told it.
enum class PausedBy {
  Person,
  Locked,
  KeysLost,
  PointerLeft,
  Covered,
  Stillness,
  RoomAgain,
  DeviceLost
};

class Pausing {
 public:
  bool is_paused() const noexcept { return state_ != State::Runs; }
  bool is_storage_full() const noexcept { return state_ == State::WaitsForRoom; }
  /// The cause of the pause that began last.
  PausedBy by() const noexcept { return by_; }

  /// True where it ran until now.
  bool pause(PausedBy by) noexcept {
    if (is_paused()) return false;
    state_ = State::Paused;
    by_ = by;
    return true;
  }
  /// True where it was paused and goes on; without room on the disk it does not.
  bool go_on() noexcept {
    if (state_ != State::Paused) return false;
    state_ = State::Runs;
    return true;
  }
  /// needs   it is paused
  void wait_for_room() noexcept { state_ = State::WaitsForRoom; }
  void have_room() noexcept {
    state_ = State::Paused;
    by_ = PausedBy::RoomAgain;
  }

 private:
  enum class State { Runs, Paused, WaitsForRoom };

  State state_ = State::Runs;
  PausedBy by_ = PausedBy::Person;
};

}  // namespace hallux::ui
