#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "database/database_error.h"
#include "simulator/mesh/mesh_error.h"
#include "simulator/mesh/read_mesh.h"
#include "simulator/mesh/write_ply.h"
#include "tests/support/worlds.h"
#include "ui/app/verb_cut.h"
#include "ui/jobs/cut_sweep.h"

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
  std::string write_sweep(const std::string& text) const {
    std::ofstream(folder_ / "sweep.json") << text;
    return (folder_ / "sweep.json").string();
  }
  fs::path bone() const { return folder_ / "bone.ply"; }
  fs::path out_folder() const { return folder_ / "made" / "here"; }

  fs::path folder_;
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

TEST_F(CutVerb, ASweepThatStopsInsideTheBoneIsRefusedAndNothingIsWritten) {
  const std::string sweep = write_sweep(sweep_to(0.0));
  try {
    cut({"--plane", "1,0,0,1", "--kerf", "0.5", "--sweep", sweep});
    FAIL() << "a partial cut was accepted";
  } catch (const simulator::MeshError& error) {
    EXPECT_NE(std::string(error.what()).find("not supported by this cutting method yet"),
              std::string::npos);
  }
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
      {"--plane", "1,0,0,2", "--plane", "0,1,0,2", "--kerf", "1"}};
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

TEST_F(CutVerb, AFolderThatCannotBeMadeIsAStorageError) {
  std::ofstream(folder_ / "made") << "a file where the folder should be";
  EXPECT_THROW(cut({"--plane", "1,0,0,2", "--kerf", "0.5"}), database::DatabaseError);
  EXPECT_TRUE(fs::is_regular_file(folder_ / "made"));
}

TEST_F(CutVerb, APieceThatCannotBePutInItsPlaceLeavesNoOther) {
  fs::create_directories(out_folder() / "piece-2.ply" / "occupied");
  EXPECT_THROW(cut({"--plane", "1,0,0,2", "--kerf", "0.5"}), database::DatabaseError);
  EXPECT_FALSE(fs::exists(out_folder() / "piece-2.ply.new"));
  EXPECT_FALSE(fs::exists(out_folder() / "piece-1.ply"));
}

}  // namespace
}  // namespace hallux::tests
