#include "scenarios/site/wanted_part.h"

#include <algorithm>

namespace hallux::scenarios {

namespace {

using simulator::Bvh;
using simulator::PieceBody;

/// Empty where a cut was not begun.
std::vector<SawnFace> faces_around(const OperationStep& step, const Plan& plan,
                                   std::span<const HeldCut> held, double kerf_mm) {
  std::vector<SawnFace> faces;
  for (const std::string& name : cuts_around(step, plan)) {
    const std::size_t cut = index_of_cut(plan, name);
    if (cut >= held.size() || !held[cut].is_begun()) return {};
    faces.push_back(sawn_face(held[cut], plan.cuts[cut], kerf_mm));
  }
  return faces;
}

/// A piece may be smaller than the grid, or reach further than its inside point.
bool is_of_it(const PieceBody& piece, std::span<const SawnFace> faces,
              std::span<const Vec3> places_mm) {
  return lies_beyond(faces, piece.inside_mm) ||
         std::any_of(places_mm.begin(), places_mm.end(),
                     [&](const Vec3& place_mm) { return piece.bvh->contains(place_mm); });
}

}  // namespace

WantedPart wanted_part(const OperationStep& step, const Plan& plan, std::span<const HeldCut> held,
                       const BoneInPieces& bone) {
  WantedPart part;
  const std::vector<SawnFace> faces = faces_around(step, plan, held, bone.kerfs.blade().kerf_mm);
  if (faces.empty()) return part;
  const std::vector<Vec3> places_mm = parted_places_mm(faces, bone.whole, bone.kerfs);
  std::vector<const Bvh*> off(bone.taken_out.begin(), bone.taken_out.end());
  for (const PieceBody* piece : bone.free) {
    if (!is_of_it(*piece, faces, places_mm)) continue;
    part.pieces.push_back(piece->id);
    off.push_back(piece->bvh.get());
  }
  part.is_off = are_mostly_in(off, places_mm);
  return part;
}

}  // namespace hallux::scenarios
