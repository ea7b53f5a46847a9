/// An attempt at two bones as its result and its replay show it: each bone where it lies, each cut
/// against the plan of its own bone.
#include <gtest/gtest.h>

#include <algorithm>

#include "database/content/assets.h"
#include "tests/ui/screens/some_visitor.h"
#include "ui/jobs/made_attempt.h"
#include "ui/screens/replay/replay_material.h"
#include "ui/screens/result/result_material.h"

namespace hallux::ui {
namespace {

/// The perfect hand's, as ada's. Made once.
class TwoBonesShown : public testing::Test {
 protected:
  static void SetUpTestSuite() { stored = new Stored; }
  static void TearDownTestSuite() {
    delete stored;
    stored = nullptr;
  }

  struct Stored {
    Stored() {
      ScriptedAttempt attempt;
      attempt.scenario = scenarios::read_scenario(HALLUX_TWO_BONES);
      attempt.hand = "perfect";
      made = make_attempt(attempt, [](const std::string&) { return Progress(); });
      database::Database& database = course.database();
      const scenarios::Scenario& scenario = attempt.scenario;
      database::NewAttempt begun = course.attempt_of("ada");
      begun.scenario = put_scenario_version(
          database, {scenario.name, scenario.version, scenario.text, scenario.claims_review});
      put_patient(database, made.material.bones, begun);
      id = record(database, begun, made.material.recording);
    }

    database::SomeCourse course;
    MadeAttempt made;
    database::AttemptId id;
  };

  static inline Stored* stored = nullptr;
};

TEST_F(TwoBonesShown, InTheResultEachWhereItLies) {
  WorkReport report;
  const auto visit = visit_of(stored->course, "ada");
  const auto examined = examine_attempt(*visit, stored->id, report);
  const std::vector<simulator::Bone>& bones = stored->made.material.bones;
  EXPECT_EQ(examined->card.score_milli, 100'000);
  ASSERT_EQ(examined->looks.size(), 2U);
  for (std::size_t bone = 0; bone < 2; ++bone) {
    EXPECT_EQ(examined->world_from_bones[bone].translation_mm,
              bones[bone].world_from_bone.translation_mm);
    EXPECT_GT(std::ranges::count(examined->piece_bones, bone), 0) << bone;
  }
  ASSERT_EQ(examined->cuts.size(), 2U);
  for (const CutAgainstPlan& cut : examined->cuts) {
    EXPECT_TRUE(cut.is_cut) << cut.bone;
    // The face lies in the bone that it was sawn in.
    const simulator::IndexedMesh& outer = bones[cut.bone].outer;
    Vec3 low = outer.points_mm.front(), high = low;
    for (const Vec3& point : outer.points_mm) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
    EXPECT_TRUE(glm::all(glm::lessThan(low, cut.middle_in_bone_mm)) &&
                glm::all(glm::lessThan(cut.middle_in_bone_mm, high)))
        << cut.bone;
  }
}

TEST_F(TwoBonesShown, InTheReplayWithinOneSight) {
  WorkReport report;
  const auto visit = visit_of(stored->course, "ada");
  const auto replay = load_replay(*visit, stored->id, report);
  const RigidTransform first_from_world = inverse(replay->world_from_bone);
  for (const simulator::Bone& bone : stored->made.material.bones) {
    for (const Vec3& point : bone.outer.points_mm) {
      const Vec3 seen = transform_point(first_from_world * bone.world_from_bone, point);
      ASSERT_LT(glm::length(seen - replay->middle_in_bone_mm), 1.001 * replay->radius_mm)
          << bone.name;
    }
  }
  EXPECT_EQ(replay->faces.size(), 2U);
}

}  // namespace
}  // namespace hallux::ui
