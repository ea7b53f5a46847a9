// What is drawn at the site of a cut, measured on pictures.
#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/units.h"
#include "simulator/cutting/pieces/cut_solid.h"
#include "tests/ui/render/graphics.h"
#include "tests/ui/render/operating_world.h"
#include "ui/render/renderer.h"
#include "ui/render/scene/plane_fade.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr PixelSize size{640, 360};

bool is_reference(const Colour& colour) {
  return colour.red > colour.green + 70 && colour.blue > colour.green + 30;
}
bool is_orange(const Colour& colour) {
  return colour.red > 120 && colour.red > colour.blue + 80 && colour.red > colour.green + 45;
}
bool is_blue(const Colour& colour) { return colour.blue > 160 && colour.red < 120; }

class Site : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    world = new OperatingWorld(0.9);
    world->saw_to(-4.0);
  }
  static void TearDownTestSuite() { delete world; }

  Site() {
    scene_.planes.clear();
    scene_.lines.clear();
  }
  Pixels draw(const Camera& camera) {
    const RenderTarget target(size);
    renderer_.draw(scene_, camera, target.target());
    return target.read();
  }
  Facts facts(bool (*is_picked)(const Colour&)) {
    return facts_of(draw(world->camera()), is_picked);
  }
  /// Sees the first cut's face under that angle, from distal.
  Camera under(double angle_deg) const {
    const RigidTransform plane = world->world_from_face("proximal_face");
    const Vec3 along = plane.rotation * Vec3(0.0, 1.0, 0.0);
    const Vec3 from = rotation_about(along, radian_from_degree(angle_deg)) *
                      (plane.rotation * Vec3(-1.0, 0.0, 0.0));
    Camera camera = world->camera();
    camera.target_mm = plane.translation_mm;
    camera.target_depth_mm = 0.0;
    camera.world_from_view = rotation_from_axes(glm::normalize(glm::cross(along, from)), along);
    return camera;
  }

  static OperatingWorld* world;
  HeadlessContext context_;
  Scene scene_ = world->scene();
  Renderer renderer_{RenderQuality{}};
};
OperatingWorld* Site::world = nullptr;

TEST_F(Site, APlaneThatTurnsToItsEdgeFadesToTheLineThatItCuts) {
  scene_.saw.reset();
  scene_.bones.pop_back();
  scene_.planes = {{world->world_from_face("proximal_face"), Vec2(16.0, 13.0)}};
  const auto seen_under = [&](double angle_deg) {
    return facts_of(draw(under(angle_deg)), is_reference).count;
  };
  const auto line_under = [&](double angle_deg) {
    Scene with_plane = scene_;
    scene_.lines = {
        line_of(with_plane.planes.front(),
                view_of(under(angle_deg), Viewer{}, Eye::Middle, 16.0 / 9.0).eye_in_world_mm)};
    scene_.planes.clear();
    Pixels picture = draw(under(angle_deg));
    scene_ = with_plane;
    return picture;
  };
  // Face on there is a rectangle around the bone, edge on not a pixel of it beyond its line.
  EXPECT_GT(seen_under(30.0), facts_of(line_under(30.0), is_reference).count + 300);
  for (const double angle_deg : {0.0, 1.0, 3.5, 7.5}) {
    EXPECT_EQ(draw(under(angle_deg)).rgba, line_under(angle_deg).rgba) << angle_deg;
    EXPECT_GT(seen_under(angle_deg), 60U) << "the line and its tick stay, " << angle_deg;
  }
}

TEST(PlaneFade, IsWholeFromTwentyFourDegreesOnAndGoneAtEight) {
  const RigidTransform plane{};
  double last = 0.0;
  for (int degree = 0; degree <= 90; ++degree) {
    const double angle_rad = radian_from_degree(degree);
    const Vec3 eye_mm = 100.0 * Vec3(std::cos(angle_rad), 0.0, std::sin(angle_rad));
    EXPECT_NEAR(sight_angle_rad(plane, eye_mm), angle_rad, 1e-9);
    const double share = face_on_share(plane, eye_mm);
    EXPECT_GE(share, last);
    EXPECT_EQ(share == 0.0, degree <= 8) << degree;
    EXPECT_EQ(share == 1.0, degree > 24) << degree;
    EXPECT_EQ(line_of({plane}, eye_mm).tick_mm > 0.0, share < 0.5);
    last = share;
  }
}

TEST_F(Site, ALineEndsWhereItsPlaneDoes) {
  scene_.saw.reset();
  scene_.bones.pop_back();
  const RigidTransform plane = world->world_from_face("proximal_face");
  const auto line_of_half = [&](double half_mm, double faint_mm) {
    scene_.lines = {
        {.world_from_plane = plane, .half_mm = Vec2(0.0, half_mm), .faint_mm = faint_mm}};
    return facts(is_blue).count;
  };
  const std::size_t all = line_of_half(0.0, 0.0);
  EXPECT_LT(line_of_half(5.0, 0.0), all / 2);
  EXPECT_GT(line_of_half(5.0, 0.0), 10U);
  const Pixels cut_off = draw(world->camera());
  line_of_half(5.0, 100.0);
  EXPECT_NE(draw(world->camera()).rgba, cut_off.rgba) << "faintly on beyond its ends";
}

TEST_F(Site, ADashedLineHasGaps) {
  scene_.saw.reset();
  const auto count = [&](bool is_dashed) {
    scene_.lines = {
        {.world_from_plane = world->world_from_face("proximal_face"), .is_dashed = is_dashed}};
    return static_cast<double>(facts(is_blue).count);
  };
  const double whole = count(false);
  EXPECT_NEAR(count(true) / whole, 0.64, 0.12);
}

TEST_F(Site, ADangerZoneIsFaintAndDashedUntilTheBladeIsNear) {
  const Facts none = facts(is_orange);
  const std::vector<ZoneInScene> zones = world->zones();
  ASSERT_FALSE(zones.empty());
  scene_.zones = {zones.front()};
  const Facts far = facts(is_orange);
  const Pixels far_picture = draw(world->camera());
  scene_.zones.front().is_near = true;
  const Facts near = facts(is_orange);
  EXPECT_GT(far.count, none.count + 20) << "seen";
  EXPECT_GT(near.count, 2 * far.count) << "lit, and whole where it was dashed";
  scene_.zones.front().presence = 0.0;
  EXPECT_EQ(facts(is_orange).count, none.count);
  scene_.zones.clear();
  // Faint: where it is not outlined it changes little of what lies behind it.
  const Pixels without = draw(world->camera());
  std::size_t little = 0, much = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int by = std::abs(pixel_at(far_picture, x, y).red - pixel_at(without, x, y).red);
      little += by > 0 && by < 30 ? 1U : 0U;
      much += by >= 30 ? 1U : 0U;
    }
  }
  EXPECT_GT(little, 3 * much);
}

TEST_F(Site, ANearZoneIsSeenBehindTheBoneAndAFarOneIsNot) {
  // Dorsal of the bone, seen from plantar: hidden but for its rims.
  Camera camera = standard_view(world->camera(), StandardView::Dorsal);
  scene_.saw.reset();
  scene_.zones = {{.from_mm = camera.target_mm - Vec3(4.0, 14.0, 0.0),
                   .to_mm = camera.target_mm + Vec3(4.0, -14.0, 0.0),
                   .radius_mm = 2.0}};
  const Pixels far = draw(camera);
  scene_.zones.front().is_near = true;
  const Pixels near = draw(camera);
  scene_.zones.clear();
  const Pixels without = draw(camera);
  EXPECT_EQ(far.rgba, without.rgba);
  EXPECT_NE(near.rgba, without.rgba);
}

TEST_F(Site, BoneThatHoldsIsTintedAndWhatIsOpenIsNot) {
  scene_.saw.reset();
  const auto is_amber = [](const Colour& colour) {
    return colour.red > 150 && colour.red > colour.blue + 90;
  };
  const Facts none = facts_of(draw(world->camera()), is_amber);
  const HeldBone held = world->held();
  ASSERT_FALSE(held.opened_mm.empty());
  scene_.held = {held};
  const Facts standing = facts_of(draw(world->camera()), is_amber);
  scene_.held.front().opened_mm.clear();
  const Facts all = facts_of(draw(world->camera()), is_amber);
  scene_.held.front().bone_mm.clear();
  const Facts nothing = facts_of(draw(world->camera()), is_amber);
  EXPECT_GT(standing.count, none.count + 200);
  EXPECT_GT(all.count, standing.count + 100);
  EXPECT_EQ(nothing.count, none.count);
}

TEST_F(Site, APieceThatCameFreeHasAnOutlineAroundIt) {
  scene_.saw.reset();
  const std::size_t none = facts(is_blue).count;
  scene_.free_pieces = {{scene_.bones.front().mesh, scene_.bones.front().world_from_bone}};
  const Facts outlined = facts(is_blue);
  EXPECT_GT(outlined.count, none + 200);
  // Beside the bone and not on it.
  EXPECT_LT(outlined.share, 0.03);
}

TEST_F(Site, TheHaloShrinksAsTheTeethComeNearerAndIsFilledOnTheBone) {
  const auto ring_of = [&](HaloKind kind, double away_mm) {
    RigidTransform tool = world->world_from_tool();
    tool.translation_mm -= tool.rotation * Vec3(away_mm + 4.0, 0.0, 0.0);
    scene_.saw->world_from_tool = tool;
    scene_.halo.reset();
    const Pixels without = draw(world->camera());
    scene_.halo = ContactHalo{kind, tool, 4.0, away_mm};
    const Pixels with = draw(world->camera());
    std::size_t changed = 0;
    int low = size.width, high = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        if (pixel_at(with, x, y).red == pixel_at(without, x, y).red) continue;
        ++changed;
        low = std::min(low, x);
        high = std::max(high, x);
      }
    }
    return std::pair(changed, high - low);
  };
  const auto far = ring_of(HaloKind::Before, 12.0);
  const auto near = ring_of(HaloKind::Before, 3.0);
  const auto on = ring_of(HaloKind::On, 0.0);
  EXPECT_GT(far.second, near.second + 5);
  EXPECT_GT(near.second, on.second);
  EXPECT_GT(on.first, 30U);
}

TEST_F(Site, TheHaloIsDashedWhereBoneHidesTheTeeth) {
  scene_.halo = ContactHalo{HaloKind::Behind, world->world_from_tool(), 5.0, 0.0};
  const Facts behind = facts(is_blue);
  EXPECT_GT(behind.count, 15U);
  // Around the place where the teeth are.
  const Vec3 tip = place_in_picture(view_of(world->camera(), Viewer{}, Eye::Middle, 16.0 / 9.0),
                                    world->world_from_tool().translation_mm);
  EXPECT_NEAR(behind.x, tip.x, 0.03);
  EXPECT_NEAR(behind.y, tip.y, 0.05);
}

TEST_F(Site, AFaintHandpieceLeavesTheBladeAlone) {
  scene_.bones.clear();
  const auto is_drawn = [](const Colour& colour) {
    return colour.red > 90 && std::abs(colour.red - colour.blue) < 40;
  };
  const Facts whole = facts_of(draw(world->camera()), is_drawn);
  scene_.saw->handpiece_presence = 0.1;
  const Facts faint = facts_of(draw(world->camera()), is_drawn);
  EXPECT_LT(faint.count, 0.75 * static_cast<double>(whole.count));
  EXPECT_GT(faint.count, 1000U) << "the blade";
}

}  // namespace
}  // namespace hallux::tests
