/// The deed of each lesson, measured on hand, loop and site; and the move that comes next for it.
/// Inside this corner only.
#pragma once

#include <optional>
#include <string>

#include "ui/screens/operating/coach.h"
#include "ui/screens/operating/flight/flight_lessons.h"
#include "ui/screens/operating/hud_facts.h"

namespace hallux::ui {

/// What a lesson looks at; borrows what the coach's views borrow.
struct LessonView {
  /// At a step that saws the one cut of the block.
  CoachView sawing;
  /// At the step that takes its piece out.
  CoachView taking_out;
  /// Of the view, since the flight began.
  double turned_rad = 0.0;
};

/// sawing  steps of which the one at hand saws; outlives the view
/// world_from_first_view  of the view with which the flight began
LessonView lesson_view(const HudSources& from, const StepProgress& sawing,
                       const Quat& world_from_first_view);

/// The deed is done, or what it is for is so already.
bool is_done(Lesson lesson, const LessonView& view);

/// "Goal: ... Now: ...", with what is measured.
std::string goal_text(const Texts& texts, Lesson lesson, const LessonView& view);

/// Nothing where there is nothing to be done but to wait.
std::optional<Hint> lesson_hint(Lesson lesson, const LessonView& view);

/// Where the middle of the teeth is to meet the block.
Vec3 place_to_reach_in_bone_mm(const LessonView& view);

}  // namespace hallux::ui
