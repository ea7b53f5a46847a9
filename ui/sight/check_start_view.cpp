#include "ui/sight/check_start_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/scenario_error.h"
#include "ui/render/gl/graphics_error.h"
#include "ui/render/gl/headless_context.h"
#include "ui/sight/start_place.h"

namespace hallux::ui {

namespace {

/// What hides, and the key of the start that mends it.
struct Culprit {
  std::size_t count = 0;
  const char *what = "", *mend = "";
};

Culprit worst_of(const Hiders& hiders) {
  constexpr const char* turn = "choose another eye_in_bone";
  const std::array<Culprit, 4> culprits{
      Culprit{hiders.bone, "the bone", turn}, Culprit{hiders.blade, "the blade", turn},
      Culprit{hiders.handpiece, "the handpiece", turn},
      Culprit{hiders.outside_picture, "the picture's edge", "raise radius_mm"}};
  return *std::ranges::max_element(culprits, {}, &Culprit::count);
}

std::string percent(double share) {
  return std::to_string(std::lround(std::floor(100.0 * share))) + " %";
}

/// A scenario that says no start opens with the operator's view all the same.
void refuse_where_hidden(const ViewJudgement& judgement, std::string_view file, bool is_default) {
  if (shows_cut(judgement)) return;
  const Culprit worst = worst_of(judgement.hiders);
  const std::string_view which = is_default
                                     ? ": no start is said, and the default view hides the cut: "
                                     : ": start: this view hides its own cut: ";
  const std::string mend = (is_default ? "say a start: " : "") + std::string(worst.mend);
  throw scenarios::ScenarioError(std::string(file) + std::string(which) +
                                 percent(judgement.mean.tooth_line_share) + " of the teeth and " +
                                 percent(judgement.mean.kerf_share) +
                                 " of the kerf are seen over the planned strokes, at least " +
                                 percent(ViewLimits{}.least_share) + " are asked for, and " +
                                 worst.what + " hides the most; " + mend);
}

}  // namespace

StartViewCheck check_start_view(const scenarios::Scenario& scenario, simulator::Bones bones,
                                const scenarios::Plan& plan, std::string_view file) {
  StartViewCheck check;
  check.is_default = !scenario.start;
  try {
    const HeadlessContext context;
    ViewJudge judge(scenario, bones, plan);
    check.judgement =
        judge.judge(start_camera(scenario, bones, plan), start_pose(scenario, bones, plan));
  } catch (const GraphicsError& error) {
    check.why_not_drawn = error.what();
    return check;
  }
  refuse_where_hidden(*check.judgement, file, check.is_default);
  return check;
}

}  // namespace hallux::ui
