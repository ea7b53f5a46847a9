#include "simulator/jobs/geometry_job.h"

#include <algorithm>
#include <utility>

#include "simulator/base/check.h"
#include "simulator/bone/contact_points.h"

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

FoundPiece found_from(const PieceBody& piece, std::int32_t main) {
  FoundPiece found{piece.id, piece.is_new, piece.volume_mm3, piece.inside_mm, nullptr};
  if (piece.id != main) found.body = std::make_unique<const Bvh>(piece.solid.mesh);
  return found;
}

/// By which a piece meets others, and as many of all of those by which it is met.
constexpr std::size_t points_of_piece = 256;
constexpr std::int32_t no_piece = -1;

const PieceBody* find_piece(const NumberedPieces& pieces, std::int32_t id) noexcept {
  const auto& all = pieces.pieces();
  const auto found =
      std::find_if(all.begin(), all.end(), [id](const PieceBody& piece) { return piece.id == id; });
  return found == all.end() ? nullptr : &*found;
}

std::shared_ptr<const WholeBone> whole_of(CutSolid solid) {
  return std::make_shared<const WholeBone>(std::move(solid));
}

/// The tree keeps all of it.
std::shared_ptr<const Bvh> tree_of(const std::shared_ptr<const WholeBone>& whole) {
  return {whole, &whole->tree};
}

bool is_of(const std::shared_ptr<const WholeBone>& whole, const CutSolid& solid) {
  return whole != nullptr && whole->solid.mesh == solid.mesh &&
         whole->solid.sources == solid.sources;
}

FragmentPoses poses_of(std::span<const BoneToCut> bones) {
  std::vector<RigidTransform> world_from_bones;
  for (const BoneToCut& bone : bones) world_from_bones.push_back(bone.world_from_bone);
  return FragmentPoses(world_from_bones);
}

}  // namespace

AttemptGeometry::AttemptGeometry(const Bone& bone, const Tray& tray, const PlannedBridges& bridges)
    : kerfs_(tray, bone.world_from_bone), bridges_(bridges) {
  fragments_.push_back({nullptr, CutBone(solid_of(bone)), {}});
}

AttemptGeometry::AttemptGeometry(std::span<const BoneToCut> bones, const Tray& tray,
                                 const PlannedBridges& bridges)
    : kerfs_(tray, poses_of(bones)), bridges_(bridges) {
  for (const BoneToCut& bone : bones) {
    const auto number = static_cast<std::int32_t>(fragments_.size());
    fragments_.push_back(
        {nullptr, CutBone(bone.whole, NumberedPieces(bone.whole.solid, number)), {}});
  }
  next_piece_ = static_cast<std::int32_t>(fragments_.size());
}

void AttemptGeometry::apply(const CutEvent& event) {
  CHECK(kerfs_.apply(event));
  switch (event.kind) {
    case CutEventKind::PlaneFrozen:
      has_risen_.push_back(1);
      fragment_at(kerfs_.fragment_of(event.subject)).kerfs.push_back(event.subject);
      break;
    case CutEventKind::PieceRemoved:
      take_out(event.subject);
      break;
    case CutEventKind::FragmentParted:
      part(event.subject, static_cast<std::int32_t>(event.value));
      break;
    default:
      break;
  }
}

void AttemptGeometry::apply(const ToolSample& sample) {
  for (const RisenKerf& risen : kerfs_.apply(sample)) {
    has_risen_[static_cast<std::size_t>(risen.kerf)] = 1;
  }
}

/// A fragment's own piece goes with all of it.
void AttemptGeometry::take_out(std::int32_t piece) {
  const std::int32_t number = fragment_of_piece(piece);
  if (number < 0) return;
  FragmentSolid& fragment = fragment_at(number);
  if (fragment.bone.pieces().main() == piece) {
    fragment.is_out = true;
  } else {
    fragment.bone.take_out(piece);
  }
}

void AttemptGeometry::part(std::int32_t piece, std::int32_t parent) {
  if (piece == moved_piece_) {
    divide(parent, {whole_of(std::move(fixed_)), whole_of(std::move(moved_))}, piece);
    next_piece_ = std::max(next_piece_, piece + 1);
    moved_piece_ = -1;
    return;
  }
  const PieceBody* const found = find_piece(fragment_at(parent).bone.pieces(), piece);
  CHECK(found != nullptr);
  divide(parent, halves_of(*found, parent), piece);
  gripped_ = {};
}

/// What the kerfs opened is in the surfaces of both from now on.
void AttemptGeometry::divide(std::int32_t parent, Halves halves, std::int32_t piece) {
  FragmentSolid& divided = fragment_at(parent);
  const NumberedPieces before = std::move(divided.bone).release_pieces();
  const auto fragment_of = [&](std::shared_ptr<const WholeBone> own, std::int32_t main) {
    const WholeBone& whole = *own;
    return FragmentSolid{std::move(own), CutBone(whole, before.of_part(whole.solid, main)), {}};
  };
  FragmentSolid left = fragment_of(std::move(halves.rest), before.main());
  left.removed_before_mm3 = divided.removed_before_mm3 + divided.removed_mm3;
  FragmentSolid own = fragment_of(std::move(halves.parted), piece);
  divided = std::move(left);
  fragments_.push_back(std::move(own));
}

std::int32_t AttemptGeometry::place_of(std::int32_t kerf) const noexcept {
  const std::vector<std::int32_t>& kerfs = fragment_at(kerfs_.fragment_of(kerf)).kerfs;
  const auto found = std::find(kerfs.begin(), kerfs.end(), kerf);
  return found == kerfs.end() ? -1 : static_cast<std::int32_t>(found - kerfs.begin());
}

void AttemptGeometry::bring_up_to_date() {
  for (std::int32_t kerf = 0; kerf < kerfs_.count(); ++kerf) {
    if (std::exchange(has_risen_[static_cast<std::size_t>(kerf)], 0) == 0) continue;
    const std::int32_t place = place_of(kerf);
    if (place < 0) continue;
    const KerfField& field = kerfs_.field(kerf);
    fragment_at(kerfs_.fragment_of(kerf))
        .bone.put_kerf(place, {kerf, kerfs_.plane(kerf), field.grid(), outline_of(field)});
  }
}

std::unique_ptr<JobResult> AttemptGeometry::run(const JobRequest& request) {
  auto result = std::make_unique<JobResult>();
  result->request = request;
  bring_up_to_date();
  switch (request.kind) {
    case JobKind::Section:
      run_section(*result);
      break;
    case JobKind::Pieces:
      run_pieces(*result);
      break;
    case JobKind::Hinge:
      run_hinge(*result);
      break;
    case JobKind::Grip:
      run_grip(*result);
      break;
  }
  return result;
}

void AttemptGeometry::run_section(JobResult& result) {
  const std::int32_t kerf = result.request.subject;
  CHECK(kerf >= 0 && kerf < kerfs_.count());
  const std::int32_t place = place_of(kerf);
  if (place < 0) return;
  const SolidWithTree stands = fragment_at(kerfs_.fragment_of(kerf)).bone.before(place);
  result.section_mm2 = section_area_mm2(
      slice_slab(stands.solid, stands.bvh, kerfs_.plane(kerf), kerf, kerfs_.field(kerf).grid()));
}

void AttemptGeometry::run_pieces(JobResult& result) {
  CHECK(result.request.subject >= 0 && result.request.subject < kerfs_.count());
  result.fragment = kerfs_.fragment_of(result.request.subject);
  FragmentSolid& fragment = fragment_at(result.fragment);
  fragment.removed_mm3 = 0.0;
  for (std::size_t place = 0; place < fragment.kerfs.size(); ++place) {
    const KerfTally& cut = fragment.bone.cut(static_cast<std::int32_t>(place));
    fragment.removed_mm3 += cut.removed_mm3;
    result.nudges += cut.nudges;
    if (cut.takes_section) result.completed.push_back(fragment.kerfs[place]);
  }
  fragment.bone.number_pieces(next_piece_);
  const NumberedPieces& pieces = fragment.bone.pieces();
  for (const PieceBody& piece : pieces.pieces())
    result.pieces.push_back(found_from(piece, pieces.main()));
  for (const FragmentSolid& each : fragments_) {
    result.debris_mm3 += each.bone.pieces().debris_mm3();
    result.removed_mm3 += each.removed_before_mm3 + each.removed_mm3;
  }
}

/// In the first fragment of its bone in which two kerfs end at the bridge.
void AttemptGeometry::run_hinge(JobResult& result) {
  result.hinge.outcome = HingeOutcome::FacesMissing;
  const auto hinge = static_cast<std::size_t>(result.request.subject);
  if (hinge >= bridges_.size()) return;
  for (std::size_t i = 0; i < fragments_.size(); ++i) {
    const std::int32_t bone = kerfs_.fragments()[static_cast<std::int32_t>(i)].bone;
    if (fragments_[i].is_out || bone != bridges_[hinge].bone) continue;
    result.hinge = close_bridge(fragments_[i].bone, bridges_[hinge]);
    result.divided.fragment = static_cast<std::int32_t>(i);
    if (result.hinge.outcome != HingeOutcome::FacesMissing) break;
  }
  if (result.hinge.outcome != HingeOutcome::Closed) return;
  fixed_ = result.hinge.fixed;
  moved_ = result.hinge.moved;
  moved_piece_ = next_piece_;
  result.divided.moved_piece = moved_piece_;
  result.divided.fixed_surface = std::make_unique<const Bvh>(fixed_.mesh);
  result.divided.moved_surface = std::make_unique<const Bvh>(moved_.mesh);
  result.divided.moved_mm3 = signed_volume_mm3(moved_.mesh);
  result.divided.inside_moved_mm = point_inside(moved_, *result.divided.moved_surface);
}

void AttemptGeometry::run_grip(JobResult& result) {
  GrippedPiece& gripped = result.gripped;
  const std::int32_t fragment = fragment_of_piece(result.request.subject);
  if (fragment < 0) return;
  const PieceBody& piece = *find_piece(fragment_at(fragment).bone.pieces(), result.request.subject);
  gripped.fragment = fragment;
  gripped.centroid_mm = centroid_of(piece.solid.mesh);
  const bool is_own = piece.id == fragment_at(fragment).bone.pieces().main();
  gripped_ = is_own ? Halves{} : halves_of(piece, fragment);
  gripped.surface = is_own ? surface_over(piece.solid, fragment) : tree_of(gripped_.parted);
  gripped.points_mm = contact_points(piece.solid, points_of_piece);
  gripped.met = met_by(piece.id, fragment);
  std::vector<const Bvh*> others;
  for (const MetFragment& met : gripped.met) others.push_back(met.surface.get());
  gripped.closing = out_of_facing_walls(piece.solid, others);
}

/// Every other piece: those of its own fragment lie where it was, those of others where they lie.
std::vector<MetFragment> AttemptGeometry::met_by(std::int32_t piece, std::int32_t fragment) const {
  std::vector<MetFragment> all;
  std::vector<CutSolid> solids;
  for (std::size_t i = 0; i < fragments_.size(); ++i) {
    if (fragments_[i].is_out) continue;
    const auto number = static_cast<std::int32_t>(i);
    CutSolid others =
        fragments_[i].bone.pieces().gathered_without(number == fragment ? piece : no_piece);
    if (others.mesh.triangles.empty()) continue;
    all.push_back({number, surface_over(others, number), {}});
    solids.push_back(std::move(others));
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].points_mm = contact_points(solids[i], points_of_piece / all.size());
  return all;
}

std::shared_ptr<const Bvh> AttemptGeometry::surface_over(const CutSolid& solid,
                                                         std::int32_t fragment) const {
  for (const auto& known : {fragment_at(fragment).own, gripped_.rest})
    if (is_of(known, solid)) return tree_of(known);
  return std::make_shared<const Bvh>(solid.mesh);
}

AttemptGeometry::Halves AttemptGeometry::halves_of(const PieceBody& piece,
                                                   std::int32_t fragment) const {
  CutSolid rest = fragment_at(fragment).bone.pieces().gathered_without(piece.id);
  return {is_of(gripped_.rest, rest) ? gripped_.rest : whole_of(std::move(rest)),
          is_of(gripped_.parted, piece.solid) ? gripped_.parted : whole_of(piece.solid)};
}

CutSolid AttemptGeometry::solid() const {
  CutSolid all;
  for (const FragmentSolid& fragment : fragments_) {
    if (!fragment.is_out) append_solid(all, fragment.bone.pieces().gathered());
  }
  return all;
}

std::int32_t AttemptGeometry::fragment_of_piece(std::int32_t piece) const noexcept {
  for (std::int32_t fragment = 0; fragment < fragment_count(); ++fragment) {
    const FragmentSolid& each = fragment_at(fragment);
    if (!each.is_out && find_piece(each.bone.pieces(), piece) != nullptr) return fragment;
  }
  return -1;
}

bool AttemptGeometry::is_only_kerf(std::int32_t kerf) const {
  const FragmentSolid& fragment = fragment_at(kerfs_.fragment_of(kerf));
  if (fragment.own != nullptr || fragment.bone.pieces().has_taken_out()) return false;
  return std::ranges::all_of(fragment.kerfs, [&](std::int32_t other) {
    return other == kerf || outline_of(kerfs_.field(other)).corners_mm.empty();
  });
}

std::optional<CutSolid> AttemptGeometry::solid_without(std::int32_t fragment, std::int32_t kerf) {
  bring_up_to_date();
  CutBone& bone = fragment_at(fragment).bone;
  return bone.pieces().without_taken_out(bone.all_but(kerf < 0 ? -1 : place_of(kerf)));
}

}  // namespace hallux::simulator
