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
#include "simulator/jobs/lying_bones.h"

namespace hallux::assessment {

namespace {

using simulator::Bvh;
using simulator::CutBone;
using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::CutSolid;
using simulator::Recording;
using simulator::ToolSample;
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

bool holds(const CutSolid& solid, const Vec3& place_mm) {
  return Bvh(solid.mesh).contains(place_mm);
}

/// Moves the solids that hold the point from one list to another.
void move_those_at(const Vec3& place_mm, std::vector<CutSolid>& from, std::vector<CutSolid>& to) {
  const auto held = std::stable_partition(
      from.begin(), from.end(), [&](const CutSolid& solid) { return !holds(solid, place_mm); });
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

/// Whether the saw runs afterwards in a kerf that was begun before.
bool goes_on_in_kerfs(const Recording& recording, std::size_t event) {
  const auto begun = std::count_if(
      recording.events.begin(), recording.events.begin() + static_cast<std::ptrdiff_t>(event),
      [](const CutEvent& before) { return before.kind == CutEventKind::PlaneFrozen; });
  const auto first =
      std::partition_point(recording.samples.begin(), recording.samples.end(),
                           [tick = recording.events[event].tick](const ToolSample& sample) {
                             return sample.tick < tick;
                           });
  return std::any_of(first, recording.samples.end(), [begun](const ToolSample& sample) {
    return sample.kerf >= 0 && sample.kerf < begun &&
           has(sample.status, simulator::ToolStatus::SawOn);
  });
}

/// Opens them by what was recorded before an event.
void open_until(simulator::KerfSet& kerfs, const Recording& recording, std::size_t event) {
  std::size_t next = 0;
  const auto apply_events_to = [&](std::int64_t tick) {
    for (; next < event && recording.events[next].tick <= tick; ++next)
      kerfs.apply(recording.events[next]);
  };
  const std::int64_t last_tick = recording.events[event].tick;
  for (const ToolSample& sample : recording.samples) {
    if (sample.tick >= last_tick) break;
    apply_events_to(sample.tick);
    kerfs.apply(sample);
  }
  apply_events_to(last_tick);
}

}  // namespace

FragmentSolids::FragmentSolids(RebuiltBone& rebuilt, const simulator::Bones& bones,
                               const ClosedHinges& hinges)
    : rebuilt_(rebuilt), hinges_(hinges), bones_(bones), gone_(bones.size()) {
  for (std::size_t i = 0; i < bones.size(); ++i) {
    add(simulator::uncut_solid(solid_of(bones[i])), static_cast<std::int32_t>(i), i);
    rebuilt_.inputs_mm3.push_back(signed_volume_mm3(standing_.back().whole.own->solid.mesh));
  }
}

void FragmentSolids::add(CutSolid solid, std::int32_t piece, std::size_t bone) {
  standing_.emplace_back();
  standing_.back().piece = piece;
  standing_.back().bone = bone;
  stand_again(standing_.back(), std::move(solid));
}

FragmentSolids::Sawn FragmentSolids::sawn_from(CutSolid solid) {
  if (solid.mesh.triangles.empty()) return {};
  Sawn sawn;
  sawn.own = std::make_unique<const WholeBone>(std::move(solid));
  sawn.bone = std::make_unique<CutBone>(*sawn.own);
  return sawn;
}

/// The fragment stands as this solid from now on, without kerfs.
void FragmentSolids::stand_again(Standing& standing, CutSolid solid) {
  for (Sawn* const sawn : {&standing.left, &standing.whole}) {
    // Before the solid that it borrows.
    sawn->bone.reset();
    sawn->own.reset();
  }
  standing.kerfs.clear();
  standing.taken.clear();
  standing.cut_count = standing.left_from = 0;
  standing.whole = sawn_from(std::move(solid));
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
    if (event.kind == CutEventKind::PieceRemoved) take_out(recording, i);
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
    if (standing.whole.bone == nullptr) continue;
    leave_taken_before(standing);
    cut(standing, standing.kerfs[standing.cut_count]);
  }
}

/// What was taken out before the next kerf was begun is in the way of none from now on.
void FragmentSolids::leave_taken_before(Standing& standing) {
  const auto later =
      std::find_if(standing.taken.begin(), standing.taken.end(),
                   [&](const TakenPiece& taken) { return taken.kerf_count > standing.cut_count; });
  if (later == standing.taken.begin()) return;
  std::vector<CutSolid> solids = split_pieces(standing.sawn().bone->after_all());
  std::vector<CutSolid> gone = taken_from(solids, {standing.taken.begin(), later});
  standing.taken.erase(standing.taken.begin(), later);
  if (gone.empty() || solids.empty()) return;
  let_go(std::move(gone), standing.bone);
  standing.left.bone.reset();
  standing.left = sawn_from(gathered(solids));
  standing.left_from = standing.cut_count;
}

/// The kerf in the solid that the kerfs before it leave.
void FragmentSolids::cut(Standing& standing, std::int32_t kerf_number) {
  RebuiltKerf& kerf = rebuilt_.kerfs[static_cast<std::size_t>(kerf_number)];
  CutBone& bone = *standing.sawn().bone;
  const auto place = static_cast<std::int32_t>(standing.cut_count - standing.left_from);
  const simulator::KerfField& field = rebuilt_.fields.field(kerf_number);
  const simulator::KerfPlane& plane = rebuilt_.fields.plane(kerf_number);
  const simulator::SolidWithTree before = bone.before(place);
  kerf.section = slice_section(before.solid, before.bvh, plane);
  kerf.outline = outline_of(field);
  measure_regions(kerf, before.solid);
  const simulator::OpenedKerf opened{kerf_number, plane, field.grid(), kerf.outline};
  if (&bone != standing.whole.bone.get())
    standing.whole.bone->put_kerf(static_cast<std::int32_t>(standing.cut_count), opened);
  bone.put_kerf(place, opened);
  kerf.removed_mm3 = bone.cut(place).removed_mm3;
  rebuilt_.removed_mm3 += kerf.removed_mm3;
}

/// Where the piece is known by nothing, an empty fragment keeps the numbers of those that follow.
void FragmentSolids::part(const Recording& recording, std::size_t event) {
  const std::int32_t piece = recording.events[event].subject;
  const auto parent = static_cast<std::size_t>(recording.events[event].value);
  const std::size_t bone = standing_[parent].bone;
  CutSolid parted;
  if (standing_[parent].whole.bone == nullptr) {
    add(std::move(parted), piece, bone);
    return;
  }
  if (const std::optional<std::size_t> hinge = closed_hinge(recording, event)) {
    const bool is_divided = hinges_.are_always_divided || goes_on_after(recording, event);
    if (*hinge < hinges_.bridges.size() && is_divided)
      parted = part_at(hinges_.bridges[*hinge], standing_[parent]);
  } else if (const auto place_mm = place_of_piece(recording, event, piece)) {
    parted = part_from(*place_mm, standing_[parent]);
  }
  add(std::move(parted), piece, bone);
}

/// What turns at the hinge; the rest stands.
CutSolid FragmentSolids::part_at(const simulator::PlannedBridge& bridge, Standing& parent) {
  std::vector<CutSolid> left = split_pieces(parent.sawn().bone->after_all());
  std::vector<CutSolid> gone = taken_from(left, parent.taken);
  simulator::ClosedHinge closed = close_bridge(*parent.whole.bone, gathered(left), bridge);
  if (closed.outcome != simulator::HingeOutcome::Closed) return {};
  let_go(std::move(gone), parent.bone);
  stand_again(parent, std::move(closed.fixed));
  return std::move(closed.moved);
}

/// The piece that holds the point; the rest stands.
CutSolid FragmentSolids::part_from(const Vec3& place_mm, Standing& parent) {
  std::vector<CutSolid> left = split_pieces(parent.sawn().bone->after_all()), parted;
  std::vector<CutSolid> gone = taken_from(left, parent.taken);
  let_go(std::move(gone), parent.bone);
  move_those_at(place_mm, left, parted);
  stand_again(parent, gathered(left));
  return gathered(parted);
}

bool FragmentSolids::is_of(const CutSolid& solid, const TakenPiece& taken) {
  return taken.body != nullptr ? lies_in(solid, *taken.body) : holds(solid, taken.inside_mm);
}

std::vector<CutSolid> FragmentSolids::taken_from(std::vector<CutSolid>& solids,
                                                 std::span<const TakenPiece> taken) {
  std::vector<CutSolid> gone;
  for (const TakenPiece& piece : taken) {
    // Largest first: the bone itself comes last, and mostly needs no look.
    for (std::size_t i = solids.size(); i-- > 0;) {
      if (!is_of(solids[i], piece)) continue;
      gone.push_back(std::move(solids[i]));
      solids.erase(solids.begin() + static_cast<std::ptrdiff_t>(i));
      if (piece.body == nullptr) break;
    }
  }
  return gone;
}

/// A fragment's own piece goes with all of it. Engines before 7 told no place of another.
void FragmentSolids::take_out(const Recording& recording, std::size_t event) {
  const CutEvent& removal = recording.events[event];
  for (Standing& standing : standing_) {
    if (standing.piece != removal.subject ||
        removal.subject < static_cast<std::int32_t>(bones_.size()))
      continue;
    standing.is_out = true;
    return;
  }
  if (recording.engine < first_engine_with_places) return;
  const Vec3 inside_mm = place_of(removal);
  const std::size_t bone = bone_of_piece(recording, event, rebuilt_.fields.fragments());
  for (Standing& standing : standing_) {
    if (standing.is_out || standing.whole.own == nullptr || standing.bone != bone) continue;
    if (!standing.whole.own->tree.contains(inside_mm)) continue;
    standing.taken.push_back(
        {inside_mm, standing.kerfs.size(), body_then(standing, recording, event)});
    return;
  }
}

/// The piece as the kerfs had cut it by then; null where they go no further.
std::unique_ptr<const Bvh> FragmentSolids::body_then(const Standing& standing,
                                                     const Recording& recording,
                                                     std::size_t event) const {
  if (!goes_on_in_kerfs(recording, event)) return nullptr;
  simulator::KerfSet then(rebuilt_.fields.tray(), poses_of(bones_));
  open_until(then, recording, event);
  CutBone bone(*standing.whole.own);
  for (const std::int32_t kerf : standing.kerfs) {
    bone.put_kerf(bone.kerf_count(),
                  {kerf, then.plane(kerf), then.field(kerf).grid(), outline_of(then.field(kerf))});
  }
  for (const CutSolid& piece : split_pieces(bone.after_all())) {
    auto body = std::make_unique<const Bvh>(piece.mesh);
    if (body->contains(place_of(recording.events[event]))) return body;
  }
  return nullptr;
}

void FragmentSolids::let_go(std::vector<CutSolid> gone, std::size_t bone) {
  std::move(gone.begin(), gone.end(), std::back_inserter(gone_[bone]));
}

void FragmentSolids::keep(std::vector<CutSolid> solids, std::size_t bone, bool are_out) {
  simulator::SortedBodies sorted = sort_bodies(std::move(solids));
  std::move(sorted.bodies.begin(), sorted.bodies.end(), std::back_inserter(rebuilt_.pieces));
  rebuilt_.piece_volumes_mm3.insert(rebuilt_.piece_volumes_mm3.end(), sorted.volumes_mm3.begin(),
                                    sorted.volumes_mm3.end());
  rebuilt_.piece_bones.resize(rebuilt_.pieces.size(), bone);
  rebuilt_.is_piece_out.resize(rebuilt_.pieces.size(), are_out);
  rebuilt_.debris_mm3 += sorted.debris_mm3;
  rebuilt_.debris_count += static_cast<std::int32_t>(sorted.crumbs.size());
}

/// Of the fragment's pieces, from that one on.
void FragmentSolids::mark_taken(const Standing& standing, std::size_t first) {
  for (const TakenPiece& taken : standing.taken) {
    for (std::size_t piece = rebuilt_.pieces.size(); piece-- > first;) {
      if (!is_of(rebuilt_.pieces[piece], taken)) continue;
      rebuilt_.is_piece_out[piece] = true;
      if (taken.body == nullptr) break;
    }
  }
}

void FragmentSolids::keep_pieces() {
  for (const Standing& standing : standing_) {
    const std::size_t first = rebuilt_.pieces.size();
    if (standing.whole.bone != nullptr)
      keep(split_pieces(standing.sawn().bone->after_all()), standing.bone, standing.is_out);
    mark_taken(standing, first);
    rebuilt_.fragments.push_back(
        {standing.piece, first, rebuilt_.pieces.size() - first, standing.is_out});
  }
  for (std::size_t bone = 0; bone < gone_.size(); ++bone) keep(std::move(gone_[bone]), bone, true);
}

}  // namespace hallux::assessment
