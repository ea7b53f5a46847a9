#include "ui/render/scene/bone_look.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/base/check.h"
#include "simulator/mesh/bvh.h"

namespace hallux::ui {

namespace {

constexpr double spacing_mm = 0.75;
constexpr double reach_mm = 6.0;  ///< of the lattice around the bone: as far as hollows are felt
constexpr double steps_per_mm = 2048.0;

std::uint16_t node_of(double depth_mm) {
  const double steps = (depth_mm + depth_limit_mm) * steps_per_mm;
  return static_cast<std::uint16_t>(std::clamp(std::lround(steps), 0L, 65535L));
}

double depth_of(std::uint16_t node) {
  return static_cast<double>(node) / steps_per_mm - depth_limit_mm;
}

DepthVolume lattice_around(const simulator::IndexedMesh& mesh) {
  Vec3 low_mm(1e300), high_mm(-1e300);
  for (const Vec3& point_mm : mesh.points_mm) {
    low_mm = glm::min(low_mm, point_mm);
    high_mm = glm::max(high_mm, point_mm);
  }
  DepthVolume volume;
  volume.spacing_mm = spacing_mm;
  volume.origin_in_bone_mm = low_mm - Vec3(reach_mm);
  const Vec3 size_mm = high_mm - low_mm + Vec3(2.0 * reach_mm);
  const auto count = [&](double length_mm) {
    return static_cast<std::uint32_t>(std::ceil(length_mm / spacing_mm)) + 1;
  };
  volume.x_count = count(size_mm.x);
  volume.y_count = count(size_mm.y);
  volume.z_count = count(size_mm.z);
  return volume;
}

void fill(DepthVolume& volume, const simulator::IndexedMesh& mesh, const Progress& progress) {
  const simulator::Bvh bvh(mesh);
  volume.nodes.reserve(static_cast<std::size_t>(volume.x_count) * volume.y_count * volume.z_count);
  for (std::uint32_t z = 0; z < volume.z_count; ++z) {
    report(progress, static_cast<double>(z) / volume.z_count);
    for (std::uint32_t y = 0; y < volume.y_count; ++y) {
      for (std::uint32_t x = 0; x < volume.x_count; ++x) {
        const Vec3 place_mm = volume.origin_in_bone_mm + volume.spacing_mm * Vec3(x, y, z);
        volume.nodes.push_back(node_of(-bvh.signed_distance_mm(place_mm, depth_limit_mm)));
      }
    }
  }
}

/// A place along one axis of the lattice: the node before it and the share of the way to the next.
struct Along {
  std::uint32_t node = 0;
  double share = 0.0;
};

Along along(double place, std::uint32_t count) {
  const double inside = std::clamp(place, 0.0, static_cast<double>(count - 1) - 1e-9);
  const double node = std::floor(inside);
  return {static_cast<std::uint32_t>(node), inside - node};
}

}  // namespace

double depth_at(const DepthVolume& volume, const Vec3& point_in_bone_mm) noexcept {
  const Vec3 place = (point_in_bone_mm - volume.origin_in_bone_mm) / volume.spacing_mm;
  const Along x = along(place.x, volume.x_count), y = along(place.y, volume.y_count),
              z = along(place.z, volume.z_count);
  const auto row_at = [&](std::uint32_t j, std::uint32_t k) {
    const std::size_t row =
        (static_cast<std::size_t>(z.node + k) * volume.y_count + (y.node + j)) * volume.x_count;
    const double low = depth_of(volume.nodes[row + x.node]);
    return low + x.share * (depth_of(volume.nodes[row + x.node + 1]) - low);
  };
  const double lower = row_at(0, 0) + y.share * (row_at(1, 0) - row_at(0, 0));
  const double upper = row_at(0, 1) + y.share * (row_at(1, 1) - row_at(0, 1));
  return lower + z.share * (upper - lower);
}

BoneLook look_of(std::uint64_t id, const simulator::IndexedMesh& outer, const Progress& progress) {
  CHECK(id != 0);
  BoneLook look;
  look.id = id;
  look.depth = lattice_around(outer);
  fill(look.depth, outer, progress);
  return look;
}

BoneLook look_of(std::uint64_t id, const simulator::Bone& bone, const Progress& progress) {
  BoneLook look = look_of(id, bone.outer, progress);
  look.cortex = bone.cortex;
  return look;
}

double openness_at(const DepthVolume& volume, const Vec3& point_in_bone_mm,
                   const Vec3& normal) noexcept {
  constexpr std::array<double, 3> steps_mm{1.2, 2.8, 5.5};
  constexpr std::array<double, 3> weights{0.30, 0.35, 0.35};
  double open = 0.0;
  for (std::size_t i = 0; i < steps_mm.size(); ++i) {
    const double free_mm = -depth_at(volume, point_in_bone_mm + steps_mm[i] * normal);
    open += weights[i] * std::clamp(free_mm / steps_mm[i], 0.0, 1.0);
  }
  return open;
}

}  // namespace hallux::ui
