#include "ui/render/noise_volume.h"

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

  /// Distance to the nearest over the distance to the next but one: 0 in a point, 1 halfway between two.
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

}  // namespace

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
