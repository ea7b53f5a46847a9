// A lesson is passed by what is so, not by a key that was pressed: whoever starts the saw on the
// way to the block has learned it. The moves are the coach's; a lesson asks it only for its own.
#include "ui/screens/operating/flight/lesson_deeds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/base/units.h"
#include "ui/screens/operating/hud/operating_hud.h"
#include "ui/screens/operating/hud/plan_reading.h"

namespace hallux::ui {

namespace {

using scenarios::HeldCut;
using scenarios::PlannedCut;

constexpr double turn_goal_rad = 0.35, reach_goal_mm = 3.0, clear_goal_mm = 1.5;
/// A stroke through less than this of the section missed most of its pass.
constexpr double least_opened_share = 0.25;

/// Ids of texts, in the order of Lesson.
constexpr std::array<std::string_view, lesson_count> goal_texts{
    "flight.look.goal",     "flight.approach.goal", "flight.start.goal",   "flight.stroke.goal",
    "flight.withdraw.goal", "flight.second.goal",   "flight.take_out.goal"};

const HeldCut* held_of(const CoachView& view) {
  return view.site == nullptr ? nullptr : &view.site->cuts.front();
}

double opened_share(const CoachView& view) {
  const HeldCut* held = held_of(view);
  return held == nullptr ? 0.0 : 1.0 - held->share;
}

bool is_through(const CoachView& view) {
  const HeldCut* held = held_of(view);
  return held != nullptr && held->is_through();
}

/// The teeth are at the far side, and a good part of the section is open.
bool is_stroke_through(const CoachView& view) {
  if (is_through(view)) return true;
  return view.is_in_kerf && view.site != nullptr && !view.site->ahead.to_far_side_mm &&
         opened_share(view) >= least_opened_share;
}

double clear_mm(const CoachView& view) {
  return view.is_in_kerf || view.site == nullptr ? 0.0 : view.site->ahead.beside_mm;
}

double way_to_place_mm(const LessonView& view) {
  return length_of(place_to_reach_in_bone_mm(view) - view.sawing.bone_from_tool.translation_mm);
}

std::string percent_text(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }
std::string mm_text(double mm) { return decimal_text(mm) + " mm"; }
std::string degree_text(double rad) {
  return std::to_string(std::lround(degree_from_radian(rad))) + "°";
}

Hint look_hint(const LessonView& view) {
  Hint hint{.text_id = "flight.look.hint"};
  hint.values = {{"now", degree_text(view.turned_rad)}, {"goal", degree_text(turn_goal_rad)}};
  hint.move = HandMove::LookAround;
  return hint;
}

Hint start_hint() {
  Hint hint{.text_id = "flight.start.hint"};
  hint.move = HandMove::SwitchSaw;
  return hint;
}

/// As if the saw ran: whether it does is the next lesson.
std::optional<Hint> approach_hint(const LessonView& view) {
  CoachView running = view.sawing;
  running.is_saw_on = true;
  return next_hint(running);
}

Hint withdraw_hint(const CoachView& view) {
  const PlannedCut& cut = view.plan.cuts.front();
  const double depth_mm = read_passes(cut, view.passes.front(), view.bone_from_tool).depth_mm;
  return draw_back_hint("flight.withdraw.hint", std::max(1.0, depth_mm + clear_goal_mm + 0.5));
}

/// Where bone still holds, the way is to saw on.
std::optional<Hint> take_out_hint(const LessonView& view) {
  const bool holds = !is_through(view.sawing) && !view.taking_out.steps.is_ready();
  return next_hint(holds ? view.sawing : view.taking_out);
}

}  // namespace

LessonView lesson_view(const HudSources& from, const StepProgress& sawing,
                       const Quat& world_from_first_view) {
  const double cosine =
      std::min(1.0, std::abs(glm::dot(world_from_first_view, from.world_from_view)));
  return {coach_view(from, sawing), coach_view(from), 2.0 * std::acos(cosine)};
}

Vec3 place_to_reach_in_bone_mm(const LessonView& view) {
  const PlannedCut& cut = view.sawing.plan.cuts.front();
  const scenarios::PlannedPasses& passes = view.sawing.passes.front();
  const PassReading nearest = read_passes(cut, passes, view.sawing.bone_from_tool);
  return cut.entry_point_in_bone_mm + passes.middles_mm[nearest.pass] * passes.along_in_bone +
         0.5 * view.sawing.scenario.saw.blade.kerf_mm * cut.face.normal;
}

bool is_done(Lesson lesson, const LessonView& view) {
  switch (lesson) {
    case Lesson::Look:
      return view.turned_rad >= turn_goal_rad;
    case Lesson::Approach:
      return way_to_place_mm(view) <= reach_goal_mm || is_stroke_through(view.sawing);
    case Lesson::Start:
      return view.sawing.is_saw_on;
    case Lesson::Stroke:
      return is_stroke_through(view.sawing);
    case Lesson::Withdraw:
      return clear_mm(view.sawing) >= clear_goal_mm;
    case Lesson::SecondPass:
      return is_through(view.sawing);
    case Lesson::TakeOut:
      return !view.taking_out.steps.kind();
  }
  return false;
}

std::string goal_text(const Texts& texts, Lesson lesson, const LessonView& view) {
  const std::string_view id = goal_texts[static_cast<std::size_t>(lesson)];
  switch (lesson) {
    case Lesson::Look:
      return texts.say(
          id, {{"goal", degree_text(turn_goal_rad)}, {"now", degree_text(view.turned_rad)}});
    case Lesson::Approach:
      return texts.say(id,
                       {{"goal", mm_text(reach_goal_mm)}, {"now", mm_text(way_to_place_mm(view))}});
    case Lesson::Withdraw:
      return texts.say(id,
                       {{"goal", mm_text(clear_goal_mm)}, {"now", mm_text(clear_mm(view.sawing))}});
    case Lesson::Stroke:
    case Lesson::SecondPass:
      return texts.say(id, {{"now", percent_text(opened_share(view.sawing))}});
    case Lesson::Start:
    case Lesson::TakeOut:
      break;
  }
  return std::string(texts.text(id));
}

std::optional<Hint> lesson_hint(Lesson lesson, const LessonView& view) {
  if (view.sawing.is_paused) return std::nullopt;
  switch (lesson) {
    case Lesson::Look:
      return look_hint(view);
    case Lesson::Approach:
      return approach_hint(view);
    case Lesson::Start:
      return start_hint();
    case Lesson::Withdraw:
      return withdraw_hint(view.sawing);
    case Lesson::Stroke:
    case Lesson::SecondPass:
      return next_hint(view.sawing);
    case Lesson::TakeOut:
      break;
  }
  return take_out_hint(view);
}

}  // namespace hallux::ui
