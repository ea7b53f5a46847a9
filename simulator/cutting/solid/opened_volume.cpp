/// The divergence theorem with the field (0, 0, z): the volume is the sum over the faces of the
/// removed body of the integral of z over the face's shadow in the plane, counted positive where
/// the face looks up. Fronts cast no shadow. What is left are the strip's triangles and the two
/// walls, all within the region.
///
/// A region is the signed sum of the triangles from a fixed point to its edges, and so is a section
/// from its segments. So every integral is one over the common part of two triangles, which is
/// convex.
#include "simulator/cutting/solid/opened_volume.h"

#include <algorithm>
#include <array>
#include <vector>

namespace hallux::simulator {

namespace {

using Shadow = std::array<Vec2, 3>;

double doubled_area(const Vec2& a, const Vec2& b, const Vec2& c) noexcept {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A triangle turned counter-clockwise, with the sign it had.
struct SignedShadow {
  Shadow corners_mm;
  double sign = 0.0;
  Vec2 min_mm{0.0, 0.0}, max_mm{0.0, 0.0};
};

SignedShadow signed_shadow(const Vec2& a, const Vec2& b, const Vec2& c) noexcept {
  SignedShadow shadow{{a, b, c}, 0.0, glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
  const double area = doubled_area(a, b, c);
  if (area > 0.0) shadow.sign = 1.0;
  if (area < 0.0) {
    shadow.sign = -1.0;
    std::swap(shadow.corners_mm[1], shadow.corners_mm[2]);
  }
  return shadow;
}

bool may_overlap(const SignedShadow& a, const SignedShadow& b) noexcept {
  return a.min_mm.x <= b.max_mm.x && b.min_mm.x <= a.max_mm.x && a.min_mm.y <= b.max_mm.y &&
         b.min_mm.y <= a.max_mm.y;
}

/// Twice an area that no rounding of corners within a metre reaches.
constexpr double clear_mm2 = 1.0e-6;

/// All of it lies beyond one side of the other, at most a corner on its line: the common part has
/// no area then, by CommonPart's own arithmetic too.
bool is_beyond_a_side(const SignedShadow& shadow, const SignedShadow& of) noexcept {
  const auto is_beyond = [&](const Vec2& from_mm, const Vec2& to_mm) {
    int beyond = 0, on_line = 0;
    for (const Vec2& corner_mm : shadow.corners_mm) {
      const double side = doubled_area(from_mm, to_mm, corner_mm);
      beyond += side < -clear_mm2;
      on_line += side == 0.0;
    }
    return beyond + on_line == 3 && on_line <= 1;
  };
  return is_beyond(of.corners_mm[0], of.corners_mm[1]) ||
         is_beyond(of.corners_mm[1], of.corners_mm[2]) ||
         is_beyond(of.corners_mm[2], of.corners_mm[0]);
}

/// The common part of two triangles: at most six corners (Sutherland and Hodgman 1974).
class CommonPart {
 public:
  CommonPart(const SignedShadow& a, const SignedShadow& b) noexcept {
    for (const Vec2& corner_mm : a.corners_mm) corners_mm_[count_++] = corner_mm;
    for (std::size_t k = 0; k < 3; ++k) {
      keep_left_of(b.corners_mm[k], b.corners_mm[(k + 1) % 3]);
    }
  }

  /// The integral of a function that is linear in the plane [its unit x mm2].
  template <typename Linear>
  double integral(Linear&& value) const noexcept {
    double sum = 0.0;
    for (std::size_t i = 2; i < count_; ++i) {
      const double area = 0.5 * doubled_area(corners_mm_[0], corners_mm_[i - 1], corners_mm_[i]);
      sum +=
          area / 3.0 * (value(corners_mm_[0]) + value(corners_mm_[i - 1]) + value(corners_mm_[i]));
    }
    return sum;
  }

 private:
  void keep_left_of(const Vec2& from_mm, const Vec2& to_mm) noexcept {
    std::array<Vec2, 8> kept;
    std::size_t kept_count = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const Vec2& p = corners_mm_[i];
      const Vec2& q = corners_mm_[(i + 1) % count_];
      const double p_side = doubled_area(from_mm, to_mm, p);
      const double q_side = doubled_area(from_mm, to_mm, q);
      if (p_side >= 0.0) kept[kept_count++] = p;
      if ((p_side >= 0.0) != (q_side >= 0.0)) {
        kept[kept_count++] = p + p_side / (p_side - q_side) * (q - p);
      }
    }
    corners_mm_ = kept;
    count_ = kept_count;
  }

  std::array<Vec2, 8> corners_mm_;
  std::size_t count_ = 0;
};

std::vector<SignedShadow> fan_of(const RegionOutline& region) {
  std::vector<SignedShadow> fan;
  if (region.corners_mm.empty()) return fan;
  const Vec2 apex_mm = region.corners_mm.front();
  std::uint32_t first = 0;
  for (const std::uint32_t end : region.loop_ends) {
    for (std::uint32_t i = first; i < end; ++i) {
      const Vec2& next_mm = region.corners_mm[i + 1 < end ? i + 1 : first];
      const SignedShadow shadow = signed_shadow(apex_mm, region.corners_mm[i], next_mm);
      if (shadow.sign != 0.0) fan.push_back(shadow);
    }
    first = end;
  }
  return fan;
}

/// A triangle's part between two heights, in the kerf's frame.
struct SlabPolygon {
  std::array<Vec3, 5> corners_mm;
  std::size_t count = 0;

  /// Keeps what lies where sign * z <= half.
  void keep(double sign, double half_mm) noexcept {
    SlabPolygon kept;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3& p = corners_mm[i];
      const Vec3& q = corners_mm[(i + 1) % count];
      const double p_over = sign * p.z - half_mm, q_over = sign * q.z - half_mm;
      if (p_over <= 0.0) kept.corners_mm[kept.count++] = p;
      if ((p_over <= 0.0) == (q_over <= 0.0)) continue;
      Vec3 crossing = p + p_over / (p_over - q_over) * (q - p);
      crossing.z = sign * half_mm;
      kept.corners_mm[kept.count++] = crossing;
    }
    *this = kept;
  }
};

class OpenedVolume {
 public:
  OpenedVolume(const KerfPlane& plane, const RegionOutline& region)
      : half_mm_(0.5 * plane.thickness_mm),
        kerf_from_bone_(inverse(plane.bone_from_kerf)),
        region_(fan_of(region)),
        apex_mm_(region.corners_mm.empty() ? Vec2(0.0) : region.corners_mm.front()) {}

  void add(const IndexedMesh& mesh, const Triangle& triangle) {
    SlabPolygon part;
    for (const std::uint32_t corner : triangle) {
      part.corners_mm[part.count++] = transform_point(kerf_from_bone_, mesh.points_mm[corner]);
    }
    part.keep(1.0, half_mm_);
    part.keep(-1.0, half_mm_);
    for (std::size_t i = 2; i < part.count; ++i) {
      add_skin(part.corners_mm[0], part.corners_mm[i - 1], part.corners_mm[i]);
    }
    for (std::size_t i = 0; i < part.count; ++i) {
      add_wall(part.corners_mm[i], part.corners_mm[(i + 1) % part.count]);
    }
  }
  double volume_mm3() const noexcept { return volume_mm3_; }

 private:
  void add_skin(const Vec3& a, const Vec3& b, const Vec3& c) {
    const SignedShadow shadow = signed_shadow(Vec2(a.x, a.y), Vec2(b.x, b.y), Vec2(c.x, c.y));
    if (shadow.sign == 0.0) return;
    const double whole = doubled_area(Vec2(a.x, a.y), Vec2(b.x, b.y), Vec2(c.x, c.y));
    const auto height_at = [&](const Vec2& p) {
      const double of_b = doubled_area(Vec2(a.x, a.y), p, Vec2(c.x, c.y)) / whole;
      const double of_c = doubled_area(Vec2(a.x, a.y), Vec2(b.x, b.y), p) / whole;
      const double height_mm = a.z + of_b * (b.z - a.z) + of_c * (c.z - a.z);
      return std::clamp(height_mm, -half_mm_, half_mm_);
    };
    add_common_parts(shadow, height_at);
  }
  /// An edge in one of the planes is a segment of that plane's section, counter-clockwise on the
  /// lower one.
  void add_wall(const Vec3& p, const Vec3& q) {
    if (p.z != q.z || (p.z != half_mm_ && p.z != -half_mm_)) return;
    const SignedShadow shadow = signed_shadow(apex_mm_, Vec2(p.x, p.y), Vec2(q.x, q.y));
    if (shadow.sign == 0.0) return;
    add_common_parts(shadow, [&](const Vec2&) { return -p.z; });
  }
  template <typename Height>
  void add_common_parts(const SignedShadow& shadow, Height&& height_at) {
    for (const SignedShadow& part : region_) {
      if (!may_overlap(shadow, part) || is_beyond_a_side(shadow, part)) continue;
      volume_mm3_ += shadow.sign * part.sign * CommonPart(shadow, part).integral(height_at);
    }
  }

  double half_mm_;
  RigidTransform kerf_from_bone_;
  std::vector<SignedShadow> region_;
  Vec2 apex_mm_;
  double volume_mm3_ = 0.0;
};

}  // namespace

double opened_volume_mm3(const CutSolid& solid, const KerfPlane& plane,
                         const RegionOutline& region) {
  OpenedVolume opened(plane, region);
  for (const Triangle& triangle : solid.mesh.triangles) opened.add(solid.mesh, triangle);
  return opened.volume_mm3();
}

double opened_volume_mm3(const CutSolid& solid, std::span<const std::uint32_t> triangles,
                         const KerfPlane& plane, const RegionOutline& region) {
  OpenedVolume opened(plane, region);
  for (const std::uint32_t triangle : triangles) {
    opened.add(solid.mesh, solid.mesh.triangles[triangle]);
  }
  return opened.volume_mm3();
}

}  // namespace hallux::simulator
