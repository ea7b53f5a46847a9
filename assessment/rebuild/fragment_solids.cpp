/// A piece is known by the point inside it that the events carry: no job is run again, so that a
/// recording without an input tape is rebuilt as well.
#include "assessment/rebuild/fragment_solids.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "assessment/rebuild/taken_out.h"
#include "simulator/bone/close_bridge.h"
#include "simulator/cutting/solid/opened_volume.h"
#include "simulator/cutting/solid/slab_volume.h"

namespace hallux::assessment {

namespace {

using simulator::Bvh;
using simulator::CutBone;
using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::CutSolid;
using simulator::Recording;
using simulator::WholeBone;

/// The share of a region's volume that is rounding: positions are kept to about 1e-9 of a bone.
constexpr double nothing_left = 1.0e-6;

/// How much of each region the outline takes. What rounding leaves of a region that was taken
/// wholly is nothing.
void measure_regions(RebuiltKerf& kerf, const CutSolid& solid) {
  const std::size_t count = kerf.section.regions.size();
  for (std::size_t region = 0; region < count; ++region) {
    std::vector<std::uint8_t> only(count, 0);
    only[region] = 1;
    const double whole_mm3 = slab_volume_mm3(solid, kerf.section, only);
    const double opened_mm3 = opened_volume_mm3(solid, kerf.section.regions[region].triangles,
                                                kerf.section.plane, kerf.outline);
    const double fraction = whole_mm3 > 0.0 ? opened_mm3 / whole_mm3 : 0.0;
    const bool is_whole = fraction > 1.0 - nothing_left;
    kerf.opened_fraction.push_back(is_whole ? 1.0 : std::max(fraction, 0.0));
    kerf.is_touched.push_back(fraction > nothing_left ? 1 : 0);
    kerf.is_removed.push_back(is_whole ? 1 : 0);
  }
}

Vec3 place_of(const CutEvent& event) { return transform_from(event.pose).translation_mm; }

/// The point inside a piece, as it was said last before this event.
std::optional<Vec3> place_of_piece(const Recording& recording, std::size_t event,
                                   std::int32_t piece) {
  for (std::size_t i = event; i-- > 0;) {
    const CutEvent& before = recording.events[i];
    if (before.kind == CutEventKind::PieceFreed && before.subject == piece) return place_of(before);
  }
  return std::nullopt;
}

/// Moves the solids that hold the point from one list to another.
void move_those_at(const Vec3& place_mm, std::vector<CutSolid>& from, std::vector<CutSolid>& to) {
  const auto held = std::stable_partition(from.begin(), from.end(), [&](const CutSolid& solid) {
    return !Bvh(solid.mesh).contains(place_mm);
  });
  std::move(held, from.end(), std::back_inserter(to));
  from.erase(held, from.end());
}

CutSolid gathered(const std::vector<CutSolid>& solids) {
  CutSolid all;
  for (const CutSolid& solid : solids) append_solid(all, solid);
  return all;
}

/// Which hinge has closed with that event; nothing where none has.
std::optional<std::size_t> closed_hinge(const Recording& recording, std::size_t event) {
  const std::int64_t tick = recording.events[event].tick;
  for (std::size_t i = event + 1; i < recording.events.size(); ++i) {
    const CutEvent& after = recording.events[i];
    if (after.tick != tick) return std::nullopt;
    if (after.kind == CutEventKind::HingeClosed)
      return static_cast<std::size_t>(std::max(0, after.subject));
  }
  return std::nullopt;
}

/// Whether a plane is frozen, a piece parted or a bore begun after that event: else a closed hinge
/// changes no solid.
bool goes_on_after(const Recording& recording, std::size_t event) {
  return std::any_of(recording.events.begin() + static_cast<std::ptrdiff_t>(event) + 1,
                     recording.events.end(), [](const CutEvent& after) {
                       return after.kind == CutEventKind::PlaneFrozen ||
                              after.kind == CutEventKind::FragmentParted ||
                              after.kind == CutEventKind::BoreBegun;
                     });
}

}  // namespace

FragmentSolids::FragmentSolids(RebuiltBone& rebuilt, const simulator::Bone& bone,
                               const ClosedHinges& hinges)
    : rebuilt_(rebuilt), hinges_(hinges) {
  add(simulator::uncut_solid(solid_of(bone)), 0);
  rebuilt_.input_mm3 = signed_volume_mm3(standing_[0].own->solid.mesh);
}

void FragmentSolids::add(CutSolid solid, std::int32_t piece) {
  standing_.push_back({nullptr, nullptr, {}, 0, piece, false});
  stand_again(standing_.back(), std::move(solid));
}

/// The fragment stands as this solid from now on, without kerfs.
void FragmentSolids::stand_again(Standing& standing, CutSolid solid) {
  standing.bone.reset();
  standing.kerfs.clear();
  standing.cut_count = 0;
  if (solid.mesh.triangles.empty()) return;
  standing.own = std::make_unique<const WholeBone>(std::move(solid));
  standing.bone = std::make_unique<CutBone>(*standing.own);
}

void FragmentSolids::follow(const Recording& recording, const std::function<void(double)>& done) {
  std::int32_t frozen = 0, cut_count = 0;
  const auto cut_one = [&] {
    done(static_cast<double>(cut_count++) / static_cast<double>(rebuilt_.fields.count()));
  };
  for (std::size_t i = 0; i < recording.events.size(); ++i) {
    const CutEvent& event = recording.events[i];
    if (event.kind == CutEventKind::PlaneFrozen && frozen < rebuilt_.fields.count()) {
      const auto fragment = static_cast<std::size_t>(rebuilt_.fields.fragment_of(frozen));
      if (fragment < standing_.size()) standing_[fragment].kerfs.push_back(frozen);
      ++frozen;
    }
    if (event.kind == CutEventKind::PieceRemoved) take_out(event, recording.engine);
    if (event.kind != CutEventKind::FragmentParted) continue;
    const auto parent = static_cast<std::size_t>(event.value);
    if (parent >= standing_.size()) continue;
    cut_kerfs(standing_[parent], cut_one);
    part(recording, i);
  }
  for (Standing& standing : standing_) cut_kerfs(standing, cut_one);
  keep_pieces();
}

void FragmentSolids::cut_kerfs(Standing& standing, const std::function<void()>& cut_one) {
  for (; standing.cut_count < standing.kerfs.size(); ++standing.cut_count) {
    cut_one();
    if (standing.bone != nullptr) cut(standing, standing.kerfs[standing.cut_count]);
  }
}

/// The kerf in the solid that the kerfs before it leave.
void FragmentSolids::cut(Standing& standing, std::int32_t kerf_number) {
  RebuiltKerf& kerf = rebuilt_.kerfs[static_cast<std::size_t>(kerf_number)];
  const auto place = static_cast<std::int32_t>(standing.cut_count);
  const simulator::KerfField& field = rebuilt_.fields.field(kerf_number);
  const simulator::KerfPlane& plane = rebuilt_.fields.plane(kerf_number);
  const simulator::SolidWithTree before = standing.bone->before(place);
  kerf.section = slice_section(before.solid, before.bvh, plane);
  kerf.outline = outline_of(field);
  measure_regions(kerf, before.solid);
  standing.bone->put_kerf(place, {kerf_number, plane, field.grid(), kerf.outline});
  kerf.removed_mm3 = standing.bone->cut(place).removed_mm3;
  rebuilt_.removed_mm3 += kerf.removed_mm3;
}

/// Where the piece is known by nothing, an empty fragment keeps the numbers of those that follow.
void FragmentSolids::part(const Recording& recording, std::size_t event) {
  const std::int32_t piece = recording.events[event].subject;
  const auto parent = static_cast<std::size_t>(recording.events[event].value);
  CutSolid parted;
  if (standing_[parent].bone == nullptr) {
    add(std::move(parted), piece);
    return;
  }
  if (const std::optional<std::size_t> hinge = closed_hinge(recording, event)) {
    const bool is_divided = hinges_.are_always_divided || goes_on_after(recording, event);
    if (*hinge < hinges_.bridges.size() && is_divided)
      parted = part_at(hinges_.bridges[*hinge], standing_[parent]);
  } else if (const auto place_mm = place_of_piece(recording, event, piece)) {
    parted = part_from(*place_mm, standing_[parent]);
  }
  add(std::move(parted), piece);
}

/// What turns at the hinge; the rest stands.
CutSolid FragmentSolids::part_at(const simulator::PlannedBridge& bridge, Standing& parent) {
  std::vector<CutSolid> left = split_pieces(parent.bone->after_all());
  take_gone_from(left);
  simulator::ClosedHinge closed = close_bridge(*parent.bone, gathered(left), bridge);
  if (closed.outcome != simulator::HingeOutcome::Closed) return {};
  stand_again(parent, std::move(closed.fixed));
  return std::move(closed.moved);
}

/// The piece that holds the point; the rest stands.
CutSolid FragmentSolids::part_from(const Vec3& place_mm, Standing& parent) {
  std::vector<CutSolid> left = split_pieces(parent.bone->after_all()), parted;
  take_gone_from(left);
  move_those_at(place_mm, left, parted);
  stand_again(parent, gathered(left));
  return gathered(parted);
}

void FragmentSolids::take_gone_from(std::vector<CutSolid>& solids) {
  for (const Vec3& place_mm : gone_places_mm_) move_those_at(place_mm, solids, gone_);
}

void FragmentSolids::take_out(const CutEvent& event, std::int32_t engine) {
  for (Standing& standing : standing_) {
    if (standing.piece == event.subject && event.subject != 0) standing.is_out = true;
  }
  if (engine >= first_engine_with_places) gone_places_mm_.push_back(place_of(event));
}

void FragmentSolids::keep(std::vector<CutSolid> solids, bool are_out) {
  simulator::SortedBodies sorted = sort_bodies(std::move(solids));
  std::move(sorted.bodies.begin(), sorted.bodies.end(), std::back_inserter(rebuilt_.pieces));
  rebuilt_.piece_volumes_mm3.insert(rebuilt_.piece_volumes_mm3.end(), sorted.volumes_mm3.begin(),
                                    sorted.volumes_mm3.end());
  rebuilt_.is_piece_out.resize(rebuilt_.pieces.size(), are_out);
  rebuilt_.debris_mm3 += sorted.debris_mm3;
  rebuilt_.debris_count += static_cast<std::int32_t>(sorted.crumbs.size());
}

/// The smallest piece that holds a place is the one that was taken out there.
void FragmentSolids::mark_pieces_out(std::size_t first) {
  for (const Vec3& place_mm : gone_places_mm_) {
    for (std::size_t piece = rebuilt_.pieces.size(); piece-- > first;) {
      if (!Bvh(rebuilt_.pieces[piece].mesh).contains(place_mm)) continue;
      rebuilt_.is_piece_out[piece] = true;
      break;
    }
  }
}

void FragmentSolids::keep_pieces() {
  for (const Standing& standing : standing_) {
    const std::size_t first = rebuilt_.pieces.size();
    if (standing.bone != nullptr) keep(split_pieces(standing.bone->after_all()), standing.is_out);
    mark_pieces_out(first);
    rebuilt_.fragments.push_back(
        {standing.piece, first, rebuilt_.pieces.size() - first, standing.is_out});
  }
  keep(std::move(gone_), true);
}

}  // namespace hallux::assessment
