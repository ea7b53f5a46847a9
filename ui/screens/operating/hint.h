/// A hint: what to do next, in words that name read-outs, and the move of the hand that does it.
/// Inside this corner only.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/device/steered_device.h"
#include "ui/screens/operating/hud/push_range.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {

/// A move of the hand, as keys and mouse make it.
enum class HandMove {
  None,
  Left,
  Right,
  Up,
  Down,
  Push,
  DrawBack,
  TurnLeft,
  TurnRight,
  TurnUp,
  TurnDown,
  RollLeft,
  RollRight,
  Nearer,
  Deeper,
  SwitchSaw,
  SwitchWater,
  LookAround,
  ResetView,
  PressStep,
  TakeUpStep,
  OpenTray,
  WorkForceps,
  DriveHome,
  LeaveOrTake,
  Wait
};

struct Hint {
  /// Of the sentence, as the id of a text, and its values.
  std::string_view text_id;
  TextValues values = {};
  HandMove move = HandMove::Wait;
  /// How often a key is to be pressed, or by how many notches the wheel turned, about.
  int times = 1;
  /// A fifth of the way: Shift.
  bool is_fine = false;
  /// On the tray, of the tool that is to be taken.
  std::optional<std::int32_t> place = {};
  /// The push that is asked for, where one is.
  std::optional<PushRange> push = {};
  /// Of the read-outs that are to come nearer to their goals: ids without "operate.".
  std::vector<std::string_view> read_outs = {};
};

/// Out of the bone's way, by so much.
/// text_id  with {way} in it
Hint draw_back_hint(std::string_view text_id, double way_mm);

/// "Tilt along is +4.9: ... Keys: Ctrl+Down, 5 times. Mouse: drag down with the left button by
/// 5.0°.", of a wheel with its notches; of what the hand does that holds a device, with the hand.
/// led  what the window leads of the saw
std::string hint_text(const Texts& texts, const Hint& hint,
                      simulator::SteeredDevice::Led led = simulator::SteeredDevice::Led::Pose);

/// Presses that button.
Hint press_hint(std::string_view text_id);
/// The drive, on or off; or the water.
Hint switch_hint(std::string_view text_id, HandMove which = HandMove::SwitchSaw);

}  // namespace hallux::ui
