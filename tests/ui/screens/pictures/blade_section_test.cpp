#include "ui/screens/pictures/blade_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "simulator/base/units.h"
#include "simulator/cutting/pieces/cut_solid.h"
#include "tests/support/worlds.h"
#include "ui/screens/pictures/blade_section_view.h"
#include "ui/screens/pictures/contact_halo.h"
#include "ui/screens/pictures/planned_frame.h"
#include "ui/screens/pictures/section_rows.h"
#include "ui/screens/pictures/sight_along_blade.h"
#include "ui/screens/pictures/zones_in_scene.h"

namespace hallux::ui {
namespace {

using simulator::Blade;

/// A block of 20 x 12 x 8 mm around the origin, and a blade that comes from above: x down, y along
/// the block's x.
struct Block {
  simulator::CutSolid solid = simulator::uncut_solid(tests::solid_block({20.0, 12.0, 8.0}));
  simulator::Bvh tree{solid.mesh};
  Blade blade{.width_mm = 10.0, .depth_mm = 20.0};

  /// The middle of the teeth so far above the block's upper face.
  static RigidTransform above(double distance_mm) {
    return {rotation_from_axes(Vec3(0.0, -1.0, 0.0), Vec3(1.0, 0.0, 0.0)),
            Vec3(0.0, 6.0 + distance_mm, 0.0)};
  }
  KerfSection section(const std::vector<PlaneLoop>& opened = {}) const {
    return kerf_section(solid, tree, {{above(0.0), 0.5}, opened});
  }
};

double area_mm2(const PlaneLoop& loop) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return 0.5 * doubled;
}

TEST(BladeSection, IsTheOutlineOfTheBoneInThePlaneOfTheBlade) {
  const Block block;
  const KerfSection section = block.section();
  ASSERT_EQ(section.bone_mm.size(), 1U);
  EXPECT_NEAR(area_mm2(section.bone_mm.front()), 20.0 * 12.0, 1.0e-9);
  for (const Vec2& corner : section.bone_mm.front()) {
    EXPECT_GE(corner.x, -1.0e-9) << "the upper face is where the frame lies";
    EXPECT_LE(corner.x, 12.0 + 1.0e-9);
  }
  EXPECT_TRUE(section.opened_mm.empty());
}

TEST(BladeSection, TellsWhatStandsAheadOfTheTeeth) {
  const Block block;
  const KerfSection section = block.section();
  for (const double above_mm : {5.0, 0.0, -3.0, -11.5}) {
    const BladeSection made = blade_section(section, Block::above(above_mm), block.blade, nullptr);
    const simulator::BladeAhead ahead = ahead_in(made);
    ASSERT_TRUE(ahead.to_far_side_mm) << above_mm;
    EXPECT_NEAR(*ahead.to_far_side_mm, 12.0 + above_mm, 1.0e-9);
    EXPECT_NEAR(*ahead.to_bone_mm, std::max(0.0, above_mm), 1.0e-9);
    EXPECT_NEAR(made.teeth_from_mm.x, -above_mm, 1.0e-9);
    EXPECT_NEAR(glm::distance(made.teeth_from_mm, made.teeth_to_mm), 10.0, 1.0e-9);
  }
  EXPECT_FALSE(
      ahead_in(blade_section(section, Block::above(-13.0), block.blade, nullptr)).to_bone_mm)
      << "nothing lies ahead any more";
}

TEST(BladeSection, WhatIsOpenedDoesNotStandAndACanalIsNoFarSide) {
  BladeSection section;
  section.section.bone_mm = {{{0.0, -5.0}, {10.0, -5.0}, {10.0, 5.0}, {0.0, 5.0}},
                             {{3.0, -2.0}, {3.0, 2.0}, {7.0, 2.0}, {7.0, -2.0}}};
  EXPECT_TRUE(is_hole(section.section.bone_mm.back()));
  section.teeth_from_mm = Vec2(-2.0, -1.0);
  section.teeth_to_mm = Vec2(-2.0, 1.0);
  EXPECT_NEAR(*ahead_in(section).to_far_side_mm, 12.0, 1.0e-9);
  EXPECT_NEAR(*ahead_in(section).to_bone_mm, 2.0, 1.0e-9);
  section.section.opened_mm = {{{-1.0, -3.0}, {8.0, -3.0}, {8.0, 3.0}, {-1.0, 3.0}}};
  EXPECT_NEAR(*ahead_in(section).to_bone_mm, 10.0, 1.0e-9);
  section.section.opened_mm = {{{-1.0, -3.0}, {11.0, -3.0}, {11.0, 0.0}, {-1.0, 0.0}}};
  EXPECT_NEAR(*ahead_in(section).to_far_side_mm, 12.0, 1.0e-9) << "of the last tooth";
  section.teeth_from_mm.y = section.teeth_to_mm.y = 6.0;
  EXPECT_FALSE(ahead_in(section).to_bone_mm);
}

TEST(BladeSection, TellsWhatTheBladeAheadOfTheSiteTells) {
  const Block block;
  const simulator::KerfSet none(block.blade, {});
  for (const double above_mm : {4.0, -2.0, -8.0}) {
    const simulator::BladeAhead in_plane =
        ahead_in(blade_section(block.section(), Block::above(above_mm), block.blade, nullptr));
    const simulator::BladeAhead of_site =
        look_ahead(Block::above(above_mm), block.blade, {block.tree, none, {}});
    EXPECT_NEAR(*in_plane.to_bone_mm, *of_site.to_bone_mm, 0.1) << above_mm;
    EXPECT_NEAR(*in_plane.to_far_side_mm, *of_site.to_far_side_mm, 0.1) << above_mm;
  }
}

TEST(WayAhead, IsToTheBoneThenToTheHingeOrTheFarSide) {
  simulator::BladeAhead ahead;
  ahead.beside_mm = 3.0;
  EXPECT_EQ(way_ahead(ahead, 8.0)->to, WayEnd::Beside);
  ahead.beside_mm = 0.0;
  EXPECT_FALSE(way_ahead(ahead, 8.0)) << "they touch, and nothing stands ahead";
  ahead.to_bone_mm = 2.5;
  ahead.to_far_side_mm = 12.0;
  EXPECT_EQ(way_ahead(ahead, 8.0)->to, WayEnd::Bone);
  EXPECT_EQ(way_ahead(ahead, 8.0)->way_mm, 2.5);
  ahead.to_bone_mm = 0.0;
  EXPECT_EQ(way_ahead(ahead, std::nullopt)->to, WayEnd::FarSide);
  EXPECT_EQ(way_ahead(ahead, std::nullopt)->way_mm, 12.0);
  EXPECT_EQ(way_ahead(ahead, 8.0)->to, WayEnd::Hinge);
  EXPECT_EQ(way_ahead(ahead, 8.0)->way_mm, 8.0);
  EXPECT_EQ(way_ahead(ahead, -0.5)->to, WayEnd::PastHinge);
  EXPECT_EQ(way_ahead(ahead, -0.5)->way_mm, 0.5);
  EXPECT_EQ(stroke_end_mm(ahead, 8.0), 8.0);
  EXPECT_EQ(stroke_end_mm(ahead, std::nullopt), 12.0);
}

TEST(BladeSection, ABladeBesideTheKerfIsInAnotherPlane) {
  const RigidTransform kerf = Block::above(0.0);
  const auto moved = [&](double off_mm, double tilt_deg) {
    return kerf * RigidTransform{rotation_about(Vec3(0.0, 1.0, 0.0), radian_from_degree(tilt_deg)),
                                 Vec3(4.0, 3.0, off_mm)};
  };
  EXPECT_TRUE(is_in_plane(kerf, moved(0.0, 0.0)));
  EXPECT_TRUE(is_in_plane(kerf, moved(0.5, 1.0)));
  EXPECT_FALSE(is_in_plane(kerf, moved(2.0, 0.0)));
  EXPECT_FALSE(is_in_plane(kerf, moved(0.0, 6.0)));
}

scenarios::Plan plan_with_zone(double off_mm) {
  scenarios::Plan plan;
  simulator::DangerCapsule capsule;
  capsule.from_in_bone_mm = Vec3(-4.0, -9.0, off_mm);
  capsule.to_in_bone_mm = Vec3(4.0, -9.0, off_mm);
  capsule.radius_mm = 2.0;
  plan.danger_zones.push_back({"nerve", capsule});
  return plan;
}

TEST(BladeSection, CutsADangerZoneWhereItCrossesThePlane) {
  const Block block;
  const auto zone_at = [&](double off_mm, double above_mm) {
    const scenarios::Plan plan = plan_with_zone(off_mm);
    return blade_section(block.section(), Block::above(above_mm), block.blade, &plan).zones.front();
  };
  // Through its axis: 8 x 4 mm with half a circle at each end.
  const ZoneInSection through = zone_at(0.0, 0.0);
  EXPECT_NEAR(area_mm2(through.outline_mm), 8.0 * 4.0 + pi * 4.0, 0.4);
  EXPECT_FALSE(through.is_near);
  EXPECT_NEAR(through.distance_mm, 15.0 - 2.0 - 0.25, 0.05);
  EXPECT_TRUE(zone_at(0.0, -11.5).is_near);
  EXPECT_TRUE(zone_at(2.5, 0.0).outline_mm.empty()) << "beside the plane";
  EXPECT_LT(area_mm2(zone_at(1.5, 0.0).outline_mm), area_mm2(through.outline_mm));
}

TEST(BladeSection, ShowsWherePlannedFacesAndHingesLimitTheCut) {
  const Block block;
  scenarios::Plan plan;
  scenarios::PlannedCut same, other;
  same.face = {Vec3(0.0, 0.0, 1.0), 0.2};
  other.face = {glm::normalize(Vec3(0.0, 1.0, 1.0)), 0.0};
  plan.cuts = {same, other};
  scenarios::PlannedHinge hinge;
  hinge.bridge.line = {Vec3(0.0, -4.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, -1.0, 0.0), 1.0};
  plan.hinges = {hinge};
  const BladeSection made = blade_section(block.section(), Block::above(0.0), block.blade, &plan);
  ASSERT_EQ(made.plan.size(), 2U) << "the face in the plane crosses it nowhere";
  EXPECT_EQ(made.plan[0].kind, PlanTraceKind::Face);
  EXPECT_NEAR(made.plan[0].from_mm.x, 6.0, 1.0e-9);
  EXPECT_NEAR(made.plan[0].to_mm.x, 6.0, 1.0e-9);
  EXPECT_EQ(made.plan[1].kind, PlanTraceKind::Hinge);
  EXPECT_NEAR(made.plan[1].from_mm.x, 10.0, 1.0e-9);
  EXPECT_TRUE(blade_section(block.section(), Block::above(0.0), block.blade, nullptr).plan.empty());
}

double length_mm(const std::vector<RowSpan>& spans) {
  return std::accumulate(spans.begin(), spans.end(), 0.0, [](double sum, const RowSpan& span) {
    return sum + span.to_mm - span.from_mm;
  });
}

TEST(BladeSectionRows, RunThroughBoneAndNotThroughHolesOrWhatIsOpen) {
  const std::vector<PlaneLoop> bone{{{0.0, -5.0}, {10.0, -5.0}, {10.0, 5.0}, {0.0, 5.0}},
                                    {{3.0, -2.0}, {3.0, 2.0}, {7.0, 2.0}, {7.0, -2.0}}};
  const std::vector<PlaneLoop> opened{{{-1.0, -4.0}, {4.0, -4.0}, {4.0, 0.0}, {-1.0, 0.0}}};
  EXPECT_NEAR(length_mm(spans_at(bone, 1.0)), 10.0, 1.0e-12);
  EXPECT_NEAR(length_mm(spans_at(bone, 5.0)), 6.0, 1.0e-12);
  EXPECT_TRUE(spans_at(bone, 11.0).empty());
  const auto standing = [&](double x_mm) {
    return without(spans_at(bone, x_mm), spans_at(opened, x_mm));
  };
  EXPECT_EQ(standing(1.0), (std::vector<RowSpan>{{-5.0, -4.0}, {0.0, 5.0}}));
  EXPECT_EQ(standing(3.5), (std::vector<RowSpan>{{-5.0, -4.0}, {2.0, 5.0}}));
  EXPECT_EQ(standing(8.0), (std::vector<RowSpan>{{-5.0, 5.0}}));
}

TEST(ContactHalo, TellsBeforeOnAndBehindTheBone) {
  const Block block;
  const BoneSurface bone{block.tree, {}};
  const Vec3 in_front(0.0, 20.0, 300.0), from_below(0.0, -300.0, 0.0);
  SawInScene saw;
  saw.blade = block.blade;
  const auto halo_at = [&](double above_mm, const Vec3& eye_mm) {
    saw.world_from_tool = Block::above(above_mm);
    return contact_halo(std::span(&bone, 1), saw, eye_mm);
  };
  const auto before = halo_at(9.0, in_front);
  ASSERT_TRUE(before);
  EXPECT_EQ(before->kind, HaloKind::Before);
  EXPECT_NEAR(before->distance_mm, 9.0, 1.0e-9);
  EXPECT_EQ(halo_at(0.1, in_front)->kind, HaloKind::On);
  EXPECT_EQ(halo_at(-5.0, in_front)->kind, HaloKind::Behind) << "in the bone";
  EXPECT_EQ(halo_at(9.0, from_below)->kind, HaloKind::Behind) << "beyond it";
  EXPECT_FALSE(halo_at(halo_reach_mm + 1.0, in_front)) << "too far to say";
  saw.world_from_tool = Block::above(5.0);
  saw.world_from_tool.translation_mm.z = 30.0;
  EXPECT_FALSE(contact_halo(std::span(&bone, 1), saw, in_front)) << "it would pass the bone";
}

TEST(ContactHalo, TheNearestToothCounts) {
  const Block block;
  RigidTransform tool = Block::above(4.0);
  tool = tool * RigidTransform{rotation_about(Vec3(0.0, 0.0, 1.0), 0.2), {}};
  const auto way_mm = way_to_bone_mm({block.tree, {}}, tool, block.blade);
  ASSERT_TRUE(way_mm);
  EXPECT_LT(*way_mm, 4.0);
}

TEST(SightAlongBlade, IsHiddenByWhatLiesBesideTheTeeth) {
  const Block block;
  const BoneSurface bone{block.tree, {}};
  const auto hidden = [&](double above_mm) {
    return hidden_along_blade(std::span(&bone, 1), Block::above(above_mm), block.blade);
  };
  EXPECT_EQ(hidden(3.0), (std::array<double, blade_sight_count>{})) << "in the air";
  const auto in_bone = hidden(-6.0);
  for (const double share : in_bone) EXPECT_NEAR(share, 1.0, 1.0e-9);
  // A second block beside the first hides one side.
  RigidTransform beside;
  beside.translation_mm = Vec3(25.0, 8.0, 0.0);
  const std::array bones{bone, BoneSurface{block.tree, beside}};
  const auto shares = hidden_along_blade(bones, Block::above(3.0), block.blade);
  EXPECT_NEAR(shares[static_cast<std::size_t>(BladeSight::AcrossFromPlus)], 1.0, 1.0e-9);
  EXPECT_EQ(shares[static_cast<std::size_t>(BladeSight::AcrossFromMinus)], 0.0);
  EXPECT_EQ(shares[static_cast<std::size_t>(BladeSight::OverHandle)], 0.0);
}

TEST(SightAlongBlade, TheHandpieceIsFaintOnlyForOneWhoLooksAlongIt) {
  const RigidTransform tool = Block::above(0.0);
  const auto presence_from = [&](double off_feed_deg) {
    const double off_rad = radian_from_degree(off_feed_deg);
    return handpiece_presence_from(
        tool, tool.translation_mm + 300.0 * Vec3(std::sin(off_rad), std::cos(off_rad), 0.0));
  };
  for (const double off_deg : {0.0, 3.0, 6.0}) EXPECT_LT(presence_from(off_deg), 0.2) << off_deg;
  double last = presence_from(6.0);
  for (double off_deg = 7.0; off_deg < 25.0; off_deg += 1.0) {
    EXPECT_GE(presence_from(off_deg), last) << off_deg;
    last = presence_from(off_deg);
  }
  for (const double off_deg : {20.0, 25.0, 45.0, 90.0, 180.0})
    EXPECT_EQ(presence_from(off_deg), 1.0) << off_deg;
}

TEST(ZonesInScene, AreLitWhereTheBladeIsNear) {
  const Block block;
  const scenarios::Plan plan = plan_with_zone(0.0);
  RigidTransform world_from_bone{rotation_about(Vec3(0.0, 0.0, 1.0), 0.5), Vec3(7.0, 1.0, 2.0)};
  const auto zone_at = [&](double above_mm) {
    return zones_in_scene(plan, world_from_bone, world_from_bone * Block::above(above_mm),
                          block.blade)
        .front();
  };
  EXPECT_FALSE(zone_at(-10.0).is_near) << "2.75 mm away";
  EXPECT_TRUE(zone_at(-11.5).is_near);
  EXPECT_EQ(zone_at(0.0).from_mm, transform_point(world_from_bone, Vec3(-4.0, -9.0, 0.0)));
}

TEST(PlannedFace, IsTheRectangleAroundThePartThatIsMeant) {
  // Two blocks apart, met by one plane.
  simulator::IndexedMesh mesh = tests::solid_block({10.0, 6.0, 6.0});
  simulator::CutSolid solid = simulator::uncut_solid(mesh);
  for (Vec3& point_mm : mesh.points_mm) point_mm.x += 40.0;
  append_solid(solid, simulator::uncut_solid(mesh));
  const simulator::Bvh tree(solid.mesh);
  const RigidTransform plane{};  // z = 0
  const PlannedFace near = planned_face(solid, tree, plane, Vec3(1.0, 0.0, 0.0));
  EXPECT_NEAR(near.bone_from_face.translation_mm.x, 0.0, 1.0e-9);
  EXPECT_NEAR(near.half_mm.x, 5.0 + 3.0, 1.0e-9);
  EXPECT_NEAR(near.half_mm.y, 3.0 + 3.0, 1.0e-9);
  EXPECT_NEAR(near.entry_x_mm, -5.0, 1.0e-9);
  const PlannedFace far = planned_face(solid, tree, plane, Vec3(39.0, 0.0, 0.0));
  EXPECT_NEAR(far.bone_from_face.translation_mm.x, 40.0, 1.0e-9);
}

}  // namespace
}  // namespace hallux::ui
