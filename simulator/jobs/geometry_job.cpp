#include "simulator/jobs/geometry_job.h"

#include <utility>

#include "simulator/base/check.h"

namespace hallux::simulator {

namespace {

/// The mean of the section's areas on the kerf's two planes.
double section_area_mm2(const SlabSlice& contact) {
  double doubled_mm2 = 0.0;
  for (const StripEdge& edge : contact.edges) {
    if (edge.level == 0) continue;
    const Vec2 a = place_mm(contact.axes, contact.points[edge.a].point_in_bone_mm);
    const Vec2 b = place_mm(contact.axes, contact.points[edge.b].point_in_bone_mm);
    doubled_mm2 -= edge.level * (a.x * b.y - a.y * b.x);
  }
  return 0.25 * doubled_mm2;
}

FoundPiece found_from(const PieceBody& piece) {
  FoundPiece found{piece.id, piece.is_new, piece.volume_mm3, piece.inside_mm, nullptr};
  if (piece.id != 0) found.body = std::make_unique<const Bvh>(piece.solid.mesh);
  return found;
}

}  // namespace

AttemptGeometry::AttemptGeometry(const Bone& bone, const Blade& blade,
                                 std::optional<PlannedBridge> bridge)
    : kerfs_(blade, bone.world_from_bone), bridge_(bridge), bone_(solid_of(bone)) {}

AttemptGeometry::AttemptGeometry(const BoneToCut& bone, const Blade& blade,
                                 std::optional<PlannedBridge> bridge)
    : kerfs_(blade, bone.world_from_bone), bridge_(bridge), bone_(bone.whole) {}

void AttemptGeometry::apply(const CutEvent& event) {
  CHECK(kerfs_.apply(event));
  if (event.kind == CutEventKind::PlaneFrozen) has_risen_.push_back(1);
  if (event.kind == CutEventKind::PieceRemoved) bone_.take_out(event.subject);
}

void AttemptGeometry::apply(const ToolSample& sample) {
  for (const RisenKerf& risen : kerfs_.apply(sample)) {
    has_risen_[static_cast<std::size_t>(risen.kerf)] = 1;
  }
}

void AttemptGeometry::bring_up_to_date() {
  for (std::int32_t kerf = 0; kerf < kerfs_.count(); ++kerf) {
    if (std::exchange(has_risen_[static_cast<std::size_t>(kerf)], 0) == 0) continue;
    const KerfField& field = kerfs_.field(kerf);
    bone_.put_kerf(kerf, {kerf, kerfs_.plane(kerf), field.grid(), outline_of(field)});
  }
}

std::unique_ptr<JobResult> AttemptGeometry::run(const JobRequest& request) {
  auto result = std::make_unique<JobResult>();
  result->request = request;
  bring_up_to_date();
  if (request.kind == JobKind::Hinge) {
    result->hinge.outcome = HingeOutcome::FacesMissing;
    if (bridge_) result->hinge = close_bridge(bone_, *bridge_);
    return result;
  }
  CHECK(request.kerf >= 0 && request.kerf < kerfs_.count());
  if (request.kind == JobKind::Section) {
    run_section(*result);
  } else {
    run_pieces(*result);
  }
  return result;
}

void AttemptGeometry::run_section(JobResult& result) {
  const std::int32_t kerf = result.request.kerf;
  const SolidWithTree stands = bone_.before(kerf);
  result.section_mm2 = section_area_mm2(
      slice_slab(stands.solid, stands.bvh, kerfs_.plane(kerf), kerf, kerfs_.field(kerf).grid()));
}

void AttemptGeometry::run_pieces(JobResult& result) {
  for (std::int32_t kerf = 0; kerf < kerfs_.count(); ++kerf) {
    const KerfCut& cut = bone_.cut(kerf);
    result.removed_mm3 += cut.removed_mm3;
    result.nudges += cut.nudges;
    if (cut.takes_section) result.completed.push_back(kerf);
  }
  bone_.number_pieces();
  for (const PieceBody& piece : bone_.pieces().pieces()) result.pieces.push_back(found_from(piece));
  result.debris_mm3 = bone_.pieces().debris_mm3();
}

bool AttemptGeometry::is_only_kerf(std::int32_t kerf) const {
  for (std::int32_t other = 0; other < kerfs_.count(); ++other) {
    if (other != kerf && !outline_of(kerfs_.field(other)).corners_mm.empty()) return false;
  }
  return !bone_.pieces().has_taken_out();
}

std::optional<CutSolid> AttemptGeometry::solid_without(std::int32_t kerf) {
  bring_up_to_date();
  return bone_.pieces().without_taken_out(bone_.all_but(kerf));
}

}  // namespace hallux::simulator
