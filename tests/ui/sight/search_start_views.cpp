// Tries directions around the site of each shipped operation and prints the best start views:
//     search_start_views [SCENARIO|FILE [RECORDINGS]]
//
// Those that see the strokes of the plan best are held against as many recordings of the expert's
// hand; of several bones there are none.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "simulator/base/units.h"
#include "tests/scenarios/hands/scripted_attempt.h"
#include "tests/ui/sight/recorded_moments.h"
#include "ui/render/gl/headless_context.h"
#include "ui/sight/start_place.h"
#include "ui/sight/view_judge.h"

namespace {

using namespace hallux;
using namespace hallux::ui;

constexpr std::size_t shown = 40;

/// A direction from the site to the eye, and how the picture is turned about it.
struct Looking {
  double azimuth_rad = 0.0, elevation_rad = 0.0, roll_rad = 0.0, radius_mm = 30.0;
};

struct Found {
  scenarios::StartingPlace place;
  Looking looking;
  ViewJudgement judgement;
  double worth = 0.0;
};

/// A little for a picture that stands upright, is near, and shows the blade neither edge on nor
/// flat.
double worth_of_start(const Looking& looking, const ViewJudgement& judgement) {
  const double angle_deg = degree_from_radian(judgement.blade_angle_rad);
  return -0.004 * std::abs(angle_deg - 35.0) -
         0.0004 * std::abs(degree_from_radian(looking.roll_rad)) - 0.004 * looking.radius_mm;
}

double lesser_share(const Visibility& seen) {
  return std::min(seen.tooth_line_share, seen.kerf_share);
}

/// At no roll dorsal is up; the roll turns the picture clockwise as the viewer sees it.
void look(scenarios::StartingPlace& place, const Looking& looking) {
  const double flat = std::cos(looking.elevation_rad);
  place.eye_in_bone = Vec3(flat * std::cos(looking.azimuth_rad), std::sin(looking.elevation_rad),
                           flat * std::sin(looking.azimuth_rad));
  const Vec3 right = glm::normalize(glm::cross(Vec3(0.0, 1.0, 0.0), place.eye_in_bone));
  const Vec3 up = glm::cross(place.eye_in_bone, right);
  place.up_in_bone = std::cos(looking.roll_rad) * up - std::sin(looking.roll_rad) * right;
  place.radius_mm = looking.radius_mm;
}

/// Turns by fifteen degrees, five radii.
std::vector<Looking> turns_of(double azimuth_rad, double elevation_rad) {
  std::vector<Looking> turns;
  for (int roll = -180; roll < 180; roll += 15) {
    for (const double radius_mm : {24.0, 27.0, 30.0, 33.0, 36.0, 39.0, 42.0}) {
      turns.push_back({azimuth_rad, elevation_rad, radian_from_degree(roll), radius_mm});
    }
  }
  return turns;
}

/// What the expert's hand does, some moments of each recording; of an operation on one bone.
std::vector<WorkMoment> expert_moments(const scenarios::Scenario& scenario,
                                       const std::vector<simulator::Bone>& bones, int recordings) {
  std::vector<WorkMoment> moments;
  if (bones.size() > 1) return moments;
  const simulator::Bone& bone = bones.front();
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
  const auto& [place, looking, judgement, worth] = found;
  std::printf(
      "  eye %.2f %.2f %.2f up %.2f %.2f %.2f (%.0f %.0f roll %.0f) radius %.0f: plane %.1f deg, "
      "teeth %.3f, kerf %.3f; expert: teeth %.3f, kerf %.3f\n",
      place.eye_in_bone.x, place.eye_in_bone.y, place.eye_in_bone.z, place.up_in_bone.x,
      place.up_in_bone.y, place.up_in_bone.z, degree_from_radian(looking.azimuth_rad),
      degree_from_radian(looking.elevation_rad), degree_from_radian(looking.roll_rad),
      place.radius_mm, degree_from_radian(judgement.blade_angle_rad),
      judgement.mean.tooth_line_share, judgement.mean.kerf_share, expert.tooth_line_share,
      expert.kerf_share);
}

/// An operation on a coarse patient, seen from anywhere.
struct Site {
  scenarios::Scenario scenario;
  std::vector<simulator::Bone> bones = make_patient_bones(scenario);
  scenarios::Plan plan = plan_on(scenario, bones);
  ViewJudge judge{scenario, bones, plan, {480, 300}};
  RigidTransform start = start_pose(scenario, bones, plan);

  Camera camera(const scenarios::StartingPlace& place) {
    scenario.start = place;
    return start_camera(scenario, bones, plan);
  }
  /// The best of a direction's turns that hold the start; what is seen does not depend on them.
  std::optional<Found> best_from(double azimuth_rad, double elevation_rad) {
    std::optional<Found> best;
    for (const Looking& looking : turns_of(azimuth_rad, elevation_rad)) {
      Found found{scenario.start.value_or(scenarios::StartingPlace{}), looking, {}, 0.0};
      look(found.place, looking);
      found.judgement = judge.judge_start(camera(found.place), start);
      if (!holds_start(found.judgement)) continue;
      found.worth = worth_of_start(looking, found.judgement);
      if (!best || found.worth > best->worth) best = found;
    }
    return best;
  }
};

void search(const std::string& name, int recordings) {
  const bool is_file = name.find(".json") != std::string::npos;
  scenarios::Scenario scenario =
      is_file ? scenarios::read_scenario(name) : scenarios::load_shipped_scenario(name);
  scenario.patient.edge_mm = 0.9;
  Site site{scenario};
  std::vector<Found> found;
  for (int elevation = -30; elevation <= 85; elevation += 5) {
    for (int azimuth = -180; azimuth < 180; azimuth += 10) {
      std::optional<Found> best =
          site.best_from(radian_from_degree(azimuth), radian_from_degree(elevation));
      if (!best) continue;
      best->judgement = site.judge.judge(site.camera(best->place), site.start);
      best->worth += lesser_share(best->judgement.mean);
      found.push_back(*best);
    }
  }
  std::ranges::sort(found, [](const Found& a, const Found& b) { return a.worth > b.worth; });
  std::printf("%s: %zu directions hold the start\n", name.c_str(), found.size());
  const std::vector<WorkMoment> expert = expert_moments(site.scenario, site.bones, recordings);
  for (std::size_t i = 0; i < std::min(found.size(), shown); ++i) {
    print(found[i], site.judge.seen_over(site.camera(found[i].place), expert).mean);
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
  for (const char* name : {"silver", "akin", "chevron"}) search(name, recordings);
  return 0;
}
