// The thread is a band with four edges that runs along a helix and meets itself after a turn:
//
//          crest  __                 __
//      steep flank  \  slow flank      \            x: to the tip
//     ______________/ `~-._____________/ `~-.___
//      root
//
// It goes on for a turn beyond both ends, pressed flat against them: so the surface is closed
// whatever its pitch, and begins and ends in a circle. Core and crest are given along the axis: the
// crest sinks into the core below the head and at the tip.
#include "ui/render/scene/screw_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "simulator/base/units.h"

namespace hallux::ui {

namespace {

using simulator::IndexedMesh;
using simulator::Screw;

/// The band's edges: shares of the pitch and of the thread's height. Bone presses on the flank
/// towards the head: it is the steep one.
struct ThreadEdge {
  double pitch_share = 0.0, height_share = 0.0;
};
constexpr std::array<ThreadEdge, 5> thread_edges{
    {{0.0, 0.0}, {0.44, 0.0}, {0.52, 1.0}, {0.64, 1.0}, {1.0, 0.0}}};

constexpr std::uint32_t head_points = 48;
/// A finer thread has fewer segments in a turn, one with more turns ends.
constexpr double segments_at_most = 20.0, segments_at_least = 12.0, segments_of_thread = 540.0;
constexpr double turns_at_most = segments_of_thread / segments_at_least;
constexpr double edge_rad = 0.6;
/// A lower head is none.
constexpr double least_head_mm = 0.4;

double smooth_share(double low, double high, double at) {
  const double share = std::clamp((at - low) / (high - low), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

/// The screw's radii along its axis; the nose is what lies before the thread.
struct Outline {
  double core_mm = 0.0, crest_mm = 0.0, pitch_mm = 0.0;
  double nose_mm = 0.0, back_x_mm = 0.0, from_x_mm = 0.0;
  /// In a turn.
  std::uint32_t segments = 0;

  explicit Outline(const Screw& screw)
      : core_mm(0.5 * screw.shaft_diameter_mm),
        crest_mm(0.5 * screw.thread_diameter_mm),
        pitch_mm(screw.pitch_mm),
        nose_mm((screw.is_self_drilling ? 0.9 : 0.35) * screw.thread_diameter_mm),
        back_x_mm(-screw.length_mm),
        from_x_mm(std::max(back_x_mm, -nose_mm - turns_at_most * screw.pitch_mm)),
        segments(static_cast<std::uint32_t>(std::clamp(segments_of_thread / (turns() + 1.0),
                                                       segments_at_least, segments_at_most))) {}

  double turns() const { return (-nose_mm - from_x_mm) / pitch_mm; }

  double core_at(double x_mm) const {
    return core_mm * (1.0 - 0.38 * smooth_share(-nose_mm - 1.8 * core_mm, -nose_mm, x_mm));
  }
  double crest_at(double x_mm) const {
    const double sunk = std::max(smooth_share(-nose_mm - 2.2 * core_mm, -nose_mm, x_mm),
                                 1.0 - smooth_share(from_x_mm, from_x_mm + 0.8 * pitch_mm, x_mm));
    return crest_mm + (core_at(x_mm) - crest_mm) * sunk;
  }
  Vec3 around_x(double x_mm, double radius_mm, std::uint32_t segment) const {
    const double angle_rad = 2.0 * pi * (segment % segments) / segments;
    return {x_mm, radius_mm * std::cos(angle_rad), radius_mm * std::sin(angle_rad)};
  }
};

/// A point of the band, so many segments along the helix.
Vec3 thread_point(const Outline& outline, std::uint32_t segment, const ThreadEdge& edge) {
  const double turns = static_cast<double>(segment) / outline.segments - 1.0 + edge.pitch_share;
  const double x_mm =
      std::clamp(outline.from_x_mm + outline.pitch_mm * turns, outline.from_x_mm, -outline.nose_mm);
  const double core_mm = outline.core_at(x_mm), crest_mm = outline.crest_at(x_mm);
  return outline.around_x(x_mm, core_mm + (crest_mm - core_mm) * edge.height_share, segment);
}

void add_quad(IndexedMesh& mesh, const std::array<Vec3, 4>& corners_mm) {
  const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
  mesh.points_mm.insert(mesh.points_mm.end(), corners_mm.begin(), corners_mm.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

void add_thread(IndexedMesh& mesh, const Outline& outline) {
  const auto segments =
      static_cast<std::uint32_t>(std::ceil((outline.turns() + 1.0) * outline.segments));
  for (std::uint32_t segment = 0; segment < segments; ++segment) {
    for (std::size_t edge = 0; edge + 1 < thread_edges.size(); ++edge) {
      const auto at = [&](std::uint32_t along, std::size_t across) {
        return thread_point(outline, segment + along, thread_edges[edge + across]);
      };
      add_quad(mesh, {at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
    }
  }
}

/// The skin through circles of those places along the axis and radii, in order.
void add_circles(IndexedMesh& mesh, const Outline& outline, std::span<const Vec2> circles) {
  for (std::size_t i = 0; i + 1 < circles.size(); ++i) {
    for (std::uint32_t segment = 0; segment < outline.segments; ++segment) {
      const auto at = [&](std::size_t circle, std::uint32_t along) {
        return outline.around_x(circles[circle].x, circles[circle].y, segment + along);
      };
      add_quad(mesh, {at(i, 0), at(i, 1), at(i + 1, 1), at(i + 1, 0)});
    }
  }
}

IndexedMesh shaft_of(const Outline& outline, bool is_pointed) {
  IndexedMesh mesh;
  const double end_mm = outline.core_at(-outline.nose_mm);
  add_circles(mesh, outline,
              std::array{Vec2(outline.back_x_mm, 0.0), Vec2(outline.back_x_mm, outline.core_mm),
                         Vec2(outline.from_x_mm, outline.core_mm)});
  add_thread(mesh, outline);
  constexpr int steps = 5;
  std::vector<Vec2> nose;
  for (int step = 0; step <= steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    const double round = step == steps ? 0.0 : std::sqrt(1.0 - share * share);
    nose.emplace_back(-outline.nose_mm * (1.0 - share),
                      end_mm * (is_pointed ? 1.0 - share : round));
  }
  add_circles(mesh, outline, nose);
  return mesh;
}

/// From the hexagon's floor over the top and around to below the head.
void add_head(ToolBuilder& builder, const Screw& screw, const HexagonSize& hexagon) {
  const double top_mm = -screw.length_mm - screw.head_height_mm,
               rim_mm = screw.head_diameter_mm / 2;
  const double core_mm = 0.5 * screw.shaft_diameter_mm, height_mm = screw.head_height_mm;
  const std::vector<Vec2> inside = hexagon_mm(hexagon.across_mm, head_points);
  const std::vector<Vec2> mouth = hexagon_mm(1.12 * hexagon.across_mm, head_points);
  std::vector<ToolRing> rings{ring_around_x(top_mm + hexagon.depth_mm, inside, ToolMaterial::Grip),
                              ring_around_x(top_mm + 0.06 * screw.head_diameter_mm, inside),
                              ring_around_x(top_mm, mouth)};
  const auto add = [&](double height_share, double radius_mm) {
    rings.push_back(circle_around_x(top_mm + height_share * height_mm, radius_mm, head_points));
  };
  add(0.0, std::max(0.72 * rim_mm, 0.70 * hexagon.across_mm));
  add(0.06, 0.83 * rim_mm);
  add(0.17, 0.93 * rim_mm);
  add(0.32, 0.99 * rim_mm);
  add(0.42, rim_mm);
  add(0.52, rim_mm);
  add(0.60, 0.95 * rim_mm);
  add(1.0, std::max(1.05 * core_mm, 0.5 * rim_mm));
  builder.add_rings(rings, edge_rad);
}

}  // namespace

HexagonSize hexagon_of(const Screw& screw) noexcept {
  if (screw.head_height_mm < least_head_mm) return {};
  return {0.5 * screw.head_diameter_mm, 0.62 * screw.head_height_mm};
}

std::vector<Vec2> hexagon_mm(double across_mm, std::uint32_t count) {
  std::vector<Vec2> outline;
  const std::uint32_t side = count / 6;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto corner = [&](std::uint32_t number) {
      const double angle_rad = pi * number / 3.0;
      return across_mm / std::sqrt(3.0) * Vec2(std::cos(angle_rad), std::sin(angle_rad));
    };
    const double share = static_cast<double>(i % side) / side;
    outline.push_back(glm::mix(corner(i / side), corner(i / side + 1), share));
  }
  return outline;
}

void add_screw(ToolBuilder& builder, const Screw& screw) {
  const Outline outline(screw);
  builder.add_surface(shaft_of(outline, screw.is_self_drilling), ToolMaterial::Steel, edge_rad);
  const HexagonSize hexagon = hexagon_of(screw);
  if (hexagon.depth_mm > 0.0) add_head(builder, screw, hexagon);
}

ToolMesh screw_mesh(const Screw& screw) {
  ToolBuilder builder;
  add_screw(builder, screw);
  return builder.take();
}

}  // namespace hallux::ui
