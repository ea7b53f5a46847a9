#include "ui/screens/replay/bone_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/planned_bridge.h"
#include "simulator/cutting/hinge.h"
#include "simulator/cutting/kerf_set.h"
#include "ui/screens/bone_stage.h"

namespace hallux::ui {

namespace {

using namespace simulator;

constexpr std::int64_t note_every_ticks = 20;
constexpr std::size_t samples_per_report = 4096;
/// Shares of the time: following the blade, the look of the bone, then the meshes.
constexpr double follow_share = 0.35, look_share = 0.5;
/// A triangle of a piece lies on its surface but for rounding.
constexpr double on_surface_mm = 1.0e-3;
constexpr double least_sine = 1.0e-12;

/// Where the growth passes from one kerf to another.
struct Turn {
  std::int64_t tick = 0;
  std::int32_t kerf = -1;
};

/// Follows the recording once, sample by sample, and notes what was opened.
class GrowthNotes {
 public:
  GrowthNotes(const HistoryRequest& request, BoneHistory& history)
      : request_(request), history_(history), kerfs_(request.blade, request.bone.world_from_bone) {}

  std::vector<Turn> follow(const std::function<void(double)>& progress) {
    const std::vector<ToolSample>& samples = request_.recording.samples;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      freeze_until(samples[i].tick);
      take(samples[i]);
      if (progress && i % samples_per_report == 0)
        progress(static_cast<double>(i) / static_cast<double>(samples.size()));
    }
    note(last_growth_tick_);
    return std::move(turns_);
  }

 private:
  void freeze_until(std::int64_t tick) {
    const std::vector<CutEvent>& events = request_.recording.events;
    for (; next_event_ < events.size() && events[next_event_].tick <= tick; ++next_event_) {
      const CutEvent& event = events[next_event_];
      if (event.kind != CutEventKind::PlaneFrozen) continue;
      const std::int32_t kerf = kerfs_.freeze(event.pose);
      if (kerf < 0) continue;
      const FieldGrid& grid = kerfs_.field(kerf).grid();
      history_.kerfs.push_back({kerfs_.plane(kerf), grid, {}, {}});
      trackers_.push_back(std::make_unique<OutlineTracker>(grid));
    }
  }

  void take(const ToolSample& sample) {
    const bool has_grown = !kerfs_.follow(sample).is_empty();
    if (has_grown && sample.kerf != growing_) {
      note(last_growth_tick_);
      growing_ = sample.kerf;
      turns_.push_back({sample.tick, growing_});
    }
    if (has_grown) {
      is_unnoted_ = true;
      last_growth_tick_ = sample.tick;
    }
    if (is_unnoted_ && sample.tick - last_noted_tick_ >= note_every_ticks) note(last_growth_tick_);
  }

  void note(std::int64_t tick) {
    if (!is_unnoted_) return;
    const auto index = static_cast<std::size_t>(growing_);
    trackers_[index]->update(kerfs_.field(growing_));
    history_.kerfs[index].ticks.push_back(tick);
    history_.kerfs[index].outlines.push_back(trackers_[index]->outline());
    is_unnoted_ = false;
    last_noted_tick_ = tick;
  }

  const HistoryRequest& request_;
  BoneHistory& history_;
  KerfSet kerfs_;
  std::vector<std::unique_ptr<OutlineTracker>> trackers_;
  std::vector<Turn> turns_;
  std::size_t next_event_ = 0;
  std::int32_t growing_ = -1;
  std::int64_t last_growth_tick_ = 0, last_noted_tick_ = 0;
  bool is_unnoted_ = false;
};

/// The bone less the kerfs as they stood at a tick, but for one that is left whole.
CutSolid cut_at(const HistoryRequest& request, const BoneHistory& history, std::int64_t tick,
                std::int32_t but_for) {
  CutSolid solid = uncut_solid(solid_of(request.bone));
  for (std::size_t kerf = 0; kerf < history.kerfs.size(); ++kerf) {
    const KerfGrowth& growth = history.kerfs[kerf];
    const RegionOutline* outline = growth.at(tick);
    if (static_cast<std::int32_t>(kerf) == but_for || outline == nullptr) continue;
    const Bvh bvh(solid.mesh);
    solid =
        cut_kerf(solid, bvh, growth.plane, static_cast<std::int32_t>(kerf), growth.grid, *outline)
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
      slice_contact(stretch.mesh.solid, bvh, growth.plane, turn.kerf, growth.grid));
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
    const RegionOutline* outline = history.kerfs[kerf].at(tick);
    if (outline == nullptr) continue;
    const Section section = slice_section(whole, bvh, history.kerfs[kerf].plane);
    const auto gap = measure_hinge_gap(section, *outline, bridge.line);
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
  asked.first = history.kerfs[gaps[0].second].plane;
  asked.second = history.kerfs[gaps[1].second].plane;
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

const RegionOutline* KerfGrowth::at(std::int64_t tick) const noexcept {
  const auto next = std::upper_bound(ticks.begin(), ticks.end(), tick);
  if (next == ticks.begin()) return nullptr;
  return &outlines[static_cast<std::size_t>(next - ticks.begin()) - 1];
}

std::size_t BoneHistory::stretch_at(std::int64_t tick) const noexcept {
  std::size_t found = 0;
  for (std::size_t i = 1; i < stretches.size(); ++i)
    if (stretches[i].from_tick <= tick) found = i;
  return found;
}

std::shared_ptr<const BoneHistory> build_history(const HistoryRequest& request,
                                                 const std::function<void(double)>& progress) {
  const auto report = [&](double fraction) {
    if (progress) progress(fraction);
  };
  auto history = std::make_shared<BoneHistory>();
  std::vector<Turn> turns = GrowthNotes(request, *history).follow([&](double fraction) {
    report(follow_share * fraction);
  });
  history->look = look_of(picture_id("look " + request.name), request.bone, [&](double fraction) {
    report(follow_share + (look_share - follow_share) * fraction);
  });
  if (turns.empty()) turns.push_back({0, -1});
  turns.front().tick = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    report(look_share +
           (0.9 - look_share) * static_cast<double>(i) / static_cast<double>(turns.size()));
    history->stretches.push_back(stretch_from(request, *history, turns[i]));
  }
  report(0.9);
  take_pieces(request, *history);
  close_halves(request, *history);
  report(1.0);
  return history;
}

void BoneMoment::move_to(std::int64_t tick) {
  tick_ = tick;
  const std::size_t stretch = history_.stretch_at(tick);
  const BoneStretch& now = history_.stretches[stretch];
  const RegionOutline* outline =
      now.growing < 0 ? nullptr : history_.kerfs[static_cast<std::size_t>(now.growing)].at(tick);
  std::size_t taken = 0;
  while (taken < history_.taken.size() && history_.taken[taken].tick <= tick) ++taken;
  const bool is_same =
      stretch_ == stretch && outline_ == outline && taken_ == taken && was_closed_ == is_closed();
  if (is_same) return;
  if (stretch_ != stretch) builder_.reset();
  stretch_ = stretch;
  outline_ = outline;
  taken_ = taken;
  was_closed_ = is_closed();
  ++revision_;
  if (!was_closed_) build_patch();
}

void BoneMoment::build_patch() {
  const BoneStretch& stretch = history_.stretches[*stretch_];
  if (outline_ == nullptr) {
    patch_ = {};
  } else {
    if (!builder_) builder_ = std::make_unique<PatchBuilder>(*stretch.contact);
    // A refused outline leaves the patch of the moment before: a twentieth of a second.
    if (!builder_->build(*outline_, patch_)) return;
  }
  leave_out_taken();
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
