#include "ui/screens/operating/hint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "simulator/base/units.h"
#include "simulator/device/mouse.h"
#include "ui/screens/operating/hand/steering.h"
#include "ui/screens/operating/hud/operating_hud.h"

namespace hallux::ui {

namespace {

using Led = simulator::SteeredDevice::Led;

/// A move in words: by keys, by the mouse, and by the hand that holds a device.
struct MoveTexts {
  HandMove move;
  std::string_view keys_id, mouse_id;
  std::string_view hand_id = {};
  /// A device that turns nothing itself is turned by the window.
  bool is_turn = false;
};

constexpr std::array<MoveTexts, 25> move_texts{{
    {HandMove::Left, "move.left.keys", "move.left.mouse", "move.left.hand"},
    {HandMove::Right, "move.right.keys", "move.right.mouse", "move.right.hand"},
    {HandMove::Up, "move.up.keys", "move.up.mouse", "move.up.hand"},
    {HandMove::Down, "move.down.keys", "move.down.mouse", "move.down.hand"},
    {HandMove::Push, "move.push.keys", "move.push.mouse", "move.push.hand"},
    {HandMove::DrawBack, "move.draw_back.keys", "move.draw_back.mouse", "move.draw_back.hand"},
    {HandMove::TurnLeft, "move.turn_left.keys", "move.turn_left.mouse", "move.turn_left.hand",
     true},
    {HandMove::TurnRight, "move.turn_right.keys", "move.turn_right.mouse", "move.turn_right.hand",
     true},
    {HandMove::TurnUp, "move.turn_up.keys", "move.turn_up.mouse", "move.turn_up.hand", true},
    {HandMove::TurnDown, "move.turn_down.keys", "move.turn_down.mouse", "move.turn_down.hand",
     true},
    {HandMove::RollLeft, "move.roll_left.keys", "move.roll_left.mouse", "move.roll_left.hand",
     true},
    {HandMove::RollRight, "move.roll_right.keys", "move.roll_right.mouse", "move.roll_right.hand",
     true},
    {HandMove::Nearer, "move.nearer.keys", "move.nearer.mouse", "move.nearer.hand"},
    {HandMove::Deeper, "move.deeper.keys", "move.deeper.mouse", "move.deeper.hand"},
    {HandMove::SwitchSaw, "move.saw.keys", "move.saw.mouse"},
    {HandMove::SwitchWater, "move.water.keys", "move.water.mouse"},
    {HandMove::LookAround, "move.look.keys", "move.look.mouse"},
    {HandMove::ResetView, "move.reset_view.keys", "move.reset_view.mouse"},
    {HandMove::PressStep, "move.step.keys", "move.step.mouse"},
    {HandMove::TakeUpStep, "move.take_up.keys", "move.take_up.mouse"},
    {HandMove::OpenTray, "move.tray.keys", "move.tray.mouse"},
    {HandMove::WorkForceps, "move.forceps.keys", "move.forceps.mouse"},
    {HandMove::DriveHome, "move.drive_home.keys", "move.drive_home.mouse"},
    {HandMove::LeaveOrTake, "move.leave.keys", "move.leave.mouse"},
    {HandMove::Wait, "move.wait", "move.wait"},
}};

/// The hand on the device makes it, not keys and mouse.
bool is_by_hand(const MoveTexts& move, Led led) noexcept {
  if (led == Led::Pose || move.hand_id.empty()) return false;
  return led == Led::Nothing || !move.is_turn;
}

/// The wheel makes them; a notch goes as far as a key press (hand/steering).
constexpr std::array wheel_moves{HandMove::Push,      HandMove::DrawBack, HandMove::RollLeft,
                                 HandMove::RollRight, HandMove::Nearer,   HandMove::Deeper};
constexpr std::array plain_moves{HandMove::Left, HandMove::Right, HandMove::Up, HandMove::Down};
/// A drag makes them. Of few pixels it would be a click, so that few degrees take Shift: 3 degrees
/// are 12 pixels without it and 58 with it.
constexpr std::array drag_moves{HandMove::TurnLeft, HandMove::TurnRight, HandMove::TurnUp,
                                HandMove::TurnDown};
constexpr double fine_drag_deg = 3.5;

std::string keys_text(const Texts& texts, const Hint& hint, const MoveTexts& move) {
  std::string keys;
  if (hint.is_fine) keys = std::string(texts.text("key.shift")) + "+";
  keys += texts.text(move.keys_id);
  if (hint.times == 1) return keys;
  return texts.say("operate.hint.times", {{"keys", keys}, {"count", std::to_string(hint.times)}});
}

bool is_among(HandMove move, std::span<const HandMove> moves) noexcept {
  return std::ranges::find(moves, move) != moves.end();
}

/// With how far it goes: a key press is a notch, a millimetre or a degree. A plain move needs no
/// Shift: it goes as finely as the hand does.
std::string mouse_text(const Texts& texts, const Hint& hint, const MoveTexts& move) {
  const double steps = hint.times * (hint.is_fine ? simulator::fine_share : 1.0);
  std::string mouse = texts.say(move.mouse_id, hint.values);
  bool has_shift = false;
  if (is_among(hint.move, plain_moves)) {
    mouse = texts.say("operate.hint.way",
                      {{"mouse", mouse}, {"way", decimal_text(steps * key_step_mm)}});
  } else if (is_among(hint.move, wheel_moves)) {
    mouse = texts.say_count("operate.hint.notches", hint.times, {{"mouse", mouse}});
    has_shift = hint.is_fine;
  } else if (is_among(hint.move, drag_moves)) {
    const double turn_deg = degree_from_radian(steps * key_turn_rad);
    mouse = texts.say("operate.hint.turn", {{"mouse", mouse}, {"angle", decimal_text(turn_deg)}});
    has_shift = turn_deg < fine_drag_deg;
  }
  return has_shift ? texts.say("operate.hint.fine", {{"mouse", mouse}}) : mouse;
}

}  // namespace

Hint draw_back_hint(std::string_view text_id, double way_mm) {
  Hint hint{.text_id = text_id};
  hint.values = {{"way", decimal_text(std::max(0.0, way_mm)) + " mm"}};
  hint.move = HandMove::DrawBack;
  hint.times = std::clamp(static_cast<int>(std::ceil(way_mm)), 1, 30);
  hint.read_outs = {"ahead"};
  return hint;
}

Hint press_hint(std::string_view text_id) {
  Hint hint{.text_id = text_id};
  hint.move = HandMove::PressStep;
  hint.read_outs = {"step"};
  return hint;
}

Hint switch_hint(std::string_view text_id, HandMove which) {
  Hint hint{.text_id = text_id};
  hint.move = which;
  return hint;
}

std::string hint_text(const Texts& texts, const Hint& hint, Led led) {
  std::string what = texts.say(hint.text_id, hint.values);
  const auto* move = std::find_if(move_texts.begin(), move_texts.end(),
                                  [&](const MoveTexts& each) { return each.move == hint.move; });
  if (move == move_texts.end() || hint.move == HandMove::Wait) return what;
  if (is_by_hand(*move, led)) {
    return what + " " +
           texts.say("operate.hint.by_hand", {{"hand", std::string(texts.text(move->hand_id))}});
  }
  return what + " " +
         texts.say("operate.hint.by", {{"keys", keys_text(texts, hint, *move)},
                                       {"mouse", mouse_text(texts, hint, *move)}});
}

}  // namespace hallux::ui
