// What is held besides the saw, and what it leaves, measured on pictures.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <variant>

#include "tests/ui/render/drilled_bone.h"
#include "tests/ui/render/graphics.h"
#include "ui/render/renderer.h"
#include "ui/render/scene/driver_model.h"
#include "ui/render/scene/forceps_model.h"

namespace hallux::tests {
namespace {

using namespace ui;
using simulator::Drill;
using simulator::Screw;
using simulator::Screwdriver;
using simulator::Tool;
using simulator::WireDriver;

constexpr PixelSize size{640, 360};
constexpr double aspect = 640.0 / 360.0;

const std::array<Tool, 3> drivers{WireDriver{}, Drill{}, Screwdriver{}};

int light_of(const Colour& colour) { return colour.red + colour.green + colour.blue; }
int difference_of(const Colour& a, const Colour& b) {
  return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
}
/// Over bone or not.
bool is_reference(const Colour& colour) {
  return colour.red > colour.green + 40 && colour.blue > colour.green + 8;
}
bool is_grey(const Colour& colour) { return std::abs(colour.red - colour.blue) < 30; }

class Tools : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    world = new OperatingWorld(0.9);
    world->saw_to(-4.0);
  }
  static void TearDownTestSuite() { delete world; }

  Tools() {
    scene_.saw.reset();
    scene_.planes.clear();
    scene_.lines.clear();
    camera_ = orbited(standard_view(world->camera(), StandardView::Medial), 0.5, 0.35);
    camera_.target_mm = line_.world_from_line.translation_mm;
    bare_ = draw();
  }
  Pixels draw() {
    const RenderTarget target(size);
    renderer_.draw(scene_, camera_, target.target());
    return target.read();
  }
  EyeView view() const { return view_of(camera_, Viewer{}, Eye::Middle, aspect); }
  Colour at(const Pixels& picture, const Vec3& place_mm) const {
    const Vec3 place = place_in_picture(view(), place_mm);
    const bool is_inside = place.x >= 0.0 && place.x < 1.0 && place.y >= 0.0 && place.y < 1.0;
    EXPECT_TRUE(is_inside) << place.x << " " << place.y;
    if (!is_inside) return {};
    return pixel_at(picture, static_cast<int>(place.x * size.width),
                    static_cast<int>(place.y * size.height));
  }
  /// On a tool's axis.
  Colour at(const Pixels& picture, const RigidTransform& world_from_tool, double x_mm) const {
    return at(picture, transform_point(world_from_tool, Vec3(x_mm, 0.0, 0.0)));
  }
  void look_from_light() {
    scene_.ground = Ground::Light;
    bare_ = draw();
  }

  static OperatingWorld* world;
  HeadlessContext context_;
  DrillLine line_ = drill_line(*world, Vec3(15.0, 0.0, 0.0), Vec3(0.55, -0.75, 0.25));
  Scene scene_ = world->scene();
  Camera camera_;
  Renderer renderer_{RenderQuality{}};
  Pixels bare_;
};
OperatingWorld* Tools::world = nullptr;

TEST_F(Tools, ADriverIsSeenWhereItsPoseSays) {
  for (const Tool& tool : drivers) {
    const RigidTransform pose = line_.world_from_tool(-6.0);
    scene_.driver = DriverInScene{pose, tool};
    const Pixels picture = draw();
    for (const double x_mm : {-1.6, -3.0, -6.0}) {
      EXPECT_TRUE(is_grey(at(picture, pose, x_mm))) << tool.index() << " " << x_mm;
      EXPECT_GT(difference_of(at(picture, pose, x_mm), at(bare_, pose, x_mm)), 12) << x_mm;
    }
    EXPECT_TRUE(is_bone_coloured(at(picture, pose, 2.0))) << "not beyond its tip";
    // All of the tool is wider than what it holds, and lies behind it.
    const Vec3 beside_mm(chuck_x_mm(tool) - 12.0, 4.0, 0.0);
    camera_.target_mm = transform_point(pose, beside_mm);
    const Pixels chuck = draw();
    scene_.driver.reset();
    EXPECT_GT(difference_of(at(chuck, camera_.target_mm), at(draw(), camera_.target_mm)), 20);
    camera_.target_mm = line_.world_from_line.translation_mm;
  }
}

TEST_F(Tools, ABitTurnsOnlyWhileItRuns) {
  scene_.driver = DriverInScene{line_.world_from_tool(-10.0), Drill{}};
  const Pixels still = draw();
  scene_.driver->turned_rad = 0.9;
  EXPECT_EQ(draw().rgba, still.rgba);
  scene_.driver->is_running = true;
  const Pixels turned = draw();
  EXPECT_NE(turned.rgba, still.rgba);
  scene_.driver->turned_rad = 1.8;
  EXPECT_NE(draw().rgba, turned.rgba);
}

TEST_F(Tools, ADriverCastsAShadowThatEndsAtItsTip) {
  scene_.driver = DriverInScene{line_.world_from_tool(-2.0), Drill{}};
  const Pixels picture = draw();
  std::size_t darker = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Colour before = pixel_at(bare_, x, y), now = pixel_at(picture, x, y);
      if (is_bone_coloured(now) && light_of(now) < light_of(before) - 40) ++darker;
    }
  }
  EXPECT_GT(darker, 60U);
  EXPECT_LT(darker, 6000U);
}

TEST_F(Tools, WhatOfADriverIsInTheBoneIsHidden) {
  for (const Tool& tool : drivers) {
    const RigidTransform pose = line_.world_from_tool(7.0);
    scene_.driver = DriverInScene{pose, tool};
    const Pixels picture = draw();
    EXPECT_TRUE(is_bone_coloured(at(picture, pose, -0.5))) << tool.index();
    EXPECT_FALSE(is_bone_coloured(at(picture, pose, -10.0))) << tool.index();
  }
}

// A handle on the line of sight would hide the tip and the bone around it.
TEST_F(Tools, AHandleGivesWayBeforeItsTip) {
  for (const Tool& tool : drivers) {
    // A screw's head stays, and hides what is behind it.
    const double beside_tip_mm = std::holds_alternative<Screwdriver>(tool) ? 4.2 : 2.0;
    const RigidTransform pose = line_.world_from_tool(-1.0);
    camera_.target_mm = pose.translation_mm;
    camera_.world_from_view =
        rotation_from_axes(axis_z(pose), glm::cross(-axis_x(pose), axis_z(pose)));
    scene_.driver.reset();
    const Vec3 beside_mm = transform_point(pose, Vec3(0.0, beside_tip_mm, 0.0));
    ASSERT_TRUE(is_bone_coloured(at(draw(), beside_mm)));
    scene_.driver = DriverInScene{pose, tool};
    EXPECT_TRUE(is_bone_coloured(at(draw(), beside_mm))) << tool.index();
    scene_.driver->handpiece_presence = 0.2;
    EXPECT_TRUE(is_bone_coloured(at(draw(), beside_mm))) << tool.index();
  }
}

TEST_F(Tools, ForcepsOpenAsFarAsTheyAreSaidTo) {
  const RigidTransform pose = line_.world_from_tool(-9.0);
  camera_.magnification = 4.0;
  bare_ = draw();
  for (const double opening_mm : {3.0, 9.0, 15.0}) {
    scene_.forceps = ForcepsInScene{pose, opening_mm};
    const Pixels picture = draw();
    const RigidTransform first = tool_from_arm(opening_mm);
    for (const double side : {1.0, -1.0}) {
      // A little above the point, and in the middle of the jaw.
      for (const Vec3& in_arm_mm : {Vec3(46.0, 1.6, 0.0), Vec3(30.0, 11.6, 0.0)}) {
        const Vec3 in_tool_mm = transform_point(first, in_arm_mm) * Vec3(1.0, side, 1.0);
        const Vec3 place_mm = transform_point(pose, in_tool_mm);
        EXPECT_GT(difference_of(at(picture, place_mm), at(bare_, place_mm)), 12) << opening_mm;
      }
    }
    EXPECT_EQ(difference_of(at(picture, pose, 0.0), at(bare_, pose, 0.0)), 0) << "between them";
  }
}

TEST_F(Tools, BoneHidesWhatOfAnImplantIsInIt) {
  Screw screw;
  screw.length_mm = 10.0;
  const RigidTransform pose = line_.world_from_tool(9.0);
  scene_.implants = {{pose, Screwdriver{screw}}};
  const Pixels picture = draw();
  for (const double x_mm : {-0.5, -3.0, -6.0})
    EXPECT_EQ(difference_of(at(picture, pose, x_mm), at(bare_, pose, x_mm)), 0) << x_mm;
  EXPECT_TRUE(is_grey(at(picture, pose, -11.0)));
  WireDriver wire;
  wire.wire.length_mm = 50.0;
  scene_.implants = {{pose, wire}};
  const Pixels with_wire = draw();
  EXPECT_EQ(difference_of(at(with_wire, pose, -2.0), at(bare_, pose, -2.0)), 0);
  EXPECT_TRUE(is_grey(at(with_wire, pose, -14.0)));
  EXPECT_GT(difference_of(at(with_wire, pose, -14.0), at(bare_, pose, -14.0)), 30);
}

TEST_F(Tools, WhatIsPlannedIsSeenThroughTheBoneInItsInk) {
  Screw screw;
  screw.length_mm = 10.0;
  const RigidTransform pose = line_.world_from_tool(9.0);
  for (int ground = 0; ground < 2; ++ground) {
    scene_.implants = {{pose, Screwdriver{screw}, true}};
    const Pixels picture = draw();
    for (const double x_mm : {-1.0, -3.0, -6.0, -11.0}) {
      EXPECT_FALSE(is_reference(at(bare_, pose, x_mm)));
      EXPECT_TRUE(is_reference(at(picture, pose, x_mm))) << x_mm;
    }
    // Fainter in the bone: the green that the ink lacks shines through.
    EXPECT_GT(at(picture, pose, -3.0).green, at(picture, pose, -11.0).green);
    scene_.implants.clear();
    look_from_light();
  }
}

TEST_F(Tools, WhatIsPlannedStandsBehindWhatIsHeldAndLeft) {
  const RigidTransform pose = line_.world_from_tool(9.0);
  WireDriver wire;
  wire.wire.length_mm = 40.0;
  scene_.implants = {{pose, wire}};
  const Pixels without = draw();
  scene_.implants.push_back({pose, wire, true});
  const Pixels with = draw();
  EXPECT_EQ(difference_of(at(with, pose, -14.0), at(without, pose, -14.0)), 0);
  EXPECT_TRUE(is_reference(at(with, pose, -4.0)));
  EXPECT_FALSE(is_reference(at(without, pose, -4.0)));
}

TEST_F(Tools, AHoleDarkensTheSkinInsideItsRimOnly) {
  const HoleInScene hole = hole_at(*world, line_, 1.35);
  const Vec3 middle_mm = line_.world_from_line.translation_mm;
  for (int ground = 0; ground < 2; ++ground) {
    scene_.holes = {hole};
    const Pixels picture = draw();
    for (const Vec3& rim_mm : hole.rim_mm) {
      const auto along = [&](double share) { return middle_mm + share * (rim_mm - middle_mm); };
      EXPECT_LT(light_of(at(picture, along(0.7))), light_of(at(bare_, along(0.7))) - 120);
      EXPECT_GE(light_of(at(picture, along(1.07))), light_of(at(bare_, along(1.07))) - 100);
      EXPECT_EQ(difference_of(at(picture, along(1.45)), at(bare_, along(1.45))), 0);
    }
    std::size_t lighter = 0;
    for (std::size_t i = 0; i < bare_.rgba.size(); i += 4)
      lighter += picture.rgba[i + 2] > bare_.rgba[i + 2] + 4 ? 1U : 0U;
    EXPECT_GT(lighter, 40U) << "its rim";
    EXPECT_LT(lighter, 500U);
    scene_.holes.clear();
    look_from_light();
  }
}

TEST_F(Tools, AHoleOnTheFarSideIsNotSeen) {
  const DrillLine back{
      line_.world_from_tool(line_.through_mm) *
          RigidTransform{rotation_about(Vec3(0.0, 1.0, 0.0), 3.14159265358979), Vec3(0.0)},
      line_.through_mm};
  scene_.holes = {hole_at(*world, back, 1.0), HoleInScene{{Vec3(0.0), Vec3(1.0)}, Vec3(1.0)}};
  EXPECT_EQ(draw().rgba, bare_.rgba);
}

TEST_F(Tools, AreCounted) {
  const std::size_t bones = renderer_.counts().triangles;
  scene_.driver = DriverInScene{line_.world_from_tool(-2.0), Drill{}};
  draw();
  const std::size_t with_drill = renderer_.counts().triangles;
  EXPECT_GT(with_drill, bones + 3000);
  EXPECT_LT(with_drill, bones + 11000);
  scene_.driver.reset();
  scene_.forceps = ForcepsInScene{line_.world_from_tool(-2.0)};
  scene_.implants = {{line_.world_from_tool(8.0), WireDriver{}}};
  draw();
  EXPECT_GT(renderer_.counts().triangles, bones + 2000);
  EXPECT_LT(renderer_.counts().triangles, bones + 11000);
  scene_.forceps.reset();
  scene_.implants.clear();
  draw();
  EXPECT_EQ(renderer_.counts().triangles, bones);
}

}  // namespace
}  // namespace hallux::tests
