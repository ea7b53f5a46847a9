#include "simulator/operation/job.h"

#include <algorithm>

#include "simulator/base/check.h"

namespace hallux::simulator {

OperationGeometry::OperationGeometry(const Bone& bone, const BladeSize& blade)
    : kerfs_(blade, bone.world_from_bone),
      solid_(uncut_solid(solid_of(bone))),
      bvh_(std::make_unique<const Bvh>(solid_.mesh)),
      sections_(static_cast<std::size_t>(kerf_limit)) {
  pieces_.push_back({0, solid_});
}

void OperationGeometry::follow(const CutEvent& event) {
  if (event.kind == CutEventKind::PlaneFrozen) CHECK(kerfs_.freeze(event.pose) == event.subject);
  if (event.kind == CutEventKind::PieceRemoved) take_out(event.subject);
}

void OperationGeometry::follow(const ToolSample& sample) { kerfs_.follow(sample); }

std::unique_ptr<const JobResult> OperationGeometry::run(const JobRequest& request) {
  CHECK(request.kerf >= 0 && request.kerf < kerfs_.count());
  auto result = std::make_unique<JobResult>();
  result->request = request;
  if (request.kind == JobKind::Contact) {
    run_contact(*result);
  } else {
    run_pieces(*result);
  }
  return result;
}

void OperationGeometry::run_contact(JobResult& result) {
  const std::int32_t kerf = result.request.kerf;
  KerfSection& known = sections_[static_cast<std::size_t>(kerf)];
  known.section = slice_section(solid_, *bvh_, kerfs_.plane(kerf));
  known.mask = mask_section(known.section, solid_, *bvh_, kerfs_.field(kerf).grid());
  result.section = known.section;
  result.nodes.resize(known.section.regions.size());
  const auto add = [&](std::int32_t node, std::int32_t region) {
    const auto index = static_cast<std::size_t>(region);
    if (known.mask.fits_grid[index]) result.nodes[index].push_back(node);
  };
  for (std::size_t node = 0; node < known.mask.region_of_node.size(); ++node) {
    const std::int16_t region = known.mask.region_of_node[node];
    if (region >= 0) add(static_cast<std::int32_t>(node), region);
  }
  for (const SharedNode& shared : known.mask.shared_nodes) add(shared.node, shared.region);
}

void OperationGeometry::run_pieces(JobResult& result) {
  const std::int32_t kerf = result.request.kerf;
  KerfSection& known = sections_[static_cast<std::size_t>(kerf)];
  // The solid may have changed since the contact: regions are found again on what is there now.
  const Section section = slice_section(solid_, *bvh_, kerfs_.plane(kerf));
  const SectionMask mask = mask_section(section, solid_, *bvh_, kerfs_.field(kerf).grid());
  const std::vector<std::uint8_t> covered = covered_regions(mask, kerfs_.field(kerf));
  removed_mm3_ += slab_volume_mm3(solid_, section, covered);
  CutSolid cut = remove_slab(solid_, *bvh_, section, kerf, covered);
  number_pieces(split_pieces(cut), result);
  known.section = section;
  known.mask = mask;
  solid_ = std::move(cut);
  bvh_ = std::make_unique<const Bvh>(solid_.mesh);
  for (const CutSolid& crumb : debris_) result.debris_mm3 += signed_volume_mm3(crumb.mesh);
  result.removed_mm3 = removed_mm3_;
}

void OperationGeometry::number_pieces(std::vector<CutSolid> solids, JobResult& result) {
  std::vector<KnownPiece> numbered;
  debris_.clear();
  for (CutSolid& solid : solids) {
    const double volume_mm3 = signed_volume_mm3(solid.mesh);
    if (volume_mm3 < debris_limit_mm3) {
      debris_.push_back(std::move(solid));
      continue;
    }
    const auto same = std::find_if(pieces_.begin(), pieces_.end(), [&](const KnownPiece& piece) {
      return piece.solid.mesh == solid.mesh;
    });
    const bool is_largest = numbered.empty();
    const bool is_known = same != pieces_.end();
    const std::int32_t id = is_largest ? 0 : is_known ? same->id : next_piece_++;
    numbered.push_back({id, std::move(solid)});
    const CutSolid& kept = numbered.back().solid;
    result.pieces.push_back(
        {id, !is_largest && !is_known, volume_mm3, kept, std::make_unique<const Bvh>(kept.mesh)});
  }
  pieces_ = std::move(numbered);
}

void OperationGeometry::take_out(std::int32_t piece) {
  std::erase_if(pieces_, [&](const KnownPiece& known) { return known.id == piece; });
  CutSolid rest;
  const auto add = [&rest](const CutSolid& solid) {
    append_mesh(rest.mesh, solid.mesh);
    rest.origins.insert(rest.origins.end(), solid.origins.begin(), solid.origins.end());
  };
  for (const KnownPiece& known : pieces_) add(known.solid);
  for (const CutSolid& crumb : debris_) add(crumb);
  solid_ = std::move(rest);
  bvh_ = std::make_unique<const Bvh>(solid_.mesh);
}

}  // namespace hallux::simulator
