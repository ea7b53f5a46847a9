/// A V in a bar, one arm of which is rolled: the freed end slides along the line in which the two
/// planes meet, not along the planned one.
#include <gtest/gtest.h>

#include <cmath>

#include "assessment/rebuild/bodies.h"
#include "simulator/base/units.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::assessment {
namespace {

using simulator::CommandKind;

/// The arms leave the apex towards -x, 30 degrees either side; both contain y, along which the
/// blade comes and the end is to slide.
constexpr double apex_x_mm = 5.0, kerf_mm = 0.5, planned_mm = 3.0;

/// One arm: where it goes from the apex, and the way of the blade in it.
struct Arm {
  Vec3 away, feed;

  /// Away from the end that is freed.
  Vec3 normal() const {
    const Vec3 across = glm::cross(away, feed);
    return across.x < 0.0 ? across : -across;
  }
};

Arm arm(double angle_deg, double roll_deg) {
  const double angle_rad = radian_from_degree(angle_deg);
  const Vec3 away{-std::cos(angle_rad), 0.0, std::sin(angle_rad)};
  const RigidTransform roll{rotation_about(away, radian_from_degree(roll_deg)), {}};
  return {away, transform_direction(roll, {0.0, -1.0, 0.0})};
}

class SawnV {
 public:
  explicit SawnV(double roll_deg) : arms_{arm(30.0, 0.0), arm(-30.0, roll_deg)} {
    for (const Arm& each : arms_) saw(each);
    run_.glide(pose(arms_[0], 40.0), 400);
    run_.hold(20);
  }

  /// Grips the end, leads it as planned, closes it and lets it go.
  void slide() {
    run_.step({{CommandKind::Grip, 1, 0}});
    run_.hold(3);
    RigidTransform led = pose(arms_[0], 40.0);
    led.translation_mm.y += planned_mm;
    run_.glide(led, 800);
    run_.step({{CommandKind::Impact, 0, 0}});
    run_.hold(2500);
    run_.step({{CommandKind::Release, 0, 0}});
    run_.hold(5);
  }

  /// The way nearest to the planned one that keeps both faces closed over their kerfs.
  Vec3 closed_form_mm() const {
    const Vec3 one = arms_[0].normal(), other = arms_[1].normal();
    const Vec3 line = glm::normalize(glm::cross(one, other));
    // one . d = other . d = kerf, in the plane of both normals.
    const double both = glm::dot(one, other);
    const Vec3 closing = kerf_mm / (1.0 + both) * (one + other);
    const Vec3 planned{0.0, planned_mm, 0.0};
    return closing + glm::dot(planned, line) * line;
  }

  BodyPlacement placement() const {
    scenarios::Plan plan;
    plan.fixation.fragments.push_back(
        {.name = "end",
         .bone = 0,
         .holds_in_bone_mm = {10.0, 0.0, 0.0},
         .volume_mm3 = 13.0 * 64.0,
         .bone_from_rest = {{1.0, 0.0, 0.0, 0.0}, {0.0, planned_mm, 0.0}}});
    const RebuiltBone rebuilt = rebuild(bone_, {}, run_.recording());
    const auto bodies = bodies_of(rebuilt, plan, bone_);
    const auto placements = placements_of(bodies, rebuilt, plan);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].name == "end") return placements[i];
    }
    ADD_FAILURE() << "no end was parted";
    return {};
  }

 private:
  /// The blade spans the arm, from a little beyond the apex, with its teeth at that height; its
  /// finished face is the arm's plane and its kerf lies on the far side of the end.
  static RigidTransform pose(const Arm& each, double height_mm) {
    const Quat rotation = rotation_from_axes(each.feed, each.away);
    const Vec3 apex_mm{apex_x_mm, 0.0, 0.0};
    return {rotation, apex_mm + 4.2 * each.away - height_mm * each.feed};
  }
  void saw(const Arm& each) {
    run_.glide(pose(each, 40.0), 400);
    run_.glide(pose(each, 12.0), 400);
    run_.glide(pose(each, -10.0), 2600);
    run_.hold(1500);
    run_.glide(pose(each, 40.0), 500);
    run_.hold(20);
  }

  std::array<Arm, 2> arms_;
  simulator::Bone bone_ = tests::cancellous_bone(tests::solid_block({30.0, 8.0, 8.0}));
  tests::SimulationRun run_{bone_, pose(arms_[0], 40.0)};
};

void expect_closed_form(double roll_deg) {
  SawnV bar(roll_deg);
  bar.slide();
  const BodyPlacement placement = bar.placement();
  ASSERT_TRUE(placement.error_mm);
  EXPECT_NEAR(*placement.error_mm, length_of(bar.closed_form_mm() - Vec3{0.0, planned_mm, 0.0}),
              0.1);
  EXPECT_LT(placement.overlap_max_mm, 0.05);
}

TEST(RolledArm, StraightArmsLetTheEndSlideAsPlanned) { expect_closed_form(0.0); }

TEST(RolledArm, TheEndSlidesAlongTheLineInWhichThePlanesMeet) { expect_closed_form(10.0); }

}  // namespace
}  // namespace hallux::assessment
