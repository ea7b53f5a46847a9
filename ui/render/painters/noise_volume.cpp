// One block of noise, the same each time: clouds are three octaves on a lattice, pores come from
// the distances to scattered points, one in each cell. All lattices are periodic with the block, so
// that it can be repeated without a seam.
#include "ui/render/painters/noise_volume.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/base/check.h"
#include "simulator/base/random.h"
#include "simulator/base/vector.h"

namespace hallux::ui {

namespace {

/// Values on a periodic lattice, smooth between its nodes.
class ValueNoise {
 public:
  ValueNoise(std::uint32_t cells, std::uint64_t seed)
      : cells_(cells), values_(cells * cells * cells) {
    Random random(seed);
    for (double& value : values_) value = random.uniform();
  }

  /// At a place in [0, 1)^3.
  double at(const Vec3& place) const {
    const Vec3 scaled = place * static_cast<double>(cells_);
    const std::array<std::uint32_t, 3> node{static_cast<std::uint32_t>(scaled.x),
                                            static_cast<std::uint32_t>(scaled.y),
                                            static_cast<std::uint32_t>(scaled.z)};
    const auto smooth = [](double share) { return share * share * (3.0 - 2.0 * share); };
    const double x = smooth(scaled.x - node[0]), y = smooth(scaled.y - node[1]),
                 z = smooth(scaled.z - node[2]);
    double sum = 0.0;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
      const std::uint32_t i = corner & 1U, j = (corner >> 1U) & 1U, k = corner >> 2U;
      const double weight =
          (i == 1 ? x : 1.0 - x) * (j == 1 ? y : 1.0 - y) * (k == 1 ? z : 1.0 - z);
      sum += weight * value(node[0] + i, node[1] + j, node[2] + k);
    }
    return sum;
  }

 private:
  double value(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return values_[((z % cells_) * cells_ + y % cells_) * cells_ + x % cells_];
  }

  std::uint32_t cells_;
  std::vector<double> values_;
};

/// One point a cell of a periodic lattice.
class ScatteredPoints {
 public:
  ScatteredPoints(std::uint32_t cells, std::uint64_t seed)
      : cells_(static_cast<int>(cells)), points_(cells * cells * cells) {
    Random random(seed);
    for (Vec3& point : points_) {
      point = Vec3(random.uniform(), random.uniform(), random.uniform());
    }
  }

  /// Distance to the nearest over the distance to the next but one: 0 in a point, 1 halfway between
  /// two.
  double at(const Vec3& place) const {
    const Vec3 scaled = place * static_cast<double>(cells_);
    const Vec3 cell = glm::floor(scaled);
    double nearest = 1e9, next = 1e9;
    for (int k = -1; k <= 1; ++k) {
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          const Vec3 other = cell + Vec3(i, j, k);
          const double distance = glm::length(other + point_of(other) - scaled);
          next = std::min(next, std::max(nearest, distance));
          nearest = std::min(nearest, distance);
        }
      }
    }
    return nearest / next;
  }

 private:
  const Vec3& point_of(const Vec3& cell) const {
    const auto wrapped = [&](double value) {
      return static_cast<std::size_t>((static_cast<int>(value) + cells_) % cells_);
    };
    const auto side = static_cast<std::size_t>(cells_);
    return points_[(wrapped(cell.z) * side + wrapped(cell.y)) * side + wrapped(cell.x)];
  }

  int cells_;
  std::vector<Vec3> points_;
};

std::uint8_t byte_of(double share) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

class Clouds {
 public:
  explicit Clouds(std::uint64_t seed)
      : octaves_{ValueNoise(4, seed), ValueNoise(8, seed + 1), ValueNoise(16, seed + 2)} {}

  /// Spread so that most of [0, 1] is used.
  double at(const Vec3& place) const {
    const double mean =
        0.55 * octaves_[0].at(place) + 0.30 * octaves_[1].at(place) + 0.15 * octaves_[2].at(place);
    return 0.5 + 1.5 * (mean - 0.5);
  }

 private:
  std::array<ValueNoise, 3> octaves_;
};

double smooth_step(double low, double high, double value) {
  const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

struct SkinCell {
  double height_mm = 0.0, shade = 1.0;
};

/// Pores are small, and rare: where the clouds are thick.
SkinCell skin_cell(const std::uint8_t* rgba) {
  const double red = rgba[0] / 255.0, scattered = rgba[1] / 255.0, blue = rgba[2] / 255.0;
  const double pore = (1.0 - smooth_step(0.06, 0.24, scattered)) * smooth_step(0.34, 0.66, blue);
  return {0.075 * red + 0.05 * blue - 0.022 * pore, (0.85 + 0.15 * red) * (1.0 - 0.36 * pore)};
}

/// Slopes of the heights at a cell, over the block's side.
Vec3 slope_at(const std::vector<SkinCell>& cells, std::uint32_t side,
              const std::array<std::uint32_t, 3>& at) {
  const auto height = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return cells[((z % side) * side + y % side) * side + x % side].height_mm;
  };
  const auto [x, y, z] = at;
  const double over = 0.5 * side;
  return over * Vec3(height(x + 1, y, z) - height(x + side - 1, y, z),
                     height(x, y + 1, z) - height(x, y + side - 1, z),
                     height(x, y, z + 1) - height(x, y, z + side - 1));
}

}  // namespace

ReliefVolume make_relief(const NoiseVolume& noise) {
  const std::uint32_t side = noise.side;
  std::vector<SkinCell> cells;
  for (std::size_t i = 0; i < noise.rgba.size(); i += 4) cells.push_back(skin_cell(&noise.rgba[i]));
  std::vector<Vec3> slopes;
  double steepest = 0.0;
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    slopes.push_back(slope_at(cells, side, {i % side, i / side % side, i / (side * side)}));
    const Vec3 size = glm::abs(slopes.back());
    steepest = std::max({steepest, size.x, size.y, size.z});
  }
  ReliefVolume relief{{side, {}}, 2.0 * steepest};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Vec3 share = Vec3(0.5) + slopes[i] / relief.slope_scale;
    relief.volume.rgba.insert(
        relief.volume.rgba.end(),
        {byte_of(share.x), byte_of(share.y), byte_of(share.z), byte_of(cells[i].shade)});
  }
  return relief;
}

NoiseVolume make_noise(std::uint32_t side) {
  CHECK(side >= 32 && (side & (side - 1)) == 0);
  const Clouds red(11), blue(23);
  const ScatteredPoints pores(8, 37);
  const ValueNoise grain(side / 2, 53);
  NoiseVolume noise{side, {}};
  noise.rgba.reserve(4UL * side * side * side);
  for (std::uint32_t z = 0; z < side; ++z) {
    for (std::uint32_t y = 0; y < side; ++y) {
      for (std::uint32_t x = 0; x < side; ++x) {
        const Vec3 place = Vec3(x, y, z) / static_cast<double>(side);
        noise.rgba.insert(noise.rgba.end(), {byte_of(red.at(place)), byte_of(pores.at(place)),
                                             byte_of(blue.at(place)), byte_of(grain.at(place))});
      }
    }
  }
  return noise;
}

}  // namespace hallux::ui
