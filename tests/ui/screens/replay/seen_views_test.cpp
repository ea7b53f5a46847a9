#include "ui/screens/replay/seen_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "simulator/base/units.h"
#include "ui/screens/pictures/shown_camera.h"

namespace hallux::ui {
namespace {

using simulator::DisplayFact;
using simulator::ShownView;

ShownView turned(double degree) {
  const double half_rad = 0.5 * radian_from_degree(degree);
  ShownView view;
  view.world_from_view = Quat(std::cos(half_rad), 0.0, std::sin(half_rad), 0.0);
  return view;
}

DisplayFact fact_at(std::int64_t tick, double degree) { return *fact_of(turned(degree), tick); }

double degree_of(const SeenView& seen) {
  EXPECT_EQ(seen.seen, Seen::Recorded);
  const Quat& turn = seen.view.world_from_view;
  return degree_from_radian(2.0 * std::atan2(turn.y, turn.w));
}

TEST(SeenViews, StandUntilTheNextAndBeginWithTheFirst) {
  const SeenViews views({fact_at(500, 10.0), fact_at(3000, 60.0)});
  EXPECT_NEAR(degree_of(views.at(0.0)), 10.0, 1.0e-3);
  EXPECT_NEAR(degree_of(views.at(2.999)), 10.0, 1.0e-3) << "a jump is a jump";
  EXPECT_NEAR(degree_of(views.at(3.0)), 60.0, 1.0e-3);
  EXPECT_NEAR(degree_of(views.at(1000.0)), 60.0, 1.0e-3);
}

TEST(SeenViews, TurnAsThePersonTurned) {
  DisplayFact nearer = fact_at(1100, 20.0);
  nearer.magnification_milli *= 4;
  nearer.target_in_world_um = {10'000, 0, 0};
  const SeenViews views({fact_at(1000, 10.0), nearer});
  const SeenView half_way = views.at(1.05);
  EXPECT_NEAR(degree_of(half_way), 15.0, 0.01);
  EXPECT_NEAR(half_way.view.magnification, 16.0, 0.01);
  EXPECT_NEAR(half_way.view.target_in_world_mm.x, 5.0, 1.0e-6);
  double before = 0.0;
  for (double time_s = 1.0; time_s < 1.1; time_s += 0.004) {
    const double now = degree_of(views.at(time_s));
    EXPECT_GE(now, before);
    before = now;
  }
}

TEST(SeenViews, OfAnOlderAttemptAreNone) {
  EXPECT_EQ(SeenViews().at(1.0).seen, Seen::NotRecorded);
  EXPECT_EQ(SeenViews(std::vector<DisplayFact>{}).at(1.0).seen, Seen::NotRecorded);
}

TEST(SeenViews, ThatAreHostileOrUnknownAreTakenForNone) {
  DisplayFact no_rotation = fact_at(1000, 0.0), nothing = no_rotation, newer = no_rotation,
              far = no_rotation;
  no_rotation.world_from_view_micro = {};
  nothing.magnification_milli = 0;
  newer.layout = static_cast<simulator::ShownLayout>(12);
  far.target_in_world_um[2] = std::numeric_limits<std::int64_t>::min();
  for (const DisplayFact& hostile : {no_rotation, nothing, newer, far}) {
    const SeenViews views({fact_at(900, 5.0), hostile, fact_at(1100, 8.0)});
    EXPECT_NEAR(degree_of(views.at(0.95)), 5.0, 1.0e-3) << "nothing is turned towards it";
    EXPECT_EQ(views.at(1.05).seen, Seen::Unusable);
    EXPECT_NEAR(degree_of(views.at(1.2)), 8.0, 1.0e-3) << "the next is good again";
  }
}

TEST(SeenViews, SayWhatIsShown) {
  const Texts texts = english_texts();
  SeenView seen;
  EXPECT_EQ(seen_text(texts, seen), texts.text("replay.seen.not_recorded"));
  seen.seen = Seen::Unusable;
  EXPECT_EQ(seen_text(texts, seen), texts.text("replay.seen.unusable"));
  seen.seen = Seen::Recorded;
  EXPECT_EQ(seen_text(texts, seen), texts.text("replay.seen.screen"));
  seen.view.stereo = simulator::ShownStereo::SideBySide;
  EXPECT_EQ(seen_text(texts, seen), texts.text("replay.seen.side_by_side"));
  seen.view.layout = simulator::ShownLayout::WithSection;
  EXPECT_EQ(seen_text(texts, seen), texts.text("replay.seen.side_by_side_section"));
}

TEST(ShownCamera, ShowsAllThatWasSeenInAPictureOfAnotherShape) {
  Camera camera;
  camera.magnification = 10.0;
  const ShownView view = shown_view(camera, 1.6);
  EXPECT_EQ(camera_of(view, 1.6), camera);
  const Viewer viewer;
  const auto corner = [&](const Camera& shown, double aspect) {
    // The upper right of what was seen, in the plane of the screen.
    const Vec3 place(0.5 * viewer.screen_width_mm / 10.0, 0.5 * viewer.screen_width_mm / 16.0, 6.0);
    return place_in_picture(view_of(shown, viewer, Eye::Middle, aspect), place);
  };
  for (const double aspect : {1.0, 1.6, 2.5}) {
    const Vec3 place = corner(camera_of(view, aspect), aspect);
    EXPECT_LE(place.x, 1.0 + 1.0e-9) << aspect;
    EXPECT_GE(place.y, -1.0e-9) << aspect;
    EXPECT_NEAR(std::min(1.0 - place.x, place.y), 0.0, 0.01) << "and no more than that";
  }
}

}  // namespace
}  // namespace hallux::ui
