// A piece is out where the bone that its cut parts off went with it. That bone is what lies beyond
// the face as it was sawn, not as it was planned: a wedge is thinner than a fair cut may be off. It
// is asked at the points of a grid: half is enough, so a corner that breaks off is no eminence, and
// an edge that stays is one still.
#include "assessment/measure_deed.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "assessment/rebuild/taken_out.h"
#include "scenarios/metric_names.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::OperationStep;
using scenarios::StepKind;
using simulator::Bvh;
using simulator::CutEventKind;

constexpr double grid_mm = 0.5;

/// A face that was sawn, and the part of its plane in which it lies: further off the plane may meet
/// bone that has nothing to do with it.
struct SawnFace {
  FacePlane plane;
  RigidTransform kerf_from_bone;
  /// Of the regions of the section that the blade touched, in the kerf's plane.
  Vec2 low_mm{0.0, 0.0}, high_mm{0.0, 0.0};
};

SawnFace sawn_face(const CutFace& face, const RebuiltBone& rebuilt) {
  SawnFace made{face.plane, rebuilt.fields.kerf_from_bone(face.kerf)};
  const RebuiltKerf& kerf = rebuilt.kerfs[static_cast<std::size_t>(face.kerf)];
  bool is_first = true;
  for (std::size_t index = 0; index < kerf.section.regions.size(); ++index) {
    if (kerf.is_touched[index] == 0) continue;
    const simulator::SectionRegion& region = kerf.section.regions[index];
    made.low_mm = is_first ? region.min_mm : glm::min(made.low_mm, region.min_mm);
    made.high_mm = is_first ? region.max_mm : glm::max(made.high_mm, region.max_mm);
    is_first = false;
  }
  return made;
}

/// The faces beyond which a step's piece lies, their normals towards it; empty where a cut was not
/// made.
std::vector<SawnFace> faces_around(const OperationStep& step, const DeedEvidence& evidence) {
  std::vector<std::string> cuts{step.cut};
  if (const scenarios::PlannedHinge* hinge = find_hinge(evidence.plan, step.hinge))
    cuts = {hinge->first_cut, hinge->second_cut};
  std::vector<SawnFace> around;
  for (const std::string& cut : cuts) {
    const std::vector<CutFace>& faces = evidence.faces[index_of_cut(evidence.plan, cut)];
    if (faces.empty() || faces.front().samples_in_bone_mm.empty()) return {};
    around.push_back(sawn_face(faces.front(), evidence.rebuilt));
  }
  return around;
}

bool lies_beyond(const std::vector<SawnFace>& faces, const Vec3& point_mm) {
  return std::all_of(faces.begin(), faces.end(), [&](const SawnFace& face) {
    const Vec3 foot_mm = transform_point(face.kerf_from_bone, point_mm);
    return signed_distance_mm(face.plane, point_mm) > 0.0 && foot_mm.x >= face.low_mm.x &&
           foot_mm.x <= face.high_mm.x && foot_mm.y >= face.low_mm.y && foot_mm.y <= face.high_mm.y;
  });
}

struct Box {
  Vec3 low_mm{0.0, 0.0, 0.0}, high_mm{0.0, 0.0, 0.0};
};

Box box_of(const simulator::IndexedMesh& mesh) {
  Box box{mesh.points_mm.front(), mesh.points_mm.front()};
  for (const Vec3& point : mesh.points_mm) {
    box.low_mm = glm::min(box.low_mm, point);
    box.high_mm = glm::max(box.high_mm, point);
  }
  return box;
}

/// Points of a grid in the box.
template <typename Visit>
void visit_grid(const Box& box, Visit&& visit) {
  for (double x = box.low_mm.x; x <= box.high_mm.x; x += grid_mm) {
    for (double y = box.low_mm.y; y <= box.high_mm.y; y += grid_mm) {
      for (double z = box.low_mm.z; z <= box.high_mm.z; z += grid_mm) visit(Vec3(x, y, z));
    }
  }
}

bool is_in_any(const std::vector<TakenOut>& taken, const Vec3& point_mm) {
  return std::any_of(taken.begin(), taken.end(),
                     [&](const TakenOut& out) { return out.body->contains(point_mm); });
}

/// Whether most of the bone beyond the faces went with what was taken out; what the blade took is
/// not counted: of a thin wedge that is half.
bool has_gone(const std::vector<SawnFace>& faces, const DeedEvidence& evidence,
              const std::vector<TakenOut>& taken) {
  if (faces.empty() || taken.empty()) return false;
  const simulator::IndexedMesh whole = solid_of(evidence.bone);
  const Bvh body(whole);
  long asked = 0, gone = 0;
  visit_grid(box_of(whole), [&](const Vec3& point_mm) {
    if (!lies_beyond(faces, point_mm) || !body.contains(point_mm)) return;
    if (evidence.rebuilt.fields.is_open(point_mm)) return;
    ++asked;
    if (is_in_any(taken, point_mm)) ++gone;
  });
  return 2 * gone > asked;
}

std::int64_t last_tick_of(const simulator::Recording& recording) {
  return recording.samples.empty() ? 0 : recording.samples.back().tick;
}

Measurement deed(Metric metric, const OperationStep& step, bool is_done, std::int64_t tick) {
  Measurement made;
  made.metric = name_of(metric);
  made.cut = step.cut;
  made.hinge = step.hinge;
  made.value = is_done ? 1.0 : 0.0;
  made.start_us = time_us_from_tick(tick);
  made.end_us = time_us_from_tick(tick + 1);
  return made;
}

Measurement piece_out(const OperationStep& step, const DeedEvidence& evidence,
                      const std::vector<TakenOut>& taken) {
  const bool is_out = has_gone(faces_around(step, evidence), evidence, taken);
  const std::int64_t tick = is_out ? taken.back().tick : last_tick_of(evidence.recording);
  Measurement made = deed(Metric::PieceOut, step, is_out, tick);
  const scenarios::PlannedHinge* hinge = find_hinge(evidence.plan, step.hinge);
  const scenarios::PlannedCut* cut =
      find_cut(evidence.plan, hinge == nullptr ? step.cut : hinge->first_cut);
  made.place_in_bone_mm = cut->entry_point_in_bone_mm;
  return made;
}

Measurement wedge_closed(const OperationStep& step, const DeedEvidence& evidence) {
  std::int64_t tick = last_tick_of(evidence.recording);
  bool is_closed = false;
  for (const simulator::CutEvent& event : evidence.recording.events) {
    if (event.kind != CutEventKind::HingeClosed) continue;
    is_closed = true;
    tick = event.tick;
  }
  Measurement made = deed(Metric::WedgeClosed, step, is_closed, tick);
  made.place_in_bone_mm = find_hinge(evidence.plan, step.hinge)->bridge.line.point_in_bone_mm;
  return made;
}

}  // namespace

std::vector<Measurement> measure_deeds(const scenarios::Scenario& scenario,
                                       const DeedEvidence& evidence, const Progress& progress) {
  std::vector<Measurement> made;
  const std::vector<TakenOut> taken =
      pieces_taken_out(evidence.rebuilt, evidence.bone, evidence.recording, progress);
  for (const OperationStep& step : scenario.steps) {
    if (step.kind == StepKind::Remove) made.push_back(piece_out(step, evidence, taken));
    if (step.kind == StepKind::Close) made.push_back(wedge_closed(step, evidence));
  }
  return made;
}

}  // namespace hallux::assessment
