/// A cube of nodes is six tetrahedra around its diagonal; each is cut in one way by the signs of
/// its corners, so neighbours always agree and the surface is closed without cases to break a tie.
/// Marching cubes would need fewer triangles and a table of them; remeshing takes either away.
/// Values keep away from zero, and blocks that lie further off than the field is steep are filled
/// from one sample.
#include "scenarios/foot/march_tetrahedra.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hallux::scenarios {
namespace {

constexpr std::int32_t block_nodes = 4;

using Corner = std::uint8_t;  ///< bits 1, 2, 4: one step along x, y, z
using Tetrahedron = std::array<Corner, 4>;

/// Each goes from corner 0 to corner 7 along the axes in another order; all are oriented
/// positively.
constexpr std::array<Tetrahedron, 6> tetrahedra{
    {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}, {0, 3, 2, 7}, {0, 6, 4, 7}}};

/// Even orders of four corners: the corner that stands alone first, or the two inside first.
constexpr std::array<std::array<std::size_t, 4>, 4> alone_first{
    {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}}};
constexpr std::array<std::array<std::size_t, 4>, 6> pair_first{
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

class Marcher {
 public:
  explicit Marcher(const SampledField& field)
      : field_(field), point_of_edge_(field.values.size() * 8, no_point) {}

  simulator::IndexedMesh march() {
    for (std::int32_t k = 0; k + 1 < field_.z_count; ++k) {
      for (std::int32_t j = 0; j + 1 < field_.y_count; ++j) {
        for (std::int32_t i = 0; i + 1 < field_.x_count; ++i) march_cube(i, j, k);
      }
    }
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t no_point = 0xffffffffU;

  void march_cube(std::int32_t i, std::int32_t j, std::int32_t k) {
    i_ = i;
    j_ = j;
    k_ = k;
    int inside = 0;
    for (Corner c = 0; c < 8; ++c) {
      values_[c] = field_.values[node_of(c)];
      if (values_[c] < 0.0) ++inside;
    }
    if (inside == 0 || inside == 8) return;
    for (const Tetrahedron& t : tetrahedra) march_tetrahedron(t);
  }

  void march_tetrahedron(const Tetrahedron& t) {
    unsigned inside = 0;
    int count = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      if (values_[t[c]] >= 0.0) continue;
      inside |= 1U << c;
      ++count;
    }
    if (count == 1 || count == 3) {
      for (const auto& order : alone_first) {
        if (((inside >> order[0]) & 1U) != (count == 1 ? 1U : 0U)) continue;
        add_triangle(t, order, count == 1);
      }
    } else if (count == 2) {
      for (const auto& order : pair_first) {
        if (inside == ((1U << order[0]) | (1U << order[1]))) add_quad(t, order);
      }
    }
  }

  void add_triangle(const Tetrahedron& t, const std::array<std::size_t, 4>& order, bool outward) {
    const std::uint32_t a = crossing(t[order[0]], t[order[1]]);
    const std::uint32_t b = crossing(t[order[0]], t[order[2]]);
    const std::uint32_t c = crossing(t[order[0]], t[order[3]]);
    mesh_.triangles.push_back(outward ? simulator::Triangle{a, b, c}
                                      : simulator::Triangle{a, c, b});
  }

  void add_quad(const Tetrahedron& t, const std::array<std::size_t, 4>& order) {
    const std::uint32_t ac = crossing(t[order[0]], t[order[2]]);
    const std::uint32_t ad = crossing(t[order[0]], t[order[3]]);
    const std::uint32_t bd = crossing(t[order[1]], t[order[3]]);
    const std::uint32_t bc = crossing(t[order[1]], t[order[2]]);
    mesh_.triangles.push_back({ac, ad, bd});
    mesh_.triangles.push_back({ac, bd, bc});
  }

  /// The point where the field crosses zero between two corners; one of them lies in the other's
  /// bits.
  std::uint32_t crossing(Corner p, Corner q) {
    const Corner low = std::min(p, q);
    const Corner high = std::max(p, q);
    std::uint32_t& point = point_of_edge_[node_of(low) * 8 + static_cast<std::size_t>(low ^ high)];
    if (point == no_point) {
      const double share = values_[low] / (values_[low] - values_[high]);
      const Vec3 from = corner_mm(low);
      point = static_cast<std::uint32_t>(mesh_.points_mm.size());
      mesh_.points_mm.push_back(from + (corner_mm(high) - from) * share);
    }
    return point;
  }

  std::size_t node_of(Corner c) const {
    return field_.index(i_ + (c & 1), j_ + ((c >> 1) & 1), k_ + ((c >> 2) & 1));
  }
  Vec3 corner_mm(Corner c) const {
    return field_.point_mm(i_ + (c & 1), j_ + ((c >> 1) & 1), k_ + ((c >> 2) & 1));
  }

  const SampledField& field_;
  std::vector<std::uint32_t> point_of_edge_;
  std::array<double, 8> values_{};
  std::int32_t i_ = 0, j_ = 0, k_ = 0;
  simulator::IndexedMesh mesh_;
};

/// Away from zero, so that no crossing falls on a node and no triangle is empty.
double off_zero(double value, double spacing_mm) {
  const double least = 1e-4 * spacing_mm;
  if (std::abs(value) >= least) return value;
  return value < 0.0 ? -least : least;
}

struct Block {
  std::int32_t i = 0, j = 0, k = 0;              ///< first node
  std::int32_t i_end = 0, j_end = 0, k_end = 0;  ///< after the last
};

void sample_block(const Field& field, const Block& block, double steepest, SampledField& samples) {
  const Vec3 first = samples.point_mm(block.i, block.j, block.k);
  const Vec3 last = samples.point_mm(block.i_end - 1, block.j_end - 1, block.k_end - 1);
  const Vec3 half = (last - first) * 0.5;
  const double centre = field(first + half).value;
  // One spacing more than the block itself: the cubes between two blocks must not be skipped by
  // both.
  const double reach = length_of(half) + samples.spacing_mm;
  const bool is_far = std::abs(centre) > steepest * reach;
  for (std::int32_t k = block.k; k < block.k_end; ++k) {
    for (std::int32_t j = block.j; j < block.j_end; ++j) {
      for (std::int32_t i = block.i; i < block.i_end; ++i) {
        const double value = is_far ? centre : field(samples.point_mm(i, j, k)).value;
        samples.values[samples.index(i, j, k)] = off_zero(value, samples.spacing_mm);
      }
    }
  }
}

void close_box(SampledField& samples) {
  for (std::int32_t k = 0; k < samples.z_count; ++k) {
    for (std::int32_t j = 0; j < samples.y_count; ++j) {
      for (std::int32_t i = 0; i < samples.x_count; ++i) {
        const bool is_rim = i == 0 || j == 0 || k == 0 || i + 1 == samples.x_count ||
                            j + 1 == samples.y_count || k + 1 == samples.z_count;
        double& value = samples.values[samples.index(i, j, k)];
        if (is_rim && value < 0.0) value = samples.spacing_mm;
      }
    }
  }
}

}  // namespace

std::size_t SampledField::index(std::int32_t i, std::int32_t j, std::int32_t k) const noexcept {
  return (static_cast<std::size_t>(k) * static_cast<std::size_t>(y_count) +
          static_cast<std::size_t>(j)) *
             static_cast<std::size_t>(x_count) +
         static_cast<std::size_t>(i);
}

Vec3 SampledField::point_mm(std::int32_t i, std::int32_t j, std::int32_t k) const noexcept {
  return low_mm +
         spacing_mm * Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
}

SampledField sample_field(const Field& field, const SampleBox& box) {
  const Vec3 size = (box.high_mm - box.low_mm) / box.spacing_mm;
  SampledField samples;
  samples.low_mm = box.low_mm;
  samples.spacing_mm = box.spacing_mm;
  samples.x_count = static_cast<std::int32_t>(std::ceil(size.x)) + 1;
  samples.y_count = static_cast<std::int32_t>(std::ceil(size.y)) + 1;
  samples.z_count = static_cast<std::int32_t>(std::ceil(size.z)) + 1;
  samples.values.assign(samples.index(0, 0, samples.z_count), 0.0);
  for (std::int32_t k = 0; k < samples.z_count; k += block_nodes) {
    for (std::int32_t j = 0; j < samples.y_count; j += block_nodes) {
      for (std::int32_t i = 0; i < samples.x_count; i += block_nodes) {
        const Block block{i,
                          j,
                          k,
                          std::min(i + block_nodes, samples.x_count),
                          std::min(j + block_nodes, samples.y_count),
                          std::min(k + block_nodes, samples.z_count)};
        sample_block(field, block, box.steepest, samples);
      }
    }
  }
  close_box(samples);
  return samples;
}

simulator::IndexedMesh march_tetrahedra(const SampledField& field) {
  return Marcher(field).march();
}

}  // namespace hallux::scenarios
