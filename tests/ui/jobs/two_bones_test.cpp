/// An attempt at two bones from the patient to the export: sawn, parted, led and pinned, each in
/// the frame of its own bone, and told in that of the first.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "simulator/base/progress.h"
#include "simulator/jobs/recorded_jobs.h"
#include "simulator/mesh/bvh.h"
#include "simulator/mesh/read_mesh.h"
#include "tests/database/some_database.h"
#include "ui/jobs/attempt_jobs.h"
#include "ui/jobs/exchange_jobs.h"
#include "ui/jobs/left_behind_json.h"

namespace hallux::ui {
namespace {

using assessment::Measurement;
using nlohmann::json;

const StageProgress untold = [](const std::string&) { return Progress(); };

/// The perfect hand's.
class TwoBones : public testing::Test {
 protected:
  static void SetUpTestSuite() { made = new Made; }
  static void TearDownTestSuite() {
    delete made;
    made = nullptr;
  }

  struct Made {
    Made() {
      ScriptedAttempt attempt;
      attempt.scenario = scenarios::read_scenario(HALLUX_TWO_BONES);
      attempt.hand = "perfect";
      attempt.asks_what_is_left = true;
      outcome = run_scripted_attempt(database, attempt, untold);
      database::HouseDesk desk(database);
      material = load_attempt(database, desk, outcome.attempt);
    }

    database::TemporaryDirectory temporary;
    database::Database database = database::Database::open(temporary.data());
    AttemptOutcome outcome;
    AttemptMaterial material;
  };

  static const json& named(const json& list, const std::string& name) {
    return *std::ranges::find_if(list, [&](const json& each) { return each.at("name") == name; });
  }
  static double value_of(const std::vector<Measurement>& all, const std::string& metric,
                         const std::string& subject) {
    const auto found = std::ranges::find_if(all, [&](const Measurement& each) {
      return each.metric == metric && each.cut + each.fragment + each.implant == subject;
    });
    return found == all.end() || !found->is_measured() ? NAN : found->value;
  }

  static Made* made;
};

TwoBones::Made* TwoBones::made = nullptr;

TEST_F(TwoBones, AreStoredAsOnePatient) {
  const AttemptMaterial& material = made->material;
  ASSERT_EQ(material.bones.size(), 2U);
  EXPECT_EQ(material.bones[0].name, "first_metatarsal");
  EXPECT_EQ(material.bones[1].name, "first_proximal_phalanx");
  EXPECT_EQ(digest_of(encode_patient(material.bones)), material.header.begun.bone);
}

TEST_F(TwoBones, AreMeasuredEachInItsOwnFrame) {
  const std::vector<Measurement> all = score_attempt(made->material, untold).measurements;
  for (const char* cut : {"neck", "toe"}) {
    EXPECT_LT(value_of(all, "angle_deg", cut), 0.1) << cut;
    EXPECT_LT(value_of(all, "location_mm", cut), 0.1) << cut;
  }
  EXPECT_NEAR(value_of(all, "shift_mm", "toe_end"), 3.0, 0.2);
  EXPECT_LT(value_of(all, "shift_error_mm", "toe_end"), 0.6) << "a kerf that was closed";
  EXPECT_LT(value_of(all, "direction_deg", "pin"), 0.1);
  EXPECT_EQ(value_of(all, "piece_out", "neck"), 1.0);
  EXPECT_EQ(value_of(all, "wrong_bones_count", ""), 0.0);
  EXPECT_EQ(made->outcome.card.score_milli, 100000);
}

/// The same operation, planned on the metatarsal alone: the toe is a bone that it has no business
/// with.
scenarios::Scenario on_the_metatarsal_alone() {
  std::ifstream file(HALLUX_TWO_BONES);
  json text = json::parse(file);
  for (const char* of_toe : {"fragments", "shifts", "wires", "directions"}) text.erase(of_toe);
  text["danger_zones"] = json::array();
  text["cuts"].erase(1);
  text["steps"].erase(text["steps"].begin() + 3, text["steps"].begin() + 6);
  text["steps"][3]["after"] = {"take_head"};
  json& items = text["rubric"]["items"];
  items = {items[0], items[7]};
  items[0]["weight"] = 60;
  items[1].update({{"metric", "wrong_bones_count"}, {"weight", 40}, {"zero", 1}});
  items[1].erase("zone");
  json gate = text["rubric"]["gates"][1];
  gate.update({{"name", "wrong_bone"}, {"metric", "wrong_bones_count"}, {"limit", 0}, {"cap", 0}});
  gate.erase("at_least");
  text["rubric"]["gates"].push_back(gate);
  return scenarios::parse_scenario(text.dump(), "two_bones");
}

TEST_F(TwoBones, TellACutOnABoneThatIsNotOperatedOn) {
  AttemptMaterial material = made->material;
  material.scenario = on_the_metatarsal_alone();
  const assessment::Examination examination = score_attempt(material, untold);
  EXPECT_EQ(value_of(examination.measurements, "wrong_bones_count", ""), 1.0);
  EXPECT_EQ(examination.card.score_milli, 0);
  const auto gate =
      std::ranges::find(examination.card.gates, "wrong_bone", &database::GateResult::name);
  ASSERT_NE(gate, examination.card.gates.end());
  EXPECT_TRUE(gate->is_triggered);
}

TEST_F(TwoBones, AreReplayedToTheBit) {
  const auto result = replay_attempt(made->material, untold);
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->is_identical);
}

TEST_F(TwoBones, TellWhichPieceWasGripped) {
  const simulator::Recording& recording = made->material.recording;
  const auto parted = std::ranges::find(recording.events, simulator::CutEventKind::FragmentParted,
                                        &simulator::CutEvent::kind);
  ASSERT_NE(parted, recording.events.end());
  const auto jobs = recorded_jobs(recording, made->material.bones.size());
  const auto grip = std::ranges::find_if(jobs, [](const simulator::RecordedJob& job) {
    return job.request.kind == simulator::JobKind::Grip;
  });
  ASSERT_NE(grip, jobs.end());
  EXPECT_EQ(grip->request.subject, parted->subject);
}

TEST_F(TwoBones, LeaveBodiesAndMetalInBoth) {
  const json bodies = fragments_json(made->outcome.left.value());
  EXPECT_EQ(named(bodies, "first_metatarsal").at("moved_mm"), 0.0);
  EXPECT_EQ(named(bodies, "first_proximal_phalanx").at("moved_mm"), 0.0);
  EXPECT_NEAR(named(bodies, "toe_end").at("moved_mm"), 3.0, 0.2);
  const json implants = implants_json(made->outcome.left.value());
  ASSERT_EQ(implants.size(), 1U);
  EXPECT_EQ(implants[0].at("engages"), json({"first_proximal_phalanx", "toe_end"}));
  const json balance = balance_json(made->outcome.left.value());
  EXPECT_NEAR(balance.at("error_mm3"), 0.0, 1.0e-6 * balance.at("input_mm3").get<double>());
}

/// The files of an export, as anybody reads them.
class ExportedFiles {
 public:
  explicit ExportedFiles(const AttemptMaterial& material) {
    const std::vector<std::byte> bones = encode_patient(material.bones);
    for (const database::DerivedFile& file :
         files_made_from({{},
                          {.name = material.scenario.name, .json = material.scenario.text},
                          bones,
                          material.recording}))
      files_[file.name] = file.bytes;
  }

  json json_of(const std::string& name) const { return json::parse(files_.at(name)); }
  simulator::IndexedMesh mesh_of(const std::string& name) const {
    const std::filesystem::path path = temporary_.path() / name;
    std::ofstream(path, std::ios::binary) << files_.at(name);
    return simulator::read_mesh(path);
  }
  /// As it lies.
  simulator::IndexedMesh posed(const json& fragment) const {
    simulator::IndexedMesh mesh = mesh_of(fragment.at("files").at(0));
    const json& pose = fragment.at("pose");
    for (Vec3& point : mesh.points_mm) {
      const Vec3 cut = point;
      for (int row = 0; row < 3; ++row) {
        const auto entry = [&](int column) {
          return pose.at(static_cast<std::size_t>(row))
              .at(static_cast<std::size_t>(column))
              .get<double>();
        };
        point[row] = entry(0) * cut.x + entry(1) * cut.y + entry(2) * cut.z + entry(3);
      }
    }
    return mesh;
  }

 private:
  database::TemporaryDirectory temporary_;
  std::map<std::string, std::string> files_;
};

TEST_F(TwoBones, AreExportedWithAPlanThatNamesThem) {
  const ExportedFiles exported(made->material);
  for (const auto& [bone, name] : {std::pair{0U, "bone.ply"}, {1U, "bone-2.ply"}}) {
    EXPECT_NEAR(simulator::signed_volume_mm3(exported.mesh_of(name)),
                simulator::signed_volume_mm3(solid_of(made->material.bones[bone])), 1.0e-6);
  }
  const json plan = exported.json_of("plan.json");
  EXPECT_EQ(plan.at("bone"), "first_metatarsal");
  EXPECT_EQ(plan.at("further_bones").at(0).at("name"), "first_proximal_phalanx");
  EXPECT_TRUE(plan.at("further_bones").at(0).at("landmarks").contains("ip_centre"));
  EXPECT_EQ(plan.at("cuts").at(1).at("bone"), "first_proximal_phalanx");
}

TEST_F(TwoBones, AreExportedWithTheLedPartTouchingTheRestOfItsBoneBesideTheOther) {
  const ExportedFiles exported(made->material);
  const json fragments = exported.json_of("fragments.json");
  const simulator::Bvh phalanx(exported.posed(named(fragments, "first_proximal_phalanx")));
  const simulator::Bvh metatarsal(exported.posed(named(fragments, "first_metatarsal")));
  double nearest_mm = INFINITY, deepest_mm = 0.0, to_metatarsal_mm = INFINITY;
  for (const Vec3& point_mm : exported.posed(named(fragments, "toe_end")).points_mm) {
    const double away_mm = phalanx.signed_distance_mm(point_mm);
    nearest_mm = std::min(nearest_mm, std::abs(away_mm));
    deepest_mm = std::max(deepest_mm, -away_mm);
    to_metatarsal_mm = std::min(to_metatarsal_mm, metatarsal.signed_distance_mm(point_mm));
  }
  EXPECT_LT(nearest_mm, 0.05);
  EXPECT_LE(deepest_mm, 0.05);
  EXPECT_GT(to_metatarsal_mm, 10.0) << "the toe lies beyond the joint, as in the foot";
}

}  // namespace
}  // namespace hallux::ui
