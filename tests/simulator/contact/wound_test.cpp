#include "simulator/contact/wound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "simulator/base/units.h"
#include "simulator/contact/blade_probe.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

constexpr Blade blade{.width_mm = 10.0, .depth_mm = 25.0, .kerf_mm = 0.5};

/// Two blocks of a bone's frame: the bone stands, and the same lies turned and 30 mm aside.
class TwoBlocks : public testing::Test {
 protected:
  TwoBlocks() {
    wound_.put(0, {RemainingTissue{tissue_, kerfs_, {}}, {}, {}, false, {}, 18.0});
    wound_.put(1, {RemainingTissue{tissue_, FragmentKerfs(kerfs_, 1), {}, &tissue_.surface()},
                   wound_from_moved_,
                   inverse(wound_from_moved_),
                   true,
                   {},
                   18.0});
  }

  Bone bone_ = tests::cortical_bone(tests::solid_block({20.0, 20.0, 20.0}));
  TissueMap tissue_{bone_};
  KerfSet kerfs_{blade, RigidTransform{}};
  RigidTransform wound_from_moved_{rotation_about(Vec3(0.0, 0.0, 1.0), radian_from_degree(90.0)),
                                   Vec3(30.0, 0.0, 0.0)};
  Wound wound_{kerfs_};
};

TEST_F(TwoBlocks, AreAskedEachInItsOwnFrame) {
  EXPECT_NEAR(wound_.clearance_mm({15.0, 0.0, 0.0}), 5.0, 1e-9) << "as near to one as to the other";
  EXPECT_NEAR(wound_.clearance_mm({38.0, 0.0, 0.0}), -2.0, 1e-9);
  EXPECT_NEAR(wound_.clearance_mm({45.0, 0.0, 0.0}), 5.0, 1e-9);
}

TEST_F(TwoBlocks, ClearancesAreTheSameWithWhatIsRemembered) {
  OfFragments<SurfaceMemory> memory;
  for (int i = 0; i <= 400; ++i) {
    const Vec3 point_mm{-15.0 + 0.15 * i, 0.05 * (i % 37) - 9.0, 3.0};
    EXPECT_EQ(wound_.clearance_mm(point_mm, memory), wound_.clearance_mm(point_mm)) << i;
    EXPECT_EQ(
        wound_.clearance_mm(point_mm),
        std::min(wound_.fragment(0)->tissue.clearance_mm(point_mm),
                 wound_.fragment(1)->tissue.clearance_mm(wound_.fragment(1)->point_from(point_mm))))
        << i;
  }
}

TEST_F(TwoBlocks, TeethStandInWhicheverOfThem) {
  OfFragments<TeethMemory> teeth{};
  for (const double x_mm : {0.0, 30.0}) {
    const RigidTransform down = tests::blade_down({x_mm, 9.9, 0.0});
    EXPECT_NEAR(engagement(down, wound_, 0.02, teeth).width_mm(), 10.0, 1e-9) << x_mm;
  }
  EXPECT_EQ(engagement(tests::blade_down({15.0, 9.9, 0.0}), wound_, 0.02, teeth).width_mm(), 0.0);
}

TEST_F(TwoBlocks, ABladeIsInBoneWhereOneOfThemIs) {
  EXPECT_TRUE(blade_is_in_bone(tests::blade_down({30.0, 0.0, 0.0}), wound_));
  EXPECT_TRUE(edge_meets_bone(tests::blade_down({30.0, 0.0, 0.0}), wound_, 1.0));
  EXPECT_FALSE(blade_is_in_bone(tests::blade_down({15.0, 0.0, 0.0}), wound_));
  wound_.take(1);
  EXPECT_FALSE(blade_is_in_bone(tests::blade_down({30.0, 0.0, 0.0}), wound_)) << "it was taken out";
}

TEST_F(TwoBlocks, ContactsSayWhichWayIsOutOfTheMovedOne) {
  OfFragments<BladeMemory> memory;
  const BladeContacts contacts =
      find_contacts(tests::blade_down({30.0, 10.1, 0.0}), wound_, 0.3, memory);
  ASSERT_GT(contacts.count, 0U);
  for (const BladeContact& contact : contacts.all()) {
    EXPECT_TRUE(contact.is_tooth);
    EXPECT_NEAR(contact.normal.y, 1.0, 1e-9);
    EXPECT_NEAR(contact.gap_mm, 0.1, 1e-9);
    EXPECT_GE(contact.point, contact_point_count) << "the second that is near";
  }
}

TEST_F(TwoBlocks, AKerfOfTheMovedOneLiesWhereThatLies) {
  kerfs_.apply(CutEvent{0, CutEventKind::FragmentParted, 1, 0, {}});
  const RigidTransform fragment_from_tool =
      inverse(wound_from_moved_) * tests::blade_down({30.0, 9.5, 0.0});
  ASSERT_EQ(kerfs_.freeze(quantise(fragment_from_tool), 1), 0);
  const KerfPlane plane = wound_.plane(0);
  EXPECT_NEAR(length_of(plane.bone_from_kerf.translation_mm - Vec3(30.0, 9.5, 0.0)), 0.0, 1e-3);
  EXPECT_EQ(find_kerf_to_join(tests::blade_down({30.0, 9.9, 0.0}), wound_, {}), 0);
  EXPECT_EQ(find_kerf_to_join(tests::blade_down({0.0, 9.9, 0.0}), wound_, {}), -1);
}

/// Half of a block, the part where x is above 0, as a fragment of the whole.
TEST(PartOfABone, HasTheTissuesOfTheBoneWithinItselfAlone) {
  const Bone bone = tests::cortical_bone(tests::solid_block({20.0, 20.0, 20.0}));
  const TissueMap tissue(bone);
  const KerfSet kerfs(blade, RigidTransform{});
  IndexedMesh half = tests::solid_block({10.0, 20.0, 20.0});
  for (Vec3& point : half.points_mm) point.x += 5.0;
  const Bvh part(half);
  const RemainingTissue fragment{tissue, kerfs, {}, &part};
  TissueMemory memory;
  for (double x_mm = -9.9; x_mm < 12.0; x_mm += 0.37) {
    const Vec3 point(x_mm, 1.0, 2.0);
    const Tissue expected = x_mm > 0.0 && x_mm < 10.0 ? tissue.at(point) : Tissue::None;
    EXPECT_EQ(fragment.at(point, memory), expected) << x_mm;
    EXPECT_EQ(fragment.at(point), expected) << x_mm;
  }
  EXPECT_NEAR(fragment.clearance_mm({-1.0, 0.0, 0.0}), 1.0, 1e-12);
}

}  // namespace
}  // namespace hallux::simulator
