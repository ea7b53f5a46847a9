// How the two hands saw Akin: which planes, how much of each planned window is open, and what is
// left of the hinge. Asked of the kerfs' fields alone, so that it holds whatever is done with the
// pieces.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <thread>
#include <vector>

#include "simulator/base/units.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/cutting/slice/section.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::tests {
namespace {

using scenarios::PlannedCut;
using simulator::Bone;
using simulator::KerfSet;
using simulator::Recording;

constexpr std::size_t seeds = 20;
constexpr std::array<const char*, 2> hands{"expert", "novice"};
constexpr double sample_mm = 0.25;

struct CutMade {
  bool is_there = false;
  double angle_deg = 0.0;
  double bridge_mm = 0.0;   ///< of bone in the row in which it reaches furthest lateral
  double beyond_mm = 0.0;   ///< the furthest open point beyond that
  double open_share = 0.0;  ///< of the bone on the near side of where the hand meant to stop
};

struct Row {
  std::array<CutMade, 2> cuts;
  std::int32_t kerfs = 0;
  double duration_s = 0.0;
};

struct Patient {
  Patient() : akin(scenarios_test::format_1("akin")) {
    // Planes and strokes do not depend on the edges' length.
    akin.patient.edge_mm = 0.8;
    bone = make_patient_bones(akin).front();
    plan = plan_on(akin, bone);
  }

  scenarios::Scenario akin;
  Bone bone;
  scenarios::Plan plan;
};

KerfSet kerfs_of(const Patient& patient, const Recording& recording) {
  KerfSet kerfs(patient.akin.saw.blade, patient.bone.world_from_bone);
  std::size_t next = 0;
  for (const simulator::ToolSample& sample : recording.samples) {
    for (; next < recording.events.size() && recording.events[next].tick <= sample.tick; ++next) {
      const simulator::CutEvent& event = recording.events[next];
      if (event.kind == simulator::CutEventKind::PlaneFrozen) kerfs.freeze(event.pose);
    }
    kerfs.apply(sample);
  }
  return kerfs;
}

/// The kerf that is nearest in direction to the plan; of two alike the first.
std::int32_t kerf_of(const KerfSet& kerfs, const PlannedCut& cut, double& angle_deg) {
  std::int32_t best = -1;
  double best_cosine = -1.0;
  for (std::int32_t kerf = 0; kerf < kerfs.count(); ++kerf) {
    const Vec3 normal = transform_direction(kerfs.plane(kerf).bone_from_kerf, Vec3{0.0, 0.0, 1.0});
    const double cosine = std::abs(glm::dot(normal, cut.face.normal));
    if (cosine <= best_cosine) continue;
    best_cosine = cosine;
    best = kerf;
  }
  angle_deg = degree_from_radian(std::acos(std::min(1.0, best_cosine)));
  return best;
}

/// Walks the kerf's plane lateral from its medial side, in the row of the bone's most lateral
/// point.
void measure_bridge(const simulator::Section& section, const simulator::KerfField& field,
                    CutMade& made) {
  Vec2 far{-1000.0, 0.0};
  for (const simulator::Contour& contour : section.regions.at(0).contours) {
    for (const Vec2& point : contour) {
      if (point.x > far.x) far = point;
    }
  }
  constexpr double step_mm = 0.01;
  while (made.bridge_mm < 10.0 && !field.is_open(Vec2{far.x - made.bridge_mm, far.y})) {
    made.bridge_mm += step_mm;
  }
  for (double x_mm = far.x + 15.0; x_mm > far.x && made.beyond_mm <= 0.0; x_mm -= 0.05) {
    for (double y_mm = -12.0; y_mm < 12.0; y_mm += 0.5) {
      if (field.is_open(Vec2{x_mm, far.y + y_mm})) made.beyond_mm = x_mm - far.x;
    }
  }
}

CutMade cut_made(const Patient& patient, const KerfSet& kerfs, const scenarios::AimedCut& aimed,
                 const PlannedCut& planned, const simulator::CutSolid& solid,
                 const simulator::Bvh& bvh) {
  CutMade made;
  const std::int32_t kerf = kerf_of(kerfs, planned, made.angle_deg);
  if (kerf < 0) return made;
  made.is_there = true;
  const simulator::KerfPlane& plane = kerfs.plane(kerf);
  const simulator::KerfField& field = kerfs.field(kerf);
  measure_bridge(slice_section(solid, bvh, plane), field, made);
  const simulator::Bvh outer(patient.bone.outer);
  std::size_t open = 0, wanted = 0;
  const double stop_mm = aimed.stop_mm.value() - 0.5;
  for (double x_mm = aimed.region.min_mm.x; x_mm < stop_mm; x_mm += sample_mm) {
    for (double y_mm = aimed.region.min_mm.y; y_mm < aimed.region.max_mm.y; y_mm += sample_mm) {
      const Vec3 point = transform_point(aimed.plane.bone_from_kerf, Vec3{x_mm, y_mm, 0.0});
      if (!outer.contains(point)) continue;
      const Vec3 local = transform_point(kerfs.kerf_from_bone(kerf), point);
      ++wanted;
      open += field.is_open(Vec2{local.x, local.y}) ? 1U : 0U;
    }
  }
  made.open_share = static_cast<double>(open) / static_cast<double>(wanted);
  return made;
}

Row row_of(const Patient& patient, const char* name, std::uint64_t seed) {
  scenarios::FeelingHand hand(patient.akin, patient.bone, patient.plan, scenarios::hand_skill(name),
                              seed);
  const Recording recording = run_hand(patient.akin, patient.bone, patient.plan, hand).recording;
  const KerfSet kerfs = kerfs_of(patient, recording);
  const simulator::CutSolid solid = simulator::uncut_solid(solid_of(patient.bone));
  const simulator::Bvh bvh(solid.mesh);
  Row row;
  row.kerfs = kerfs.count();
  row.duration_s = static_cast<double>(recording.samples.size()) / 1000.0;
  for (std::size_t i = 0; i < 2; ++i) {
    row.cuts[i] = cut_made(patient, kerfs, hand.cuts().at(i), patient.plan.cuts.at(i), solid, bvh);
  }
  return row;
}

using Rows = std::array<Row, seeds>;

/// Each thread takes the next attempt that nobody has taken.
std::array<Rows, hands.size()> run_all(const Patient& patient) {
  std::array<Rows, hands.size()> rows;
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < hands.size() * seeds; i = next++) {
      rows[i / seeds][i % seeds] = row_of(patient, hands[i / seeds], i % seeds + 1);
    }
  };
  std::vector<std::jthread> workers;
  for (std::size_t i = 0; i < 2; ++i) workers.emplace_back(work);
  workers.clear();
  return rows;
}

void print(const char* hand, const Rows& rows) {
  std::printf(
      "hand   seed kerfs   s | angle  bridge beyond open%% | angle  bridge beyond open%%\n");
  for (std::size_t i = 0; i < seeds; ++i) {
    std::printf("%-7s %3zu %3d %5.1f", hand, i + 1, rows[i].kerfs, rows[i].duration_s);
    for (const CutMade& cut : rows[i].cuts) {
      std::printf(" | %5.2f %6.2f %6.2f %6.2f", cut.angle_deg, cut.bridge_mm, cut.beyond_mm,
                  100.0 * cut.open_share);
    }
    std::printf("\n");
  }
}

double bridge_mm(const Row& row) { return std::min(row.cuts[0].bridge_mm, row.cuts[1].bridge_mm); }

// One test, because each test runs in a process of its own and the attempts take a while.
TEST(AkinStrokes, OfAnExpertLeaveAHingeThatBendsAndOfANoviceOftenNone) {
  const Patient patient;
  const auto rows = run_all(patient);
  for (std::size_t hand = 0; hand < hands.size(); ++hand) print(hands[hand], rows[hand]);
  const auto& [expert, novice] = rows;
  const auto is_in_band = [&](const Row& row) {
    const scenarios::ReferenceHinge& hinge = patient.akin.hinges.at(0);
    return bridge_mm(row) >= hinge.target_low_mm && bridge_mm(row) <= hinge.target_high_mm;
  };
  EXPECT_GE(std::count_if(expert.begin(), expert.end(), is_in_band), 13);
  const auto lost = std::count_if(novice.begin(), novice.end(),
                                  [](const Row& row) { return bridge_mm(row) <= 0.0; });
  EXPECT_GE(lost, 4);
  EXPECT_LE(lost, 16);
  for (const Row& row : expert) {
    EXPECT_EQ(row.kerfs, 2);
    for (const CutMade& cut : row.cuts) EXPECT_GT(cut.open_share, 0.99);
  }
}

}  // namespace
}  // namespace hallux::tests
