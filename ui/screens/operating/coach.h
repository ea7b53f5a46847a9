/// The next thing to do, in practice: which read-out is to come where, and the hand that brings it
/// there.
///
///     step at hand --> tilt --> place --> saw on --> push --> through --> draw back --> done
///                        ^----------- another pass, where bone still holds -'
///
/// It looks at what a person can read off the screen, knows no operation by name, and asks for one
/// move at a time: the one that brings the read-outs nearest to their goals.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/site/planned_passes.h"
#include "simulator/device/steered_device.h"
#include "ui/screens/operating/hud/cut_bands.h"
#include "ui/screens/operating/hud/plan_reading.h"
#include "ui/screens/operating/hud/push_range.h"
#include "ui/screens/operating/site/site_survey.h"
#include "ui/screens/operating/step_progress.h"
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
  SwitchSaw,
  LookAround,
  ResetView,
  PressStep,
  TakeUpStep,
  Wait
};

struct Hint {
  /// Of the sentence, as the id of a text, and its values.
  std::string_view text_id;
  TextValues values = {};
  HandMove move = HandMove::Wait;
  /// How often a key is to be pressed, about.
  int times = 1;
  /// A fifth of the way: Shift.
  bool is_fine = false;
  /// The push that is asked for, where one is.
  std::optional<PushRange> push = {};
  /// Of the read-outs that are to come nearer to their goals: ids without "operate.".
  std::vector<std::string_view> read_outs = {};
};

/// What the coach looks at; all borrowed.
struct CoachView {
  const scenarios::Scenario& scenario;
  const scenarios::Plan& plan;
  /// By the plan's cuts.
  const std::vector<scenarios::PlannedPasses>& passes;
  const StepProgress& steps;
  /// Null before it is known.
  const SiteFacts* site = nullptr;
  RigidTransform bone_from_tool;
  /// Axes of the person's view: x right, y up, z to the person.
  Quat bone_from_view{1.0, 0.0, 0.0, 0.0};
  bool is_saw_on = false, is_in_kerf = false, is_paused = false;
  double force_newton = 0.0;
};

/// The cut that is to be sawn in a step; nullptr where there is none.
const scenarios::PlannedCut* cut_of_step(const CoachView& view);

/// The step that is taken up again: while a part is to come out that of the first cut that is known
/// to hold, else the last one before. Nothing where none can be.
std::optional<std::size_t> step_to_take_up(const CoachView& view);

/// Nothing where there is nothing to be done.
std::optional<Hint> next_hint(const CoachView& view);

/// Out of the bone's way, by so much.
/// text_id  with {way} in it
Hint draw_back_hint(std::string_view text_id, double way_mm);

/// "Tilt along is +4.9: ... Keys: Ctrl+Down. Mouse: left drag down."; of what the hand does that
/// holds a device, with the hand.
/// led  what the window leads of the saw
std::string hint_text(const Texts& texts, const Hint& hint,
                      simulator::SteeredDevice::Led led = simulator::SteeredDevice::Led::Pose);

}  // namespace hallux::ui
