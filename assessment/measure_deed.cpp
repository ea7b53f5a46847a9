// A piece is out where the bone that its cut parts off went with it. That bone is what lies beyond
// the face as it was sawn, not as it was planned: a wedge is thinner than a fair cut may be off.
#include "assessment/measure_deed.h"

#include "assessment/make_measurement.h"
#include "assessment/process/sample_spans.h"
#include "assessment/rebuild/taken_out.h"
#include "scenarios/site/parted_bone.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::OperationStep;
using scenarios::SawnFace;
using scenarios::StepKind;
using simulator::Bvh;

SawnFace sawn_face(const CutFace& face, const RebuiltBone& rebuilt) {
  SawnFace made{{face.plane.normal, face.plane.offset_mm},
                rebuilt.fields.kerf_from_bone(face.kerf)};
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
std::vector<SawnFace> faces_around(const OperationStep& step, const Evidence& evidence) {
  std::vector<SawnFace> around;
  for (const std::string& cut : cuts_around(step, evidence.plan)) {
    const std::vector<CutFace>& faces = evidence.faces[index_of_cut(evidence.plan, cut)];
    if (faces.empty() || faces.front().samples_in_bone_mm.empty()) return {};
    around.push_back(sawn_face(faces.front(), evidence.rebuilt));
  }
  return around;
}

/// Whether most of that bone beyond the faces went with what was taken out.
bool has_gone(const std::vector<SawnFace>& faces, std::size_t bone, const Evidence& evidence,
              const std::vector<TakenOut>& taken) {
  if (faces.empty() || taken.empty()) return false;
  const simulator::CutSolid whole = uncut_solid(solid_of(evidence.bones[bone]));
  const Bvh tree(whole.mesh);
  std::vector<const Bvh*> bodies;
  bodies.reserve(taken.size());
  for (const TakenOut& out : taken) {
    if (out.bone == bone) bodies.push_back(out.body.get());
  }
  const std::vector<Vec3> places_mm = parted_places_mm(
      faces, {whole, tree}, evidence.rebuilt.fields, kerfs_of_bone(evidence.rebuilt, bone));
  return scenarios::are_mostly_in(bodies, places_mm);
}

/// Of a deed that is told by whether it was done.
Measurement deed(Metric metric, const OperationStep& step, bool is_done, std::int64_t tick,
                 const Vec3& place_in_bone_mm) {
  Measurement made = measured(metric, is_done ? 1.0 : 0.0, {tick, tick}, place_in_bone_mm);
  made.cut = step.cut;
  made.hinge = step.hinge;
  return made;
}

Measurement piece_out(const OperationStep& step, const Evidence& evidence,
                      const std::vector<TakenOut>& taken) {
  const scenarios::PlannedHinge* hinge = find_hinge(evidence.plan, step.hinge);
  const scenarios::PlannedCut* cut =
      find_cut(evidence.plan, hinge == nullptr ? step.cut : hinge->first_cut);
  const bool is_out = has_gone(faces_around(step, evidence), cut->bone, evidence, taken);
  std::int64_t tick = last_tick_of(evidence.recording);
  for (const TakenOut& out : taken) {
    if (is_out && out.bone == cut->bone) tick = out.tick;
  }
  return deed(Metric::PieceOut, step, is_out, tick, cut->entry_point_in_bone_mm);
}

Measurement wedge_closed(const OperationStep& step, const Evidence& evidence) {
  const simulator::CutEvent* const closing =
      closing_of(evidence.recording, index_of_hinge(evidence.plan, step.hinge));
  const std::int64_t tick = closing == nullptr ? last_tick_of(evidence.recording) : closing->tick;
  return deed(Metric::WedgeClosed, step, closing != nullptr, tick,
              find_hinge(evidence.plan, step.hinge)->bridge.line.point_in_bone_mm);
}

}  // namespace

std::vector<Measurement> measure_deeds(const Evidence& evidence, const Progress& progress) {
  std::vector<Measurement> made;
  const std::vector<TakenOut> taken =
      pieces_taken_out(evidence.rebuilt, evidence.bones, evidence.recorded(), progress);
  for (const OperationStep& step : evidence.scenario.steps) {
    if (step.kind == StepKind::Remove) made.push_back(piece_out(step, evidence, taken));
    if (step.kind == StepKind::Close) made.push_back(wedge_closed(step, evidence));
  }
  return made;
}

}  // namespace hallux::assessment
