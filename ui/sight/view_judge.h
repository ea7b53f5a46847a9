/// Judges from where an operation is seen: what `scenario check` says of a start view, and what a
/// start view is searched with. Inside this corner only.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scenarios/plan.h"
#include "ui/render/visibility.h"

namespace hallux::ui {

/// What a start view must hold; see README.md of this room.
struct ViewLimits {
  double blade_angle_low_rad = 0.4363, blade_angle_high_rad = 0.7854;
  double least_share = 0.80;
};

struct ViewJudgement {
  /// Between the line of sight and the plane of the blade where it starts.
  double blade_angle_rad = 0.0;
  /// Blade and hub, where they start, in the part of the picture that no panel covers.
  bool is_saw_inside = false;
  /// Its handle leads to a lower corner: 20 to 70 degrees down from level.
  bool is_from_lower_corner = false;
  /// Means over the plan's strokes.
  Visibility mean;
  /// What hid the most over them.
  Hiders hiders;
};

/// Whether the first picture holds what it must, and whether all of it does.
bool holds_start(const ViewJudgement& judgement, const ViewLimits& limits = {}) noexcept;
/// Enough of teeth and kerf.
bool shows_cut(const ViewJudgement& judgement, const ViewLimits& limits = {}) noexcept;
bool is_good(const ViewJudgement& judgement, const ViewLimits& limits = {}) noexcept;

/// Over some moments.
struct SeenOver {
  Visibility mean;
  Hiders hiders;
};

/// A saw at work at one moment.
struct WorkMoment {
  RigidTransform world_from_tool;
  /// Of the plane at hand, as far as it is open.
  simulator::KerfOpening kerf;
};

class ViewJudge {
 public:
  /// The plan's strokes on the patient, sampled; the bone beside it stands where it does. Borrows
  /// nothing.
  /// errors  ScenarioError where a planned face misses the bone; GraphicsError
  /// needs   a current context, which lives longer
  ViewJudge(const scenarios::Scenario& scenario, simulator::Bones bones,
            const scenarios::Plan& plan, PixelSize size = {960, 600});
  ~ViewJudge();
  ViewJudge(const ViewJudge&) = delete;
  ViewJudge& operator=(const ViewJudge&) = delete;

  /// world_from_start  the saw's pose where the operation begins
  ViewJudgement judge(const Camera& camera, const RigidTransform& world_from_start);
  /// Only what the first picture says: the angle, and where the saw is; a thousandth of the time.
  ViewJudgement judge_start(const Camera& camera, const RigidTransform& world_from_start) const;
  /// The means over other moments than the plan's, as a recording's.
  SeenOver seen_over(const Camera& camera, const std::vector<WorkMoment>& moments);
  /// Those of the plan.
  const std::vector<WorkMoment>& moments() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hallux::ui
