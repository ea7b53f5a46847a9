#include "ui/screens/replay/bone_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/planned_bridge.h"
#include "simulator/cutting/hinge/hinge.h"
#include "ui/screens/pictures/bone_stage.h"

namespace hallux::ui {

namespace {

using namespace simulator;

/// A triangle of a piece lies on its surface but for rounding.
constexpr double on_surface_mm = 1.0e-3;
constexpr double least_sine = 1.0e-12;

/// Where the growth passes from one kerf to another.
struct Turn {
  std::int64_t tick = 0;
  std::int32_t kerf = -1;
};

/// At each tick the blade is in one kerf.
std::vector<Turn> turns_of(const std::vector<KerfGrowth>& kerfs) {
  std::vector<Turn> grown;
  for (std::size_t kerf = 0; kerf < kerfs.size(); ++kerf) {
    for (const std::int32_t tick : kerfs[kerf].ticks)
      grown.push_back({tick, static_cast<std::int32_t>(kerf)});
  }
  std::sort(grown.begin(), grown.end(),
            [](const Turn& a, const Turn& b) { return a.tick < b.tick; });
  const auto end = std::unique(grown.begin(), grown.end(),
                               [](const Turn& a, const Turn& b) { return a.kerf == b.kerf; });
  grown.erase(end, grown.end());
  return grown;
}

/// The bone less the kerfs as they stood at a tick, but for one that is left whole.
CutSolid cut_at(const HistoryRequest& request, const BoneHistory& history, std::int64_t tick,
                std::int32_t but_for) {
  CutSolid solid = uncut_solid(solid_of(request.bone));
  for (std::size_t kerf = 0; kerf < history.kerfs.size(); ++kerf) {
    const KerfGrowth& growth = history.kerfs[kerf];
    if (static_cast<std::int32_t>(kerf) == but_for || growth.grown_at(tick) == 0) continue;
    const Bvh bvh(solid.mesh);
    solid = cut_kerf(solid, bvh, growth.opened.plane, static_cast<std::int32_t>(kerf),
                     growth.opened.grid, outline_at(growth.opened, tick))
                .solid;
  }
  return solid;
}

BoneMesh lit_mesh(std::uint64_t id, const CutSolid& solid, const BoneLook& look) {
  BoneMesh mesh = mesh_of(id, solid, look);
  const Bvh tree(solid.mesh);
  const Occluder own{&tree, {}};
  light_cut_faces(mesh, std::span(&own, 1));
  return mesh;
}

BoneStretch stretch_from(const HistoryRequest& request, const BoneHistory& history,
                         const Turn& turn) {
  BoneStretch stretch;
  stretch.from_tick = turn.tick;
  stretch.growing = turn.kerf;
  const CutSolid solid = cut_at(request, history, turn.tick, turn.kerf);
  stretch.mesh = lit_mesh(picture_id(request.name + " stretch " + std::to_string(turn.tick)), solid,
                          history.look);
  if (turn.kerf < 0) return stretch;
  const KerfGrowth& growth = history.kerfs[static_cast<std::size_t>(turn.kerf)];
  const Bvh bvh(stretch.mesh.solid.mesh);
  stretch.contact = std::make_unique<const KerfContact>(
      slice_contact(stretch.mesh.solid, bvh, growth.opened.plane, turn.kerf, growth.opened.grid));
  return stretch;
}

Vec3 middle_of(const IndexedMesh& mesh, const Triangle& triangle) {
  return (mesh.points_mm[triangle[0]] + mesh.points_mm[triangle[1]] + mesh.points_mm[triangle[2]]) /
         3.0;
}

bool is_on(const Bvh& body, const Vec3& point_mm) {
  return body.nearest(point_mm, on_surface_mm).has_value();
}

std::vector<std::uint32_t> triangles_on(const IndexedMesh& mesh, const Bvh& body) {
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (is_on(body, middle_of(mesh, mesh.triangles[i])))
      found.push_back(static_cast<std::uint32_t>(i));
  }
  return found;
}

/// The volume that was announced when this piece came free; nothing where it never was.
std::optional<double> freed_mm3(const Recording& recording, const CutEvent& removal) {
  std::optional<double> volume;
  for (const CutEvent& event : recording.events) {
    if (event.tick > removal.tick) break;
    if (event.kind == CutEventKind::PieceFreed && event.subject == removal.subject)
      volume = static_cast<double>(event.value) / 1000.0;
  }
  return volume;
}

/// Of the bodies that lie in the wound the one that was picked up: the nearest in volume, never one that is out already.
std::optional<CutSolid> picked_up(const HistoryRequest& request, const BoneHistory& history,
                                  const CutEvent& removal) {
  const std::optional<double> wanted_mm3 = freed_mm3(request.recording, removal);
  if (!wanted_mm3) return std::nullopt;
  std::optional<CutSolid> found;
  double least = std::numeric_limits<double>::infinity();
  for (CutSolid& piece : split_pieces(cut_at(request, history, removal.tick, -1))) {
    const Vec3 on_piece = middle_of(piece.mesh, piece.mesh.triangles.front());
    const bool is_out =
        std::any_of(history.taken.begin(), history.taken.end(),
                    [&](const TakenPiece& taken) { return is_on(*taken.body, on_piece); });
    const double off = std::abs(signed_volume_mm3(piece.mesh) - *wanted_mm3);
    if (is_out || off >= least) continue;
    least = off;
    found = std::move(piece);
  }
  return found;
}

void take_pieces(const HistoryRequest& request, BoneHistory& history) {
  for (const CutEvent& event : request.recording.events) {
    if (event.kind != CutEventKind::PieceRemoved) continue;
    const std::optional<CutSolid> piece = picked_up(request, history, event);
    if (piece) history.taken.push_back({event.tick, std::make_unique<const Bvh>(piece->mesh)});
  }
  for (std::size_t i = 0; i < history.stretches.size(); ++i) {
    BoneStretch& stretch = history.stretches[i];
    const bool is_last = i + 1 == history.stretches.size();
    for (const TakenPiece& taken : history.taken) {
      const bool is_seen = is_last || history.stretches[i + 1].from_tick > taken.tick;
      stretch.of_piece.push_back(is_seen ? triangles_on(stretch.mesh.solid.mesh, *taken.body)
                                         : std::vector<std::uint32_t>());
    }
  }
}

/// What lies in the wound at a tick: the bodies that are not out.
CutSolid standing_at(const HistoryRequest& request, const BoneHistory& history, std::int64_t tick) {
  CutSolid standing;
  for (const CutSolid& piece : split_pieces(cut_at(request, history, tick, -1))) {
    const Vec3 on_piece = middle_of(piece.mesh, piece.mesh.triangles.front());
    const bool is_out =
        std::any_of(history.taken.begin(), history.taken.end(), [&](const TakenPiece& taken) {
          return taken.tick <= tick && is_on(*taken.body, on_piece);
        });
    if (is_out) continue;
    append_mesh(standing.mesh, piece.mesh);
    standing.origins.insert(standing.origins.end(), piece.origins.begin(), piece.origins.end());
  }
  return standing;
}

/// The kerfs at the planned bridge with the bone that each leaves there, thinnest first.
std::vector<std::pair<HingeGap, std::size_t>> gaps_at(const HistoryRequest& request,
                                                      const BoneHistory& history,
                                                      const PlannedBridge& bridge,
                                                      std::int64_t tick) {
  std::vector<std::pair<HingeGap, std::size_t>> gaps;
  const CutSolid whole = uncut_solid(solid_of(request.bone));
  const Bvh bvh(whole.mesh);
  for (std::size_t kerf = 0; kerf < history.kerfs.size(); ++kerf) {
    const KerfGrowth& growth = history.kerfs[kerf];
    if (growth.grown_at(tick) == 0) continue;
    const Section section = slice_section(whole, bvh, growth.opened.plane);
    const auto gap = measure_hinge_gap(section, outline_at(growth.opened, tick), bridge.line);
    if (gap && gap->is_opened) gaps.emplace_back(*gap, kerf);
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const auto& a, const auto& b) {
    return a.first.thickness_mm < b.first.thickness_mm;
  });
  return gaps;
}

void close_halves(const HistoryRequest& request, BoneHistory& history) {
  const auto& events = request.recording.events;
  const auto event = std::find_if(events.begin(), events.end(), [](const CutEvent& each) {
    return each.kind == CutEventKind::HingeClosed;
  });
  const std::optional<PlannedBridge> bridge = scenarios::planned_bridge(request.plan);
  if (event == events.end() || !bridge) return;
  const auto gaps = gaps_at(request, history, *bridge, event->tick);
  if (gaps.size() < 2) return;
  HingeRequest asked;
  asked.first = history.kerfs[gaps[0].second].opened.plane;
  asked.second = history.kerfs[gaps[1].second].opened.plane;
  asked.first_gap = gaps[0].first;
  asked.second_gap = gaps[1].first;
  asked.line = bridge->line;
  asked.toward_moved = bridge->toward_moved;
  asked.breaks_below_mm = bridge->breaks_below_mm;
  asked.bends_up_to_mm = bridge->bends_up_to_mm;
  const CutSolid standing = standing_at(request, history, event->tick);
  const Bvh bvh(standing.mesh);
  const ClosedHinge hinge = close_hinge(standing, bvh, asked);
  if (hinge.outcome != HingeOutcome::Closed) return;
  // The pose is the recorded one: that is where the half came to lie.
  history.closed = {event->tick,
                    lit_mesh(picture_id(request.name + " fixed"), hinge.fixed, history.look),
                    lit_mesh(picture_id(request.name + " moved"), hinge.moved, history.look),
                    transform_from(event->pose)};
}

/// How far along the ray it meets the triangle; nothing where it misses.
/// source  Moeller and Trumbore 1997, Fast, minimum storage ray-triangle intersection
std::optional<double> hit_of(const Vec3& from, const Vec3& direction,
                             const std::array<Vec3, 3>& corners) {
  const Vec3 first = corners[1] - corners[0], second = corners[2] - corners[0];
  const Vec3 across = glm::cross(direction, second);
  const double sine = glm::dot(first, across);
  if (std::abs(sine) < least_sine) return std::nullopt;
  const Vec3 to_origin = from - corners[0];
  const double u = glm::dot(to_origin, across) / sine;
  const Vec3 turned = glm::cross(to_origin, first);
  const double v = glm::dot(direction, turned) / sine;
  const double distance = glm::dot(second, turned) / sine;
  if (u < 0.0 || v < 0.0 || u + v > 1.0 || distance <= 0.0) return std::nullopt;
  return distance;
}

/// Triangles of what is shown, asked one by one: a click, not a frame.
struct NearestHit {
  Vec3 from, direction;
  double distance = std::numeric_limits<double>::infinity();

  void ask(const std::array<Vec3, 3>& corners) {
    const std::optional<double> hit = hit_of(from, direction, corners);
    if (hit) distance = std::min(distance, *hit);
  }
  void ask(const IndexedMesh& mesh, const std::vector<std::uint32_t>& hidden) {
    auto next = hidden.begin();
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      if (next != hidden.end() && *next == i) {
        ++next;
        continue;
      }
      const Triangle& triangle = mesh.triangles[i];
      ask({mesh.points_mm[triangle[0]], mesh.points_mm[triangle[1]], mesh.points_mm[triangle[2]]});
    }
  }
};

Vec3 patch_point(const IndexedMesh& mesh, const SolidPatch& patch, std::uint32_t index) {
  return index < mesh.points_mm.size() ? mesh.points_mm[index]
                                       : patch.points_in_bone_mm[index - mesh.points_mm.size()];
}

std::array<Vec3, 3> patch_corners(const IndexedMesh& mesh, const SolidPatch& patch,
                                  const Triangle& triangle) {
  return {patch_point(mesh, patch, triangle[0]), patch_point(mesh, patch, triangle[1]),
          patch_point(mesh, patch, triangle[2])};
}

}  // namespace

std::size_t KerfGrowth::grown_at(std::int64_t tick) const noexcept {
  const auto next = std::upper_bound(ticks.begin(), ticks.end(), tick);
  return static_cast<std::size_t>(next - ticks.begin());
}

std::size_t BoneHistory::stretch_at(std::int64_t tick) const noexcept {
  std::size_t found = 0;
  for (std::size_t i = 1; i < stretches.size(); ++i)
    if (stretches[i].from_tick <= tick) found = i;
  return found;
}

std::shared_ptr<const BoneHistory> build_history(HistoryRequest request, const Progress& progress) {
  auto history = std::make_shared<BoneHistory>();
  for (OpenedField& opened : request.opened) {
    std::vector<std::int32_t> ticks = opened.ticks();
    history->kerfs.push_back({std::move(opened), std::move(ticks)});
  }
  std::vector<Turn> turns = turns_of(history->kerfs);
  history->look = std::move(request.look);
  if (turns.empty()) turns.push_back({0, -1});
  turns.front().tick = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    report(progress, 0.9 * static_cast<double>(i) / static_cast<double>(turns.size()));
    history->stretches.push_back(stretch_from(request, *history, turns[i]));
  }
  report(progress, 0.9);
  take_pieces(request, *history);
  close_halves(request, *history);
  report(progress, 1.0);
  return history;
}

void BoneMoment::move_to(std::int64_t tick) {
  tick_ = tick;
  const std::size_t stretch = history_.stretch_at(tick);
  const BoneStretch& now = history_.stretches[stretch];
  const std::size_t grown =
      now.growing < 0 ? 0 : history_.kerfs[static_cast<std::size_t>(now.growing)].grown_at(tick);
  std::size_t taken = 0;
  while (taken < history_.taken.size() && history_.taken[taken].tick <= tick) ++taken;
  const bool is_same =
      stretch_ == stretch && grown_ == grown && taken_ == taken && was_closed_ == is_closed();
  if (is_same) return;
  if (stretch_ != stretch) builder_.reset();
  stretch_ = stretch;
  grown_ = grown;
  taken_ = taken;
  was_closed_ = is_closed();
  ++revision_;
  if (!was_closed_) build_patch();
}

void BoneMoment::build_patch() {
  const BoneStretch& stretch = history_.stretches[*stretch_];
  if (grown_ == 0) {
    patch_ = {};
  } else {
    if (!builder_) builder_ = std::make_unique<PatchBuilder>(*stretch.contact);
    // A refused outline leaves the patch of the moment before.
    if (!builder_->build(outline_of_growing(stretch.growing), patch_)) return;
  }
  leave_out_taken();
}

const RegionOutline& BoneMoment::outline_of_growing(std::int32_t kerf) {
  if (kerf_ != kerf) {
    opened_ = std::make_unique<OpenedMoment>(history_.kerfs[static_cast<std::size_t>(kerf)].opened);
    kerf_ = kerf;
  }
  opened_->move_to(tick_);
  return opened_->outline();
}

void BoneMoment::leave_out_taken() {
  const BoneStretch& stretch = history_.stretches[*stretch_];
  for (std::size_t piece = 0; piece < taken_; ++piece) {
    const std::vector<std::uint32_t>& own = stretch.of_piece[piece];
    std::vector<std::uint32_t> hidden;
    std::set_union(patch_.hidden.begin(), patch_.hidden.end(), own.begin(), own.end(),
                   std::back_inserter(hidden));
    patch_.hidden = std::move(hidden);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < patch_.triangles.size(); ++i) {
      const auto corners = patch_corners(stretch.mesh.solid.mesh, patch_, patch_.triangles[i]);
      if (is_on(*history_.taken[piece].body, (corners[0] + corners[1] + corners[2]) / 3.0))
        continue;
      patch_.triangles[kept] = patch_.triangles[i];
      patch_.origins[kept] = patch_.origins[i];
      ++kept;
    }
    patch_.triangles.resize(kept);
    patch_.origins.resize(kept);
  }
}

std::vector<BoneInScene> BoneMoment::bones(const RigidTransform& world_from_bone) const {
  BoneInScene bone;
  bone.look = &history_.look;
  bone.world_from_bone = world_from_bone;
  if (was_closed_) {
    BoneInScene moved = bone;
    bone.mesh = &history_.closed->fixed;
    moved.mesh = &history_.closed->moved;
    moved.world_from_bone = world_from_bone * history_.closed->bone_from_moved;
    return {bone, moved};
  }
  bone.mesh = &history_.stretches[stretch_.value_or(0)].mesh;
  const bool has_patch = !patch_.hidden.empty() || !patch_.triangles.empty();
  if (has_patch) {
    bone.patch = &patch_;
    bone.patch_revision = revision_;
  }
  return {bone};
}

std::optional<Vec3> BoneMoment::first_hit(const Vec3& from_in_bone_mm,
                                          const Vec3& direction) const {
  NearestHit fixed{from_in_bone_mm, direction};
  if (!was_closed_) {
    const IndexedMesh& mesh = history_.stretches[stretch_.value_or(0)].mesh.solid.mesh;
    fixed.ask(mesh, patch_.hidden);
    for (const Triangle& triangle : patch_.triangles)
      fixed.ask(patch_corners(mesh, patch_, triangle));
    if (!std::isfinite(fixed.distance)) return std::nullopt;
    return from_in_bone_mm + fixed.distance * direction;
  }
  const RigidTransform moved_from_bone = inverse(history_.closed->bone_from_moved);
  NearestHit moved{transform_point(moved_from_bone, from_in_bone_mm),
                   transform_direction(moved_from_bone, direction)};
  fixed.ask(history_.closed->fixed.solid.mesh, {});
  moved.ask(history_.closed->moved.solid.mesh, {});
  if (!std::isfinite(std::min(fixed.distance, moved.distance))) return std::nullopt;
  if (moved.distance < fixed.distance) return moved.from + moved.distance * moved.direction;
  return fixed.from + fixed.distance * fixed.direction;
}

Vec3 BoneMoment::moved_place(const Vec3& point_in_bone_mm) const {
  if (!was_closed_) return point_in_bone_mm;
  const auto off = [&](const BoneMesh& mesh) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& point : mesh.solid.mesh.points_mm)
      least = std::min(least, glm::length(point - point_in_bone_mm));
    return least;
  };
  const bool is_moved = off(history_.closed->moved) < off(history_.closed->fixed);
  return is_moved ? transform_point(history_.closed->bone_from_moved, point_in_bone_mm)
                  : point_in_bone_mm;
}

}  // namespace hallux::ui
