/// A moment is a patch on its stretch's mesh, built anew only where the kerf has grown since or a
/// piece has gone. Rays are asked of what is shown, triangle by triangle: a click is not a frame,
/// and the mesh changes with each moment.
#include "simulator/history/bone_moment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hallux::simulator {

namespace {

constexpr double least_sine = 1.0e-12;

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
      ask(corners_of(mesh, i));
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

void BoneMoment::move_to(std::int64_t tick) {
  tick_ = tick;
  const std::size_t stretch = history_.stretch_at(tick);
  const BoneStretch& now = history_.stretches[stretch];
  const std::size_t grown =
      now.growing < 0 ? 0 : history_.kerfs[static_cast<std::size_t>(now.growing)].grown_at(tick);
  std::size_t taken = 0;
  while (taken < history_.taken.size() && history_.taken[taken].tick <= tick) ++taken;
  const bool is_now_closed = history_.closed && tick >= history_.closed->tick;
  const bool is_same =
      stretch_ == stretch && grown_ == grown && taken_ == taken && was_closed_ == is_now_closed;
  if (is_same) return;
  if (stretch_ != stretch) builder_.reset();
  stretch_ = stretch;
  grown_ = grown;
  taken_ = taken;
  was_closed_ = is_now_closed;
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
      const auto corners = patch_corners(mesh(), patch_, patch_.triangles[i]);
      if (lies_on(*history_.taken[piece].body, middle_of(corners))) continue;
      patch_.triangles[kept] = patch_.triangles[i];
      patch_.sources[kept] = patch_.sources[i];
      ++kept;
    }
    patch_.triangles.resize(kept);
    patch_.sources.resize(kept);
  }
}

const SolidPatch* BoneMoment::patch() const noexcept {
  return patch_.hidden.empty() && patch_.triangles.empty() ? nullptr : &patch_;
}

std::optional<KerfOpening> BoneMoment::kerf_at_hand() {
  std::int32_t newest = -1, newest_tick = -1;
  for (std::size_t kerf = 0; kerf < history_.kerfs.size(); ++kerf) {
    const KerfGrowth& growth = history_.kerfs[kerf];
    const std::size_t grown = growth.grown_at(tick_);
    if (grown == 0 || growth.ticks[grown - 1] < newest_tick) continue;
    newest = static_cast<std::int32_t>(kerf);
    newest_tick = growth.ticks[grown - 1];
  }
  if (newest < 0) return std::nullopt;
  const OpenedField& opened = history_.kerfs[static_cast<std::size_t>(newest)].opened;
  const bool grows = history_.stretches[stretch()].growing == newest;
  return KerfOpening{opened.plane,
                     loops_of(grows ? outline_of_growing(newest) : outline_at(opened, tick_))};
}

std::optional<Vec3> BoneMoment::first_hit(const Vec3& from_in_bone_mm,
                                          const Vec3& direction) const {
  NearestHit fixed{from_in_bone_mm, direction};
  if (!was_closed_) {
    fixed.ask(mesh(), patch_.hidden);
    for (const Triangle& triangle : patch_.triangles)
      fixed.ask(patch_corners(mesh(), patch_, triangle));
    if (!std::isfinite(fixed.distance)) return std::nullopt;
    return from_in_bone_mm + fixed.distance * direction;
  }
  const RigidTransform moved_from_bone = inverse(history_.closed->bone_from_moved);
  NearestHit moved{transform_point(moved_from_bone, from_in_bone_mm),
                   transform_direction(moved_from_bone, direction)};
  fixed.ask(history_.closed->fixed.mesh, {});
  moved.ask(history_.closed->moved.mesh, {});
  if (!std::isfinite(std::min(fixed.distance, moved.distance))) return std::nullopt;
  if (moved.distance < fixed.distance) return moved.from + moved.distance * moved.direction;
  return fixed.from + fixed.distance * fixed.direction;
}

Vec3 BoneMoment::moved_place(const Vec3& point_in_bone_mm) const {
  if (!was_closed_) return point_in_bone_mm;
  const auto off = [&](const CutSolid& half) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& point : half.mesh.points_mm)
      least = std::min(least, length_of(point - point_in_bone_mm));
    return least;
  };
  const bool is_moved = off(history_.closed->moved) < off(history_.closed->fixed);
  return is_moved ? transform_point(history_.closed->bone_from_moved, point_in_bone_mm)
                  : point_in_bone_mm;
}

}  // namespace hallux::simulator
