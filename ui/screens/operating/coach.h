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
#include "ui/screens/operating/hand/tools_in_hand.h"
#include "ui/screens/operating/hint.h"
#include "ui/screens/operating/site/site_survey.h"
#include "ui/screens/operating/step_progress.h"

namespace hallux::ui {

/// What the coach looks at; all borrowed.
struct CoachView {
  const scenarios::Scenario& scenario;
  const scenarios::Plan& plan;
  /// By the plan's cuts.
  const std::vector<scenarios::PlannedPasses>& passes;
  const StepProgress& steps;
  /// Null before it is known.
  const SiteFacts* site = nullptr;
  /// Null where a saw is all there is.
  const ToolsInHand* tools = nullptr;
  RigidTransform bone_from_tool;
  /// Axes of the person's view: x right, y up, z to the person.
  Quat bone_from_view{1.0, 0.0, 0.0, 0.0};
  /// A saw, or the drive of another tool.
  bool is_saw_on = false;
  bool is_irrigated = false;
  bool is_in_kerf = false, is_in_bore = false, is_paused = false;
  /// Teeth or a tip touch bone.
  bool is_touching = false;
  double force_newton = 0.0;
};

/// The cut that is to be sawn in a step; nullptr where there is none.
const scenarios::PlannedCut* cut_of_step(const CoachView& view);

/// The step that is taken up again: while a part is to come out that of the first cut that is known
/// to hold, else the last one before. Nothing where none can be.
std::optional<std::size_t> step_to_take_up(const CoachView& view);

/// The blade in the hand; while another tool is, the first of the scenario.
const simulator::Blade& blade_of(const CoachView& view) noexcept;

/// Nothing where there is nothing to be done.
std::optional<Hint> next_hint(const CoachView& view);

}  // namespace hallux::ui
