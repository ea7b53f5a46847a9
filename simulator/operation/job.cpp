#include "simulator/operation/job.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulator/base/check.h"
#include "simulator/cutting/section.h"

namespace hallux::simulator {

namespace {

/// Both triangles beside a cut share its plane, so a point is asked this far inside the skin.
constexpr double inward_mm = 1.0e-3;
constexpr std::size_t points_asked = 64;

/// Whether most of a piece lies in a body: of points just inside its skin, spread over its triangles.
bool lies_in(const CutSolid& piece, const Bvh& body) {
  const std::size_t count = piece.mesh.triangles.size();
  const std::size_t step = std::max<std::size_t>(1, count / points_asked);
  std::size_t asked = 0, inside = 0;
  for (std::size_t i = 0; i < count; i += step) {
    const Triangle& corners = piece.mesh.triangles[i];
    const Vec3& a = piece.mesh.points_mm[corners[0]];
    const Vec3& b = piece.mesh.points_mm[corners[1]];
    const Vec3& c = piece.mesh.points_mm[corners[2]];
    const Vec3 outward = glm::cross(b - a, c - a);
    const double length = std::sqrt(glm::dot(outward, outward));
    if (length == 0.0) continue;
    ++asked;
    const Vec3 point_mm = (a + b + c) / 3.0 - inward_mm / length * outward;
    if (body.contains(point_mm)) ++inside;
  }
  return 2 * inside > asked;
}

/// The mean of the section's areas on the kerf's two planes.
double section_area_mm2(const KerfContact& contact) {
  double doubled_mm2 = 0.0;
  for (const StripEdge& edge : contact.edges) {
    if (edge.level == 0) continue;
    const Vec2 a = place_mm(contact.axes, contact.points[edge.a].point_in_bone_mm);
    const Vec2 b = place_mm(contact.axes, contact.points[edge.b].point_in_bone_mm);
    doubled_mm2 -= edge.level * (a.x * b.y - a.y * b.x);
  }
  return 0.25 * doubled_mm2;
}

}  // namespace

OperationGeometry::OperationGeometry(const Bone& bone, const Blade& blade,
                                     std::optional<PlannedBridge> bridge)
    : kerfs_(blade, bone.world_from_bone), bridge_(bridge) {
  whole_.solid = uncut_solid(solid_of(bone));
  whole_.bvh = std::make_unique<const Bvh>(whole_.solid.mesh);
  solid_ = whole_.solid;
  pieces_.push_back({0, solid_, std::make_unique<const Bvh>(solid_.mesh)});
}

void OperationGeometry::follow(const CutEvent& event) {
  if (event.kind == CutEventKind::PlaneFrozen) CHECK(kerfs_.freeze(event.pose) == event.subject);
  if (event.kind == CutEventKind::PieceRemoved) take_out(event.subject);
}

void OperationGeometry::follow(const ToolSample& sample) {
  if (kerfs_.follow(sample).is_empty()) return;
  const auto first_changed = static_cast<std::size_t>(sample.kerf);
  if (stages_.size() > first_changed) stages_.resize(first_changed);
}

std::unique_ptr<const JobResult> OperationGeometry::run(const JobRequest& request) {
  auto result = std::make_unique<JobResult>();
  result->request = request;
  if (request.kind == JobKind::Hinge) {
    run_hinge(*result);
    return result;
  }
  CHECK(request.kerf >= 0 && request.kerf < kerfs_.count());
  if (request.kind == JobKind::Contact) {
    run_contact(*result);
  } else {
    run_pieces(*result);
  }
  return result;
}

const OperationGeometry::Stage& OperationGeometry::stage_before(std::int32_t kerf) {
  while (stages_.size() < static_cast<std::size_t>(kerf)) {
    const auto next = static_cast<std::int32_t>(stages_.size());
    const Stage& before = stages_.empty() ? whole_ : stages_.back();
    const KerfField& field = kerfs_.field(next);
    KerfCut cut = cut_kerf(before.solid, *before.bvh, kerfs_.plane(next), next, field.grid(),
                           outline_of(field));
    Stage stage;
    stage.solid = std::move(cut.solid);
    stage.bvh = std::make_unique<const Bvh>(stage.solid.mesh);
    stage.removed_mm3 = cut.removed_mm3;
    stage.takes_section = cut.takes_section;
    stage.nudges = cut.nudges;
    stages_.push_back(std::move(stage));
  }
  return kerf == 0 ? whole_ : stages_[static_cast<std::size_t>(kerf) - 1];
}

void OperationGeometry::run_contact(JobResult& result) {
  const std::int32_t kerf = result.request.kerf;
  const Stage& stage = stage_before(kerf);
  result.section_mm2 = section_area_mm2(
      slice_contact(stage.solid, *stage.bvh, kerfs_.plane(kerf), kerf, kerfs_.field(kerf).grid()));
}

void OperationGeometry::run_pieces(JobResult& result) {
  const Stage& last = stage_before(kerfs_.count());
  for (std::size_t kerf = 0; kerf < stages_.size(); ++kerf) {
    result.removed_mm3 += stages_[kerf].removed_mm3;
    result.nudges += stages_[kerf].nudges;
    if (stages_[kerf].takes_section) result.completed.push_back(static_cast<std::int32_t>(kerf));
  }
  number_pieces(split_pieces(last.solid), result);
  for (const CutSolid& crumb : debris_) result.debris_mm3 += signed_volume_mm3(crumb.mesh);
  gather_solid();
}

bool OperationGeometry::was_taken_out(const CutSolid& solid) const {
  return std::any_of(taken_out_.begin(), taken_out_.end(),
                     [&](const auto& body) { return lies_in(solid, *body); });
}

/// The number of the piece that this one was cut from, if no larger part of that has taken it; else -1.
std::int32_t OperationGeometry::inherited_id(const CutSolid& solid,
                                             std::vector<std::int32_t>& taken) const {
  for (const KnownPiece& piece : pieces_) {
    if (std::find(taken.begin(), taken.end(), piece.id) != taken.end()) continue;
    if (!lies_in(solid, *piece.bvh)) continue;
    taken.push_back(piece.id);
    return piece.id;
  }
  return -1;
}

void OperationGeometry::number_pieces(std::vector<CutSolid> solids, JobResult& result) {
  std::vector<KnownPiece> numbered;
  std::vector<std::int32_t> taken;
  debris_.clear();
  for (CutSolid& solid : solids) {
    if (was_taken_out(solid)) continue;
    const double volume_mm3 = signed_volume_mm3(solid.mesh);
    if (volume_mm3 < debris_limit_mm3) {
      debris_.push_back(std::move(solid));
      continue;
    }
    const std::int32_t inherited = inherited_id(solid, taken);
    const bool is_new = inherited < 0;
    const std::int32_t id = is_new ? next_piece_++ : inherited;
    result.pieces.push_back(
        {id, is_new, volume_mm3, solid, std::make_unique<const Bvh>(solid.mesh)});
    auto bvh = std::make_unique<const Bvh>(solid.mesh);
    numbered.push_back({id, std::move(solid), std::move(bvh)});
  }
  pieces_ = std::move(numbered);
}

void OperationGeometry::take_out(std::int32_t piece) {
  const auto found = std::find_if(pieces_.begin(), pieces_.end(),
                                  [&](const KnownPiece& known) { return known.id == piece; });
  if (found == pieces_.end()) return;
  taken_out_.push_back(std::move(found->bvh));
  pieces_.erase(found);
  gather_solid();
}

void OperationGeometry::gather_solid() {
  solid_ = {};
  const auto add = [this](const CutSolid& solid) {
    append_mesh(solid_.mesh, solid.mesh);
    solid_.origins.insert(solid_.origins.end(), solid.origins.begin(), solid.origins.end());
  };
  for (const KnownPiece& known : pieces_) add(known.solid);
  for (const CutSolid& crumb : debris_) add(crumb);
}

std::optional<CutSolid> OperationGeometry::solid_without(std::int32_t kerf) const {
  CutSolid solid = whole_.solid;
  for (std::int32_t other = 0; other < kerfs_.count(); ++other) {
    const RegionOutline outline = outline_of(kerfs_.field(other));
    if (other == kerf || outline.corners_mm.empty()) continue;
    const Bvh bvh(solid.mesh);
    solid =
        cut_kerf(solid, bvh, kerfs_.plane(other), other, kerfs_.field(other).grid(), outline).solid;
  }
  if (taken_out_.empty()) return solid;
  std::vector<bool> is_found(taken_out_.size(), false);
  CutSolid left;
  for (const CutSolid& piece : split_pieces(solid)) {
    const auto body =
        std::find_if(taken_out_.begin(), taken_out_.end(),
                     [&](const auto& candidate) { return lies_in(piece, *candidate); });
    if (body != taken_out_.end()) {
      is_found[static_cast<std::size_t>(body - taken_out_.begin())] = true;
      continue;
    }
    append_mesh(left.mesh, piece.mesh);
    left.origins.insert(left.origins.end(), piece.origins.begin(), piece.origins.end());
  }
  if (std::find(is_found.begin(), is_found.end(), false) != is_found.end()) return std::nullopt;
  return left;
}

/// The gaps that opened kerfs leave at the planned bridge, each in the bone as if it were the only kerf.
std::vector<HingeGap> OperationGeometry::gaps_of_kerfs(std::vector<std::int32_t>& kerfs) {
  std::vector<HingeGap> gaps;
  for (std::int32_t kerf = 0; kerf < kerfs_.count(); ++kerf) {
    const Section section = slice_section(whole_.solid, *whole_.bvh, kerfs_.plane(kerf));
    const std::optional<HingeGap> gap =
        measure_hinge_gap(section, outline_of(kerfs_.field(kerf)), bridge_->line);
    if (!gap || !gap->is_opened) continue;
    kerfs.push_back(kerf);
    gaps.push_back(*gap);
  }
  return gaps;
}

/// Between the two kerfs that leave least at the bridge.
void OperationGeometry::run_hinge(JobResult& result) {
  result.hinge.outcome = HingeOutcome::FacesMissing;
  if (!bridge_) return;
  std::vector<std::int32_t> kerfs;
  const std::vector<HingeGap> gaps = gaps_of_kerfs(kerfs);
  if (gaps.size() < 2) return;
  std::vector<std::size_t> order(gaps.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(gaps[a].thickness_mm, a) < std::pair(gaps[b].thickness_mm, b);
  });
  HingeRequest request;
  request.first = kerfs_.plane(kerfs[order[0]]);
  request.second = kerfs_.plane(kerfs[order[1]]);
  request.first_gap = gaps[order[0]];
  request.second_gap = gaps[order[1]];
  request.line = bridge_->line;
  request.toward_moved = bridge_->toward_moved;
  request.breaks_below_mm = bridge_->breaks_below_mm;
  request.bends_up_to_mm = bridge_->bends_up_to_mm;
  const Bvh bvh(solid_.mesh);
  result.hinge = close_hinge(solid_, bvh, request);
}

}  // namespace hallux::simulator
