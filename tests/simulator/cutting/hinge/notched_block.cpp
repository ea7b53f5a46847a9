#include "tests/simulator/cutting/hinge/notched_block.h"

#include <array>
#include <cmath>

namespace hallux::tests {

using namespace simulator;

CutSolid notched_block(const Notch& notch) {
  const double climb = notch.rise * (notch.kink_z_mm + 7.0);
  // Counter-clockwise seen against y; the last three corners belong to the upper wall and lean with
  // y.
  const std::array<Vec2, 9> outline{Vec2(-10.0, -7.0),
                                    Vec2(-10.0, 7.0),
                                    Vec2(10.0, 7.0),
                                    Vec2(10.0, -7.0),
                                    Vec2(0.25 + climb, -7.0),
                                    Vec2(0.25, notch.kink_z_mm),
                                    Vec2(0.25, notch.tip_z_mm),
                                    Vec2(-0.25, notch.tip_z_mm),
                                    Vec2(-0.25, -7.0)};
  const std::array<Triangle, 7> cap{Triangle{0, 1, 7}, {0, 7, 8}, {1, 2, 7}, {2, 6, 7},
                                    {2, 5, 6},         {2, 4, 5}, {2, 3, 4}};
  CutSolid solid;
  for (const double y_mm : {-6.0, 6.0}) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const double lean_mm = i == 4 || i == 5 ? notch.dorsal_rise * y_mm : 0.0;
      solid.mesh.points_mm.emplace_back(outline[i].x + lean_mm, y_mm, outline[i].y);
    }
  }
  const auto count = static_cast<std::uint32_t>(outline.size());
  const auto add = [&](const Triangle& triangle, const FaceSource& source) {
    solid.mesh.triangles.push_back(triangle);
    solid.sources.push_back(source);
  };
  for (const auto& [a, b, c] : cap) {
    add({a, c, b}, {});
    add({count + a, count + b, count + c}, {});
  }
  const auto wall_of = [](std::uint32_t side) -> FaceSource {
    if (side == 4) return {1, 1};
    if (side == 5) return {0, 1};
    if (side == 6) return {0, 0};
    if (side == 7) return {0, -1};
    return {};
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    add({i, j, count + j}, wall_of(i));
    add({i, count + j, count + i}, wall_of(i));
  }
  return solid;
}

KerfPlane notch_plane(bool looks_distal) {
  const Vec3 tooth_line(0.0, looks_distal ? 1.0 : -1.0, 0.0);
  // z = feed x tooth line: (0,0,1) x (0,-1,0) = +x.
  return {{rotation_from_axes(Vec3(0.0, 0.0, 1.0), -tooth_line), Vec3(0.0, 0.0, -7.0)}, 0.5};
}

KerfPlane upper_plane(const Notch& notch) {
  const Vec3 along_rise(notch.rise, 0.0, -1.0), along_y(notch.dorsal_rise, 1.0, 0.0);
  const Vec3 normal =
      glm::cross(along_rise, along_y) /
      std::sqrt(glm::dot(glm::cross(along_rise, along_y), glm::cross(along_rise, along_y)));
  const Vec3 distal = normal.x > 0.0 ? normal : -normal;
  const Vec3 on_wall(0.25, 0.0, notch.kink_z_mm);
  const Vec3 feed = -along_rise / std::sqrt(glm::dot(along_rise, along_rise));
  return {{rotation_from_axes(feed, glm::cross(distal, feed)), on_wall - 0.25 * distal}, 0.5};
}

HingeLine notch_hinge() {
  return {Vec3(0.0, 0.0, 6.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0), 1.0};
}

}  // namespace hallux::tests
