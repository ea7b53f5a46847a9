/// All that a replay shows of one attempt, loaded and computed once. Inside this corner only.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "database/records/score.h"
#include "scenarios/plan.h"
#include "ui/screens/parts/attempt_desks.h"
#include "ui/screens/parts/attempt_timeline.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/pictures/planned_frame.h"
#include "ui/screens/replay/history_picture.h"
#include "ui/screens/replay/seen_views.h"
#include "ui/screens/replay/tool_at_moment.h"
#include "ui/widgets/charts/timeline.h"
#include "ui/window/shell/background.h"

namespace hallux::ui {

/// What the hand did at one moment. What is not known there is not a number.
struct HandAtMoment {
  /// Of saw or driver; while forceps hold a piece, of the piece.
  RigidTransform world_from_tool;
  ToolAtMoment tool;
  bool is_running = false, is_paused = false;
  double force_newton = 0.0, speed_mm_s = 0.0;
  ToPlan to_plan;
};

/// Along the time, x in seconds; no more points than a wide window has pixels.
struct Curves {
  std::vector<ChartPoint> force_newton, to_plan_mm;
};

struct ReplayMaterial {
  database::AttemptHeader header;
  AttemptRights rights;
  std::optional<database::ScoreCard> card;
  scenarios::Scenario scenario;
  scenarios::Plan plan;
  /// By cut of the plan.
  std::vector<PlannedFace> faces;
  simulator::Tray tray;
  RigidTransform world_from_bone;
  Vec3 middle_in_bone_mm{0.0, 0.0, 0.0};
  double radius_mm = 30.0;
  std::vector<simulator::ToolSample> samples;
  std::vector<AttemptEvent> events;
  std::vector<TimelineStep> steps;
  /// Of all of it.
  Curves curves;
  SeenViews seen;
  double duration_s = 0.001;
  std::shared_ptr<const HistoryPicture> bone;
};

/// errors  DatabaseError, ScenarioError, MeshError; Cancelled
/// thread  work's; seconds
std::shared_ptr<const ReplayMaterial> load_replay(SignedInSession& signed_in,
                                                  const database::AttemptId& id,
                                                  WorkReport& report);

/// The same of the expert hand's attempt, which is made for it in memory and is nobody's: without
/// rights, and with a header that has no id.
/// directory  of the data, whose cache knows how the bone looks
/// errors  ScenarioError, MeshError; Cancelled
/// thread  work's; tens of seconds
std::shared_ptr<const ReplayMaterial> make_replay(const scenarios::Scenario& scenario,
                                                  const std::filesystem::path& directory,
                                                  WorkReport& report);

/// Of the samples in that range, as fine as they are where it is short. The way to the plan is the
/// saw's: while something else is in the hand there is none.
Curves curves_of(const ReplayMaterial& material, const TimeRange& range);

/// The hand at the sample of that moment, or at the last one before it; borrows from the material.
HandAtMoment hand_at(const ReplayMaterial& material, double time_s) noexcept;

}  // namespace hallux::ui
