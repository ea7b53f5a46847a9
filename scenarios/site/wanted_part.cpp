#include "scenarios/site/wanted_part.h"

#include <algorithm>

namespace hallux::scenarios {

namespace {

using simulator::Bvh;
using simulator::PieceBody;

/// The faces that a step's cuts left, and the fragment that they are in.
struct FacesAround {
  /// Empty where a cut was not begun.
  std::vector<SawnFace> faces;
  std::size_t fragment = 0;
};

FacesAround faces_around(const OperationStep& step, const Plan& plan, std::span<const HeldCut> held,
                         std::span<const FragmentInPieces> fragments) {
  FacesAround around;
  for (const std::string& name : cuts_around(step, plan)) {
    const std::size_t cut = index_of_cut(plan, name);
    if (cut >= held.size() || !held[cut].is_begun()) return {};
    const auto fragment = static_cast<std::size_t>(held[cut].fragment);
    if (fragment >= fragments.size()) return {};
    if (!around.faces.empty() && fragment != around.fragment) return {};
    around.fragment = fragment;
    const simulator::KerfSet& kerfs = fragments[fragment].kerfs.all();
    around.faces.push_back(
        sawn_face(held[cut], plan.cuts[cut], kerfs.plane(held[cut].kerf).thickness_mm));
  }
  return around;
}

/// A piece may be smaller than the grid, or reach further than its inside point.
bool is_of_it(const PieceBody& piece, std::span<const SawnFace> faces,
              std::span<const Vec3> places_mm) {
  return lies_beyond(faces, piece.inside_mm) ||
         std::any_of(places_mm.begin(), places_mm.end(),
                     [&](const Vec3& place_mm) { return piece.bvh->contains(place_mm); });
}

}  // namespace

bool takes_out(StepKind kind) noexcept {
  return kind == StepKind::Remove || kind == StepKind::Trim;
}

WantedPart wanted_part(const OperationStep& step, const Plan& plan, std::span<const HeldCut> held,
                       std::span<const FragmentInPieces> fragments) {
  WantedPart part;
  const auto [faces, number] = faces_around(step, plan, held, fragments);
  if (faces.empty()) return part;
  const FragmentInPieces& fragment = fragments[number];
  const std::vector<Vec3> places_mm =
      parted_places_mm(faces, fragment.whole, fragment.kerfs.all(), fragment.kerfs.numbers());
  std::vector<const Bvh*> off = fragment.taken_out;
  for (const PieceBody* piece : fragment.free) {
    if (!is_of_it(*piece, faces, places_mm)) continue;
    part.pieces.push_back(piece->id);
    off.push_back(piece->bvh.get());
  }
  part.is_off = are_mostly_in(off, places_mm);
  return part;
}

}  // namespace hallux::scenarios
