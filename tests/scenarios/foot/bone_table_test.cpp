#include "scenarios/foot/bone_table.h"

#include <gtest/gtest.h>

#include "scenarios/foot/first_metatarsal.h"
#include "scenarios/foot/first_proximal_phalanx.h"

namespace hallux::scenarios {
namespace {

constexpr const char* good_table = R"(# a comment
bone toe T1
credit Somebody, CC BY 4.0
length 30
relief 0.1
station 0.1 0 0 5 5 2 0 0 0 0
station 0.4 0 0 4 4 2 90 0 0 0
station 0.6 0 0 4 4 2 0 0 0 0
station 0.9 0 0 5 5 2 0 0 0 0
cap base 0 2 2 0 0 0 0 0 0 0
cap head 30 4 2 0 0 0 0 0 0 0
bump knob 5 6 7 1 2 3 -0.4
groove line 1 2 3 4 5 6 0.7 0.2
cartilage 25 0 0 5 40 50 60 70
eminence 25 0 -1 3 3 3 1
sulcus 26 4 -2
sulcus 29 0 -2
sulcus_groove 1 0.5 0.3
cortex 1.5 0.6
place 1 2 3 4 5 6
)";

std::string complaint_about(const std::string& text) {
  try {
    parse_bone_table(text, "toe.txt");
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "no complaint";
}

std::string with_line(std::string_view old_start, std::string_view line) {
  std::string text = good_table;
  const std::size_t at = text.find(old_start);
  return text.replace(at, text.find('\n', at) - at, line);
}

TEST(BoneTable, KeepsEveryNumberAndTurnsDegreesIntoRadians) {
  const BoneTable table = parse_bone_table(good_table, "toe.txt");
  EXPECT_EQ(table.bone, "toe");
  EXPECT_EQ(table.shape, "T1");
  EXPECT_EQ(table.credit, "Somebody, CC BY 4.0");
  ASSERT_EQ(table.stations.size(), 4U);
  EXPECT_DOUBLE_EQ(table.stations[1].twist_rad, 1.5707963267948966);
  EXPECT_EQ(table.head.rim_radius_mm, 4.0);
  ASSERT_EQ(table.features.size(), 2U);
  EXPECT_EQ(table.features[0].height_mm, -0.4);
  EXPECT_EQ(table.features[1].kind, FeatureKind::Groove);
  EXPECT_EQ(table.features[1].end_mm, Vec3(4.0, 5.0, 6.0));
  ASSERT_TRUE(table.eminence.has_value());
  EXPECT_EQ(table.eminence->sulcus_mm.size(), 2U);
  EXPECT_EQ(table.cortex.mid_mm, 1.5);
  EXPECT_EQ(table.cortex.floor_mm, 0.6);
  EXPECT_EQ(table.place.head_in_world_mm, Vec3(4.0, 5.0, 6.0));
}

TEST(BoneTable, NamesTheLineAndTheMendOfAStationWithoutAllItsNumbers) {
  const std::string said = complaint_about(with_line("station 0.4", "station 0.4 0 0 4"));
  EXPECT_EQ(said,
            "toe.txt, line 7: found 4 numbers, needs 10; write: station s cy cz a b n tw c3 s3 e1");
}

TEST(BoneTable, RefusesWhatIsNotANumber) {
  EXPECT_NE(
      complaint_about(with_line("length", "length long")).find("line 4: 'long' is not a number"),
      std::string::npos);
  EXPECT_NE(complaint_about(with_line("relief", "relief nan")).find("'nan' is not a number"),
            std::string::npos);
}

TEST(BoneTable, RefusesStationsOutOfOrder) {
  EXPECT_NE(complaint_about(with_line("station 0.6", "station 0.3 0 0 4 4 2 0 0 0 0"))
                .find("line 8: a station's s must rise"),
            std::string::npos);
}

TEST(BoneTable, RefusesAnUnknownKindOfLine) {
  EXPECT_NE(complaint_about(with_line("bump", "lump knob")).find("'lump' is not a kind of line"),
            std::string::npos);
}

TEST(BoneTable, SaysWhichLineIsMissing) {
  EXPECT_EQ(complaint_about(with_line("cap head", "")),
            "toe.txt: has 0 lines 'cap head', needs exactly one");
  EXPECT_NE(complaint_about("").find("has 0 lines 'bone'"), std::string::npos);
}

TEST(BoneTable, MayBeWithoutAnEminenceButNotWithAPartOfOne) {
  std::string text = good_table;
  const std::size_t from = text.find("eminence");
  text.erase(from, text.find("cortex") - from);
  EXPECT_FALSE(parse_bone_table(text, "toe.txt").eminence.has_value());
  EXPECT_EQ(complaint_about(with_line("eminence", "")),
            "toe.txt: has 0 lines 'eminence', needs exactly one");
  EXPECT_EQ(complaint_about(with_line("sulcus 29", "")),
            "toe.txt: needs at least two lines 'sulcus'");
}

TEST(BoneTable, RefusesACortexWithoutThickness) {
  EXPECT_NE(complaint_about(with_line("cortex", "cortex 0 0.7")).find("mid must be above 0"),
            std::string::npos);
}

TEST(BoneTable, NamesTheTablesThatAreShipped) {
  try {
    shipped_bone_table("tail.txt");
    FAIL();
  } catch (const ScenarioError& error) {
    EXPECT_STREQ(error.what(),
                 "no bone table 'tail.txt' is shipped; use one of: first_metatarsal.txt, "
                 "first_proximal_phalanx.txt");
  }
}

TEST(BoneTable, ShipsTheFirstMetatarsalWithItsCredit) {
  const BoneTable table = first_metatarsal_table();
  EXPECT_EQ(table.bone, "first_metatarsal");
  EXPECT_EQ(table.stations.size(), 12U);
  EXPECT_EQ(table.features.size(), 12U);
  EXPECT_NE(table.credit.find("BodyParts3D"), std::string::npos);
}

TEST(BoneTable, ShipsTheFirstProximalPhalanxWithItsCreditAndWithoutAnEminence) {
  const BoneTable table = first_proximal_phalanx_table();
  EXPECT_EQ(table.bone, "first_proximal_phalanx");
  EXPECT_EQ(table.stations.size(), 10U);
  EXPECT_EQ(table.features.size(), 5U);
  EXPECT_FALSE(table.eminence.has_value());
  EXPECT_NE(table.credit.find("BodyParts3D"), std::string::npos);
}

}  // namespace
}  // namespace hallux::scenarios
