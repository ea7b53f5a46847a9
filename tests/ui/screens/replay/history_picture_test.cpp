#include "ui/screens/replay/history_picture.h"

#include <gtest/gtest.h>

#include <numeric>

#include "assessment/rebuild/rebuild.h"
#include "scenarios/plan.h"
#include "simulator/mesh/bvh.h"
#include "tests/ui/screens/some_operation.h"

namespace hallux::ui {
namespace {

struct World {
  World() {
    plan = plan_on(operation.scenario, operation.bone);
    history = simulator::build_history(
        {operation.bone, operation.recording, opened(), scenarios::planned_bridges(plan)});
    picture = picture_of(history, {look_of(1, operation.bone)}, "test");
  }

  assessment::OpenedFields opened() const {
    return assessment::opened_fields(operation.scenario.saw.blade, operation.bone,
                                     operation.recording);
  }

  SomeOperation operation = some_operation();
  scenarios::Plan plan;
  std::shared_ptr<const simulator::BoneHistory> history;
  std::shared_ptr<const HistoryPicture> picture;
};

double six_volumes(const Vec3& a, const Vec3& b, const Vec3& c) {
  return glm::dot(a, glm::cross(b, c));
}

/// What the renderer would draw of it: triangles that are not hidden, and the patch.
double shown_mm3(const BoneInScene& bone) {
  const simulator::IndexedMesh& mesh = bone.mesh->solid.mesh;
  double sum = 0.0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (bone.patch != nullptr &&
        std::binary_search(bone.patch->hidden.begin(), bone.patch->hidden.end(), i))
      continue;
    const simulator::Triangle& t = mesh.triangles[i];
    sum += six_volumes(mesh.points_mm[t[0]], mesh.points_mm[t[1]], mesh.points_mm[t[2]]);
  }
  if (bone.patch == nullptr) return sum / 6.0;
  const auto at = [&](std::uint32_t index) {
    return index < mesh.points_mm.size()
               ? mesh.points_mm[index]
               : bone.patch->points_in_bone_mm[index - mesh.points_mm.size()];
  };
  for (const simulator::Triangle& t : bone.patch->triangles)
    sum += six_volumes(at(t[0]), at(t[1]), at(t[2]));
  return sum / 6.0;
}

double shown_mm3(const World& world, const simulator::BoneMoment& moment) {
  return shown_mm3(bones_of(*world.picture, moment).front());
}

/// What scoring rebuilds of the recording up to a tick.
double rebuilt_mm3(const World& world, std::int64_t tick) {
  simulator::Recording until = world.operation.recording;
  std::erase_if(until.samples, [&](const auto& sample) { return sample.tick > tick; });
  std::erase_if(until.events, [&](const auto& event) { return event.tick > tick; });
  const assessment::RebuiltBone rebuilt =
      assessment::rebuild(world.operation.bone, world.operation.scenario.saw.blade, until);
  return std::accumulate(rebuilt.piece_volumes_mm3.begin(), rebuilt.piece_volumes_mm3.end(),
                         rebuilt.debris_mm3);
}

TEST(HistoryPicture, HoldsAtEachTickWhatScoringRebuildsButForHalfASpacingBeforeTheTeeth) {
  const World world;
  simulator::BoneMoment moment(*world.history);
  const simulator::Blade& blade = world.operation.scenario.saw.blade;
  const double before_teeth_mm3 =
      0.5 * simulator::FieldGrid{}.spacing_mm * blade.width_mm * blade.kerf_mm;
  ASSERT_EQ(world.history->fragments.at(0).stretches.size(), 2U) << "two cuts, one after the other";
  for (const simulator::KerfGrowth& kerf : world.history->kerfs) {
    ASSERT_GT(kerf.ticks.size(), 100U);
    for (std::size_t i = 0; i < kerf.ticks.size(); i += kerf.ticks.size() / 7) {
      moment.move_to(kerf.ticks[i]);
      EXPECT_NEAR(shown_mm3(world, moment), rebuilt_mm3(world, kerf.ticks[i]), before_teeth_mm3)
          << kerf.ticks[i];
    }
    moment.move_to(kerf.ticks.back());
    EXPECT_NEAR(shown_mm3(world, moment), rebuilt_mm3(world, kerf.ticks.back()), 1.0e-4)
        << "where a kerf's growth ends nothing is in doubt";
  }
}

TEST(HistoryPicture, ScrubbedBackwardsTheBoneIsWholeAgain) {
  const World world;
  simulator::BoneMoment moment(*world.history);
  moment.move_to(0);
  const double whole_mm3 = shown_mm3(world, moment);
  moment.move_to(world.operation.wedge_out_tick - 20);
  const double sawn_mm3 = shown_mm3(world, moment);
  EXPECT_LT(sawn_mm3, whole_mm3 - 50.0);
  moment.move_to(0);
  EXPECT_EQ(shown_mm3(world, moment), whole_mm3);
  EXPECT_NEAR(whole_mm3, simulator::signed_volume_mm3(world.operation.bone.outer), 1.0e-6);
}

TEST(HistoryPicture, APieceThatWasTakenOutIsGoneFromThenOn) {
  const World world;
  ASSERT_EQ(world.history->fragments.at(0).taken.size(), 1U);
  simulator::BoneMoment moment(*world.history);
  moment.move_to(world.operation.wedge_out_tick - 1);
  const double before_mm3 = shown_mm3(world, moment);
  const std::uint64_t revision = moment.revision();
  moment.move_to(world.operation.wedge_out_tick);
  EXPECT_NE(moment.revision(), revision);
  EXPECT_NEAR(before_mm3 - shown_mm3(world, moment), world.operation.wedge_mm3, 1.0e-4);
  moment.move_to(world.operation.wedge_out_tick - 1);
  EXPECT_NEAR(shown_mm3(world, moment), before_mm3, 1.0e-9);
}

TEST(HistoryPicture, TheSameMomentAgainCostsNothing) {
  const World world;
  simulator::BoneMoment moment(*world.history);
  moment.move_to(200);
  const std::uint64_t revision = moment.revision();
  moment.move_to(200);
  EXPECT_EQ(moment.revision(), revision);
}

TEST(HistoryPicture, ARayMeetsTheSkinAndLooksThroughAnOpenKerf) {
  const World world;
  simulator::BoneMoment moment(*world.history);
  moment.move_to(0);
  const RigidTransform& world_from_bone = world.operation.bone.world_from_bone;
  const auto hit_from = [&](const Vec3& from, const Vec3& direction) {
    return moment.first_hit(transform_point(world_from_bone, from),
                            transform_direction(world_from_bone, direction));
  };
  const Vec3 from(20.0, 40.0, 1.0), down(0.0, -1.0, 0.0);
  const std::optional<simulator::PlaceOnFragment> hit = hit_from(from, down);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->fragment, 0);
  EXPECT_NEAR(simulator::Bvh(world.operation.bone.outer).signed_distance_mm(hit->point_mm), 0.0,
              1.0e-9);
  EXPECT_FALSE(hit_from(from, -down).has_value());
  // Over the wedge, half way to the medial side: bone before it was taken out, nothing there
  // afterwards.
  const Vec3 over_wedge(7.3, 40.0, -4.0);
  EXPECT_TRUE(hit_from(over_wedge, down).has_value());
  moment.move_to(world.operation.wedge_out_tick);
  EXPECT_FALSE(hit_from(over_wedge, down).has_value());
}

TEST(HistoryPicture, ARecordingWithoutACutShowsTheWholeBone) {
  World world;
  world.operation.recording.events.clear();
  for (auto& sample : world.operation.recording.samples) sample.kerf = -1;
  const auto history = simulator::build_history(
      {world.operation.bone, world.operation.recording, world.opened(), {}});
  const auto picture = picture_of(history, {look_of(1, world.operation.bone)}, "uncut");
  simulator::BoneMoment moment(*history);
  moment.move_to(300);
  const std::vector<BoneInScene> bones = bones_of(*picture, moment);
  ASSERT_EQ(bones.size(), 1U);
  EXPECT_EQ(bones.front().patch, nullptr);
}

}  // namespace
}  // namespace hallux::ui
