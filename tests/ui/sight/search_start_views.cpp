// Tries directions around the site of each shipped operation and prints the best start views:
//     search_start_views [SCENARIO [RECORDINGS]]
//
// Those that see the strokes of the plan best are held against as many recordings of the expert's
// hand.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/scenarios/hands/scripted_attempt.h"
#include "tests/ui/sight/recorded_moments.h"
#include "tests/ui/sight/start_views.h"
#include "ui/render/gl/headless_context.h"

namespace {

using namespace hallux;
using namespace hallux::ui;

constexpr std::size_t shown = 40;

struct Found {
  StartView view;
  ViewJudgement judgement;
  double worth = 0.0;
};

/// The lesser share, and a little for a picture that stands upright, is near, and shows the blade
/// neither edge on nor flat.
double worth_of(const StartView& view, const ViewJudgement& judgement) {
  const double angle_deg = degree_from_radian(judgement.blade_angle_rad);
  return std::min(judgement.mean.tooth_line_share, judgement.mean.kerf_share) -
         0.004 * std::abs(angle_deg - 35.0) - 0.0004 * std::abs(degree_from_radian(view.roll_rad)) -
         0.004 * view.radius_mm;
}

Vec3 towards_viewer(const StartView& view) {
  const double flat = std::cos(view.elevation_rad);
  return Vec3(flat * std::cos(view.azimuth_rad), std::sin(view.elevation_rad),
              flat * std::sin(view.azimuth_rad));
}

/// Directions by ten degrees, turns by fifteen, five radii.
std::vector<StartView> all_views() {
  std::vector<StartView> views;
  for (int elevation = -30; elevation <= 85; elevation += 5) {
    for (int azimuth = -180; azimuth < 180; azimuth += 10) {
      for (int roll = -180; roll < 180; roll += 15) {
        for (const double radius_mm : {26.0, 29.0, 32.0, 35.0, 38.0}) {
          views.push_back({radian_from_degree(azimuth), radian_from_degree(elevation),
                           radian_from_degree(roll), radius_mm});
        }
      }
    }
  }
  return views;
}

/// What the expert's hand does, some moments of each recording.
std::vector<WorkMoment> expert_moments(const scenarios::Scenario& scenario,
                                       const simulator::Bone& bone, int recordings) {
  std::vector<WorkMoment> moments;
  for (int seed = 1; seed <= recordings; ++seed) {
    const simulator::Recording recording =
        tests::run_hand(scenario, bone, "expert", static_cast<std::uint64_t>(seed)).recording;
    const std::vector<WorkMoment> of_one =
        moments_of(recording, scenario.saw.blade, bone.world_from_bone, 2000);
    moments.insert(moments.end(), of_one.begin(), of_one.end());
  }
  return moments;
}

void print(const Found& found, const Visibility& expert) {
  std::printf(
      "  azimuth %4.0f elevation %4.0f roll %4.0f radius %2.0f: plane %4.1f deg, teeth %.3f, kerf "
      "%.3f; expert: teeth %.3f, kerf %.3f\n",
      degree_from_radian(found.view.azimuth_rad), degree_from_radian(found.view.elevation_rad),
      degree_from_radian(found.view.roll_rad), found.view.radius_mm,
      degree_from_radian(found.judgement.blade_angle_rad), found.judgement.mean.tooth_line_share,
      found.judgement.mean.kerf_share, expert.tooth_line_share, expert.kerf_share);
}

void search(const std::string& name, int recordings) {
  scenarios::Scenario scenario = scenarios::load_shipped_scenario(name);
  scenario.patient.edge_mm = 0.9;
  const simulator::Bone bone = make_patient(scenario);
  const scenarios::Plan plan = plan_on(scenario, bone);
  ViewJudge judge(scenario, bone, plan, {480, 300});
  const RigidTransform start = start_of(judge);
  const auto camera = [&](const StartView& view) {
    return camera_of(view, bone.world_from_bone, judge.site_in_bone_mm(), Viewer{}, 1.6);
  };
  std::vector<Found> found;
  for (const StartView& view : all_views()) {
    // From the side of the waste, which is what one watches.
    if (name == "silver" && glm::dot(towards_viewer(view), plan.cuts.front().face.normal) < 0.0)
      continue;
    const ViewJudgement first = judge.judge_start(camera(view), start);
    if (!holds_start(first)) continue;
    const ViewJudgement all = judge.judge(camera(view), start);
    found.push_back({view, all, worth_of(view, all)});
  }
  std::ranges::sort(found, [](const Found& a, const Found& b) { return a.worth > b.worth; });
  std::printf("%s: %zu views hold the start\n", name.c_str(), found.size());
  const std::vector<WorkMoment> expert = expert_moments(scenario, bone, recordings);
  for (std::size_t i = 0; i < std::min(found.size(), shown); ++i) {
    print(found[i], judge.seen_over(camera(found[i].view), expert));
  }
}

}  // namespace

int main(int count, char** words) {
  const HeadlessContext context;
  const int recordings = count > 2 ? std::atoi(words[2]) : 0;
  if (count > 1) {
    search(words[1], recordings);
    return 0;
  }
  for (const char* name : {"silver", "akin"}) search(name, recordings);
  return 0;
}
