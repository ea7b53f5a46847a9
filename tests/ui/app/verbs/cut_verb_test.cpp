#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "simulator/base/progress.h"
#include "simulator/mesh/mesh_error.h"
#include "simulator/mesh/read_mesh.h"
#include "simulator/mesh/write_ply.h"
#include "tests/support/worlds.h"
#include "ui/app/terminal/interrupt.h"
#include "ui/app/verbs/verbs.h"
#include "ui/jobs/cut_sweep.h"
#include "ui/jobs/files/output_error.h"

namespace hallux::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A folder of its own with bone.ply in it: a block of 30 x 14 x 12 mm about the origin.
class CutVerb : public ::testing::Test {
 protected:
  CutVerb() {
    std::string name = (fs::temp_directory_path() / "hallux-cut-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    simulator::write_ply(solid_block(Vec3(30.0, 14.0, 12.0)), folder_ / "bone.ply");
  }
  ~CutVerb() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  /// Runs `hallux cut <bone> <arguments> -o out --json`; throws what the verb throws.
  json cut(std::vector<std::string> arguments) {
    std::ostringstream out, notes;
    std::istringstream in;
    ui::VerbContext context{out, notes, in, {}, {}, true, true, {}};
    CLI::App app;
    ui::add_cut_verb(app, context);
    arguments.insert(arguments.begin(), {"cut", bone().string(), "-o", out_folder().string()});
    std::vector<const char*> line{"hallux"};
    for (const std::string& argument : arguments) line.push_back(argument.c_str());
    app.parse(static_cast<int>(line.size()), line.data());
    EXPECT_EQ(context.chosen(), ui::ExitCode::Done);
    return json::parse(out.str());
  }
  /// What the verb says of the output folder; nothing where it wrote there.
  std::optional<ui::OutputErrorKind> refused_output(const std::vector<std::string>& arguments) {
    try {
      cut(arguments);
    } catch (const ui::OutputError& error) {
      return error.kind();
    }
    return std::nullopt;
  }
  std::string write_sweep(const std::string& text, const char* name = "sweep.json") const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  fs::path bone() const { return folder_ / "bone.ply"; }
  fs::path out_folder() const { return folder_ / "made" / "here"; }

  fs::path folder_;
  ui::InterruptWatch interrupts_;  // as the command holds it
};

/// A blade that comes from -y in the plane x = 1 and stops with its teeth at y = `tip_mm`.
std::string sweep_to(double tip_mm) {
  const json pose_far = {{"tip", {1.0, -20.0, 0.0}}, {"direction", {0.0, 1.0, 0.0}}};
  const json pose_near = {{"tip", {1.0, tip_mm, 0.0}}, {"direction", {0.0, 2.0, 0.0}}};
  return json{{"blade", {{"width_mm", 13.0}, {"depth_mm", 30.0}}}, {"poses", {pose_far, pose_near}}}
      .dump();
}

double sum_of_pieces_mm3(const json& answer) {
  double sum_mm3 = answer.at("debris_mm3").get<double>();
  for (const json& piece : answer.at("pieces")) sum_mm3 += piece.at("volume_mm3").get<double>();
  return sum_mm3;
}

TEST_F(CutVerb, WritesClosedPiecesWhoseVolumesAddUp) {
  const json answer =
      cut({"--plane", "1,0,0,2", "--kerf", "0.5", "--plane", "-2,0,0,6", "--kerf", "1.0"});
  ASSERT_EQ(answer.at("pieces").size(), 3U);
  EXPECT_NEAR(answer.at("input_mm3").get<double>(), 5040.0, 1e-9);
  EXPECT_NEAR(answer.at("removed_mm3").get<double>(), 1.5 * 168.0, 1e-9);
  EXPECT_NEAR(answer.at("cuts").at(1).at("removed_mm3").get<double>(), 168.0, 1e-9);
  EXPECT_NEAR(sum_of_pieces_mm3(answer) + answer.at("removed_mm3").get<double>(), 5040.0, 1e-8);
  EXPECT_TRUE(answer.at("frame_ms").at("p99").is_null());
  double last_mm3 = 1e9;
  for (const json& piece : answer.at("pieces")) {
    EXPECT_TRUE(piece.at("closed").get<bool>());
    const auto mesh = simulator::read_mesh(out_folder() / piece.at("file").get<std::string>());
    EXPECT_EQ(mesh.triangles.size(), piece.at("triangles").get<std::size_t>());
    EXPECT_NEAR(simulator::signed_volume_mm3(mesh), piece.at("volume_mm3").get<double>(), 1e-9);
    EXPECT_LE(piece.at("volume_mm3").get<double>(), last_mm3);
    last_mm3 = piece.at("volume_mm3").get<double>();
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(out_folder()), fs::directory_iterator()), 3);
}

TEST_F(CutVerb, APlaneThatMissesLeavesOnePiece) {
  const json answer = cut({"--plane", "0,0,1,80", "--kerf", "0.5"});
  EXPECT_EQ(answer.at("pieces").size(), 1U);
  EXPECT_EQ(answer.at("removed_mm3").get<double>(), 0.0);
  EXPECT_EQ(simulator::read_mesh(out_folder() / "piece-1.ply"), simulator::read_mesh(bone()));
}

TEST_F(CutVerb, ASweepAllTheWayThroughCutsLikeThePlane) {
  const json answer =
      cut({"--plane", "1,0,0,1", "--kerf", "0.5", "--sweep", write_sweep(sweep_to(7.5))});
  EXPECT_EQ(answer.at("pieces").size(), 2U);
  EXPECT_NEAR(answer.at("removed_mm3").get<double>(), 84.0, 1e-9);
}

TEST_F(CutVerb, ASweepBesideTheBoneLeavesIt) {
  const json answer =
      cut({"--plane", "1,0,0,1", "--kerf", "0.5", "--sweep", write_sweep(sweep_to(-9.0))});
  EXPECT_EQ(answer.at("pieces").size(), 1U);
  EXPECT_EQ(answer.at("removed_mm3").get<double>(), 0.0);
}

TEST_F(CutVerb, ASweepThatStopsInsideTheBoneLeavesOnePieceWithAKerf) {
  const json answer =
      cut({"--plane", "1,0,0,1", "--kerf", "0.5", "--sweep", write_sweep(sweep_to(2.0))});
  EXPECT_EQ(answer.at("pieces").size(), 1U);
  EXPECT_NEAR(answer.at("removed_mm3").get<double>(), 0.5 * 12.0 * 9.0, 2.0e-3);
  EXPECT_NEAR(sum_of_pieces_mm3(answer) + answer.at("removed_mm3").get<double>(), 5040.0, 2.0e-5);
  const auto mesh = simulator::read_mesh(out_folder() / "piece-1.ply");
  EXPECT_NO_THROW(simulator::check_closed_solid(mesh, "piece-1.ply"));
}

TEST_F(CutVerb, EachPoseOfASweepIsAFrame) {
  const json answer = cut({"--plane", "1,0,0,1", "--kerf", "0.5", "--sweep",
                           write_sweep(sweep_to(2.0)), "--plane", "1,0,0,8", "--kerf", "0.5"});
  const json &swept = answer.at("cuts").at(0), &through = answer.at("cuts").at(1);
  EXPECT_EQ(swept.at("frames"), 2);
  EXPECT_EQ(through.at("frames"), 0);
  EXPECT_GT(swept.at("frame_ms").at("median").get<double>(), 0.0);
  EXPECT_TRUE(through.at("frame_ms").at("median").is_null());
  EXPECT_EQ(answer.at("frame_ms"), swept.at("frame_ms"));
  EXPECT_LE(swept.at("frame_ms").at("median").get<double>(),
            swept.at("frame_ms").at("max").get<double>());
  EXPECT_EQ(answer.at("refused_frames"), 0);
  EXPECT_GT(answer.at("triangles_max").get<int>(), 0);
  EXPECT_LE(std::abs(answer.at("missing_mm3").get<double>()), 1.0e-6 * 5040.0);
}

TEST_F(CutVerb, ThePlaneOfAnEarlierGroupReopensItsKerf) {
  const std::string sweep = write_sweep(sweep_to(2.0));
  const json answer = cut({"--plane", "1,0,0,1", "--kerf", "0.5", "--sweep", sweep, "--plane",
                           "1,0.002,0,1.05", "--kerf", "0.5"});
  EXPECT_TRUE(answer.at("cuts").at(0).at("reopens").is_null());
  EXPECT_EQ(answer.at("cuts").at(1).at("reopens"), 1);
  EXPECT_EQ(answer.at("pieces").size(), 2U);
  EXPECT_NEAR(answer.at("removed_mm3").get<double>(), 84.0, 1e-9);
  EXPECT_NEAR(answer.at("cuts").at(1).at("removed_mm3").get<double>(), 30.0, 2.0e-3);
}

/// Two kerfs of 10 degrees that stop where their planes meet, in x = 0, y = 6.
std::vector<std::string> wedge_groups(const std::string& first, const std::string& second) {
  return {"--plane", "0.99619469809,-0.08715574275,0,-0.5229344565",
          "--kerf",  "0.5",
          "--sweep", first,
          "--plane", "0.99619469809,0.08715574275,0,0.5229344565",
          "--kerf",  "0.5",
          "--sweep", second};
}

std::string sweep_to_hinge(double side) {
  json poses = json::array();
  for (const double back_mm : {20.0, 0.0}) {
    const Vec3 direction(side * 0.08715574275, 0.99619469809, 0.0);
    const Vec3 tip_mm = Vec3(0.0, 6.0, 0.0) - back_mm * direction;
    poses.push_back({{"tip", {tip_mm.x, tip_mm.y, tip_mm.z}},
                     {"direction", {direction.x, direction.y, direction.z}}});
  }
  return json{{"blade", {{"width_mm", 13.0}, {"depth_mm", 40.0}}}, {"poses", poses}}.dump();
}

TEST_F(CutVerb, ClosesTheHingeThatTwoGroupsLeave) {
  const std::string first = write_sweep(sweep_to_hinge(1.0));
  const std::string second = write_sweep(sweep_to_hinge(-1.0), "second.json");
  std::vector<std::string> arguments = wedge_groups(first, second);
  EXPECT_TRUE(cut(arguments).at("hinge").is_null());
  EXPECT_EQ(cut(arguments).at("pieces").size(), 2U);
  arguments.insert(arguments.end(), {"--close", "1,2"});
  const json answer = cut(arguments);
  const json& hinge = answer.at("hinge");
  EXPECT_EQ(hinge.at("outcome"), "closed");
  EXPECT_NEAR(hinge.at("angle_deg").get<double>(), 12.2, 0.1);
  EXPECT_NEAR(hinge.at("hinge_mm").get<double>(), 1.0, 2.0e-3);
  ASSERT_EQ(answer.at("pieces").size(), 3U);
  EXPECT_EQ(hinge.at("wedge"), "piece-3.ply");
  for (const char* key : {"wedge", "fixed", "moved"}) {
    EXPECT_TRUE(fs::is_regular_file(out_folder() / hinge.at(key).get<std::string>())) << key;
  }
  EXPECT_NE(hinge.at("fixed"), hinge.at("moved"));
  EXPECT_NEAR(sum_of_pieces_mm3(answer) + answer.at("removed_mm3").get<double>(), 5040.0, 2.0e-5);
}

TEST_F(CutVerb, AHingeWithoutAWedgeIsRefusedAndNothingIsWritten) {
  const std::vector<std::vector<std::string>> groups{
      {"--plane", "1,0,0,0", "--kerf", "0.5", "--plane", "1,0,0,5", "--kerf", "0.5"},
      {"--plane", "1,0,0,0", "--kerf", "0.5", "--plane", "0,0,1,80", "--kerf", "0.5"},
      {"--plane", "1,0,0,0", "--kerf", "0.5", "--plane", "1,0,0,0", "--kerf", "0.5"}};
  for (std::vector<std::string> arguments : groups) {
    arguments.insert(arguments.end(), {"--close", "1,2"});
    EXPECT_THROW(cut(arguments), simulator::MeshError);
  }
  EXPECT_FALSE(fs::exists(folder_ / "made"));
}

TEST_F(CutVerb, InterruptedBetweenFramesLeavesNothing) {
  const std::string sweep = write_sweep(sweep_to(7.5));
  std::raise(SIGINT);
  EXPECT_THROW(cut({"--plane", "1,0,0,1", "--kerf", "0.5", "--sweep", sweep}), Cancelled);
  EXPECT_FALSE(fs::exists(folder_ / "made"));
}

TEST_F(CutVerb, SweepsThatCannotBeReadAreRefused) {
  const std::string good = sweep_to(7.5);
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  const std::vector<std::string> bad{"",
                                     "{",
                                     "[]",
                                     std::string(200000, '['),
                                     replaced("\"poses\"", "\"pose\""),
                                     replaced("\"blade\"", "\"speed\":1,\"blade\""),
                                     replaced("13.0", "-13.0"),
                                     replaced("13.0", "1e999"),
                                     replaced("13.0", "\"wide\""),
                                     replaced("[1.0,7.5,0.0]", "[1.0,7.5]"),
                                     replaced("[1.0,7.5,0.0]", "[1.02,7.5,0.0]"),
                                     replaced("[0.0,2.0,0.0]", "[0.1,2.0,0.0]"),
                                     replaced("[0.0,2.0,0.0]", "[0.0,0.0,0.0]"),
                                     R"({"blade": {"width_mm": 10, "depth_mm": 20}, "poses": []})"};
  for (const std::string& text : bad) {
    const std::string sweep = write_sweep(text);
    EXPECT_THROW(cut({"--plane", "1,0,0,1", "--kerf", "0.5", "--sweep", sweep}),
                 simulator::MeshError)
        << text.substr(0, 200);
  }
  EXPECT_THROW(cut({"--plane", "1,0,0,1", "--kerf", "0.5", "--sweep", "/nowhere.json"}),
               simulator::MeshError);
  EXPECT_FALSE(fs::exists(folder_ / "made"));
}

TEST_F(CutVerb, GroupsThatMakeNoSenseAreWrongUsage) {
  const std::vector<std::vector<std::string>> bad{
      {},
      {"--plane", "1,0,0,2"},
      {"--kerf", "0.5"},
      {"--kerf", "0.5", "--plane", "1,0,0,2"},
      {"--plane", "1,0,0,2", "--kerf", "0.5", "--kerf", "0.5"},
      {"--plane", "1,0,0", "--kerf", "0.5"},
      {"--plane", "1,0,0,2,3", "--kerf", "0.5"},
      {"--plane", "0,0,0,2", "--kerf", "0.5"},
      {"--plane", "1,0,nan,2", "--kerf", "0.5"},
      {"--plane", "1,0,x,2", "--kerf", "0.5"},
      {"--plane", "1,0,0,2", "--kerf", "0"},
      {"--plane", "1,0,0,2", "--kerf", "-1"},
      {"--plane", "1,0,0,2", "--kerf", "inf"},
      {"--plane", "1,0,0,2", "--plane", "0,1,0,2", "--kerf", "1"},
      {"--plane", "1,0,0,2", "--kerf", "1", "--close", "1,2"},
      {"--plane", "1,0,0,2", "--kerf", "1", "--plane", "0,1,0,2", "--kerf", "1", "--close", "1"},
      {"--plane", "1,0,0,2", "--kerf", "1", "--plane", "0,1,0,2", "--kerf", "1", "--close", "1,1"},
      {"--plane", "1,0,0,2", "--kerf", "1", "--plane", "0,1,0,2", "--kerf", "1", "--close", "0,1"},
      {"--plane", "1,0,0,2", "--kerf", "1", "--plane", "0,1,0,2", "--kerf", "1", "--close",
       "1,2,1"}};
  for (const std::vector<std::string>& arguments : bad) {
    EXPECT_THROW(cut(arguments), CLI::ParseError);
  }
  EXPECT_FALSE(fs::exists(folder_ / "made"));
}

TEST_F(CutVerb, AMeshThatCannotBeUsedIsRefused) {
  std::ofstream(bone()) << "solid nothing";
  EXPECT_THROW(cut({"--plane", "1,0,0,2", "--kerf", "0.5"}), simulator::MeshError);
  fs::remove(bone());
  EXPECT_THROW(cut({"--plane", "1,0,0,2", "--kerf", "0.5"}), simulator::MeshError);
}

TEST_F(CutVerb, AFileWhereTheFolderShouldBeIsTheNamesFault) {
  std::ofstream(folder_ / "made") << "a file where the folder should be";
  EXPECT_EQ(refused_output({"--plane", "1,0,0,2", "--kerf", "0.5"}), ui::OutputErrorKind::Name);
  EXPECT_TRUE(fs::is_regular_file(folder_ / "made"));
}

TEST_F(CutVerb, APieceThatCannotBePutInItsPlaceLeavesNoOther) {
  fs::create_directories(out_folder() / "piece-2.ply" / "occupied");
  EXPECT_EQ(refused_output({"--plane", "1,0,0,2", "--kerf", "0.5"}), ui::OutputErrorKind::Name);
  EXPECT_FALSE(fs::exists(out_folder() / "piece-2.ply.new"));
  EXPECT_FALSE(fs::exists(out_folder() / "piece-1.ply"));
}

}  // namespace
}  // namespace hallux::tests
