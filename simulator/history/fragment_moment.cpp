/// A moment is a patch on its stretch's mesh, built anew only where the kerf has grown since or a
/// piece has gone. Rays are asked of what is shown, triangle by triangle: a click is not a frame,
/// and the mesh changes with each moment.
#include "simulator/history/fragment_moment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

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

bool FragmentMoment::move_to(std::int64_t tick) {
  tick_ = tick;
  const bool was_there = std::exchange(is_there_, own().is_there(tick));
  if (!is_there_) return was_there;
  const std::size_t stretch = own().stretch_at(tick);
  const BoneStretch& next = own().stretches[stretch];
  const std::size_t grown =
      next.growing < 0 ? 0 : history_->kerfs[static_cast<std::size_t>(next.growing)].grown_at(tick);
  std::size_t taken = 0;
  while (taken < own().taken.size() && own().taken[taken].tick <= tick) ++taken;
  if (stretch_ == stretch && grown_ == grown && taken_ == taken) return !was_there;
  if (stretch_ != stretch) builder_.reset();
  stretch_ = stretch;
  grown_ = grown;
  taken_ = taken;
  build_patch();
  return true;
}

void FragmentMoment::build_patch() {
  if (grown_ == 0) {
    patch_ = {};
  } else {
    if (!builder_) builder_ = std::make_unique<PatchBuilder>(*now().contact);
    // A refused outline leaves the patch of the moment before.
    if (!builder_->build(outline_of_growing(now().growing), patch_)) return;
  }
  leave_out_taken();
}

const RegionOutline& FragmentMoment::outline_of_growing(std::int32_t kerf) {
  if (kerf_ != kerf) {
    opened_ =
        std::make_unique<OpenedMoment>(history_->kerfs[static_cast<std::size_t>(kerf)].opened);
    kerf_ = kerf;
  }
  opened_->move_to(tick_);
  return opened_->outline();
}

RegionOutline FragmentMoment::outline_of(std::int32_t kerf) {
  if (is_there_ && now().growing == kerf) return outline_of_growing(kerf);
  return outline_at(history_->kerfs[static_cast<std::size_t>(kerf)].opened, tick_);
}

void FragmentMoment::leave_out_taken() {
  const IndexedMesh& mesh = solid().mesh;
  for (std::size_t piece = now().taken_before; piece < taken_; ++piece) {
    const std::vector<std::uint32_t>& of_piece = now().of_piece[piece - now().taken_before];
    std::vector<std::uint32_t> hidden;
    std::set_union(patch_.hidden.begin(), patch_.hidden.end(), of_piece.begin(), of_piece.end(),
                   std::back_inserter(hidden));
    patch_.hidden = std::move(hidden);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < patch_.triangles.size(); ++i) {
      const auto corners = patch_corners(mesh, patch_, patch_.triangles[i]);
      if (own().taken[piece].has(middle_of(corners))) continue;
      patch_.triangles[kept] = patch_.triangles[i];
      patch_.sources[kept] = patch_.sources[i];
      ++kept;
    }
    patch_.triangles.resize(kept);
    patch_.sources.resize(kept);
  }
}

const SolidPatch* FragmentMoment::patch() const noexcept {
  return patch_.hidden.empty() && patch_.triangles.empty() ? nullptr : &patch_;
}

std::optional<double> FragmentMoment::first_hit_mm(const Vec3& from_mm,
                                                   const Vec3& direction) const {
  if (!is_there_) return std::nullopt;
  NearestHit nearest{from_mm, direction};
  nearest.ask(solid().mesh, patch_.hidden);
  for (const Triangle& triangle : patch_.triangles)
    nearest.ask(patch_corners(solid().mesh, patch_, triangle));
  if (!std::isfinite(nearest.distance)) return std::nullopt;
  return nearest.distance;
}

}  // namespace hallux::simulator
