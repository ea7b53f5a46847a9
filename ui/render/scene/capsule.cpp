#include "ui/render/scene/capsule.h"

#include <cmath>

#include "simulator/base/units.h"

namespace hallux::ui {

namespace {

constexpr std::uint32_t segments = 40, rows_of_half = 10;

}  // namespace

CapsuleMesh capsule_mesh() {
  CapsuleMesh mesh;
  const auto add_row = [&](std::uint32_t row, double end) {
    const double up = 0.5 * pi * (static_cast<double>(row) / rows_of_half - (1.0 - end));
    for (std::uint32_t s = 0; s < segments; ++s) {
      const double around = 2.0 * pi * s / segments;
      const Vec3 way(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around),
                     std::sin(up));
      mesh.vertices.push_back({Float4(to_float(way), end)});
    }
  };
  for (std::uint32_t row = 0; row <= rows_of_half; ++row) add_row(row, 0.0);
  for (std::uint32_t row = 0; row <= rows_of_half; ++row) add_row(row, 1.0);
  for (std::uint32_t row = 0; row + 1 < 2 * (rows_of_half + 1); ++row) {
    for (std::uint32_t s = 0; s < segments; ++s) {
      const std::uint32_t next = (s + 1) % segments;
      const std::uint32_t a = row * segments + s, b = row * segments + next;
      const std::uint32_t c = a + segments, d = b + segments;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

}  // namespace hallux::ui
