#include "ui/jobs/cut_sweep.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/outline_area.h"
namespace hallux::ui {
namespace {

const std::string good_sweep =
    R"({"blade": {"width_mm": 13, "depth_mm": 30},
        "poses": [{"tip": [1, -20, 0], "direction": [0, 1, 0]},
                  {"tip": [1, 7.5, 0], "direction": [0, 2, 0]}]})";

/// The good sweep with the first `from` replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = good_sweep;
  return text.replace(text.find(from), from.size(), to);
}

std::string refusal_of(const std::string& text) {
  try {
    parse_sweep(text, "sweep.json");
  } catch (const CutInputError& error) {
    return error.what();
  }
  return "";
}

TEST(Sweep, IsReadAsItStandsWithDirectionsOfUnitLength) {
  const simulator::Sweep sweep = parse_sweep(good_sweep, "sweep.json");
  EXPECT_EQ(sweep.width_mm, 13.0);
  EXPECT_EQ(sweep.depth_mm, 30.0);
  ASSERT_EQ(sweep.poses.size(), 2U);
  EXPECT_EQ(sweep.poses[1].tip_in_mesh_mm, Vec3(1.0, 7.5, 0.0));
  EXPECT_EQ(sweep.poses[1].direction, Vec3(0.0, 1.0, 0.0));
}

TEST(Sweep, WithAKeyTwiceInOneObjectIsRefused) {
  const std::string twice = "is twice in the same object";
  for (const std::string& text : {changed("\"blade\"", "\"poses\": [], \"blade\""),
                                  changed("\"width_mm\"", "\"width_mm\": 5, \"width_mm\""),
                                  changed("\"tip\"", "\"tip\": [0, 0, 0], \"tip\"")}) {
    EXPECT_NE(refusal_of(text).find(twice), std::string::npos) << text << "\n" << refusal_of(text);
  }
}

TEST(Sweep, ThatIsRefusedNamesThePathOfTheValueAndTheMend) {
  EXPECT_EQ(refusal_of(changed("13", "-13")),
            "sweep.json: blade.width_mm: is -13; give a number from 0.1 to 1000");
  EXPECT_EQ(refusal_of(changed("[1, 7.5, 0]", "[1, 7.5]")),
            "sweep.json: poses[1].tip: has 2 entries; give a list of 3 to 3 entries");
  EXPECT_EQ(refusal_of(changed("[0, 2, 0]", "[0, 0, 0]")),
            "sweep.json: poses[1].direction: is [0,0,0]; give a vector with a length");
  EXPECT_EQ(
      refusal_of(changed("\"blade\"", "\"speed\": 1, \"blade\"")),
      "sweep.json: top: the key \"speed\" is unknown; remove it, or use one of: blade, poses");
  EXPECT_NE(refusal_of("{\n\"blade\" 1}").find("line 2, column 9"), std::string::npos);
}

TEST(Sweep, DeeperThanAnySweepIsRefused) {
  EXPECT_NE(refusal_of(std::string(200'000, '[')).find("deeper than"), std::string::npos);
}

TEST(Sweep, OutOfItsPlaneIsRefusedWithThePose) {
  const simulator::KerfPlane plane{
      {rotation_from_axes(Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)), Vec3(1.0, 0.0, 0.0)}, 0.5};
  const auto refusal = [&](const std::string& text) -> std::string {
    try {
      expect_in_plane(parse_sweep(text, "sweep.json"), plane, "sweep.json");
    } catch (const CutInputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(good_sweep), "");
  EXPECT_EQ(refusal(changed("[1, 7.5, 0]", "[1.5, 7.5, 0]")),
            "sweep.json: poses[1].tip: lies 0.5 mm off the plane; keep the blade in it within "
            "0.01 mm");
  EXPECT_NE(refusal(changed("[0, 2, 0]", "[0.1, 2, 0]")).find("poses[1].direction: "),
            std::string::npos);
}

}  // namespace
}  // namespace hallux::ui
