// An arm is a rounded bar along a line in its plane, thick at the joint and thin at its point; the
// line is a smooth curve through a few stations (Catmull-Rom). A ring is a bar that closes.
#include "ui/render/scene/forceps_model.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::ui {

namespace {

/// Where the bar's line passes in the arm's plane, and half its section: across the line in that
/// plane, and out of it.
struct Station {
  Vec2 place_mm{0.0, 0.0};
  double half_across_mm = 1.0, half_out_mm = 1.0;
};

constexpr std::uint32_t ring_points = 16;

/// A section square to the line, between a circle and a rectangle.
ToolRing ring_across(const Vec2& place_mm, const Vec2& along, double half_across_mm,
                     double half_out_mm, double rise_mm) {
  ToolRing ring;
  const Vec3 across(-along.y, along.x, 0.0), out(0.0, 0.0, 1.0);
  for (std::uint32_t i = 0; i < ring_points; ++i) {
    const double angle_rad = 2.0 * pi * i / ring_points;
    const Vec2 round(std::cos(angle_rad), std::sin(angle_rad));
    const Vec2 at = glm::mix(round, round / std::max(std::abs(round.x), std::abs(round.y)), 0.35);
    ring.points_mm.push_back(Vec3(place_mm, rise_mm) + at.x * half_across_mm * across +
                             at.y * half_out_mm * out);
  }
  return ring;
}

double curved(const std::array<double, 4>& values, double share) {
  const auto [a, b, c, d] = values;
  return 0.5 * (2.0 * b + share * ((c - a) + share * ((2.0 * a - 5.0 * b + 4.0 * c - d) +
                                                      share * (3.0 * (b - c) + d - a))));
}

/// The bar through the stations, with steps between each two; it ends with the first and the last.
void add_bar(ToolBuilder& builder, std::span<const Station> stations, int steps, double rise_mm) {
  const auto last = static_cast<int>(stations.size()) - 1;
  const auto at = [&](int step) {
    const int from = std::min(step / steps, last - 1);
    const double share = static_cast<double>(step) / steps - from;
    const auto value = [&](auto&& of) {
      const auto of_station = [&](int number) {
        return of(stations[static_cast<std::size_t>(std::clamp(number, 0, last))]);
      };
      return curved(
          {of_station(from - 1), of_station(from), of_station(from + 1), of_station(from + 2)},
          share);
    };
    return Station{Vec2(value([](const Station& s) { return s.place_mm.x; }),
                        value([](const Station& s) { return s.place_mm.y; })),
                   std::max(value([](const Station& s) { return s.half_across_mm; }), 0.02),
                   std::max(value([](const Station& s) { return s.half_out_mm; }), 0.02)};
  };
  std::vector<ToolRing> rings;
  for (int step = 0; step <= last * steps; ++step) {
    const Station here = at(step);
    const Vec2 along = glm::normalize(at(std::min(step + 1, last * steps)).place_mm -
                                      at(std::max(step - 1, 0)).place_mm);
    rings.push_back(
        ring_across(here.place_mm, along, here.half_across_mm, here.half_out_mm, rise_mm));
  }
  builder.add_rings(rings, 0.9);
}

/// A finger ring about a place, wider along x.
void add_finger_ring(ToolBuilder& builder, const Vec2& middle_mm) {
  constexpr std::uint32_t around = 32, across = 12;
  const Vec2 half_mm(12.5, 9.5);
  constexpr double bar_mm = 2.2;
  simulator::IndexedMesh torus;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double angle_rad = 2.0 * pi * i / around;
    const Vec2 way(std::cos(angle_rad), std::sin(angle_rad));
    const Vec2 away = glm::normalize(way / half_mm);
    for (std::uint32_t j = 0; j < across; ++j) {
      const double turn_rad = 2.0 * pi * j / across;
      torus.points_mm.emplace_back(middle_mm + half_mm * way + bar_mm * std::cos(turn_rad) * away,
                                   1.2 * bar_mm * std::sin(turn_rad));
      const std::uint32_t a = i * across + j, b = i * across + (j + 1) % across;
      const std::uint32_t c = (i + 1) % around * across + j;
      const std::uint32_t d = (i + 1) % around * across + (j + 1) % across;
      torus.triangles.push_back({a, c, d});
      torus.triangles.push_back({a, d, b});
    }
  }
  builder.add_surface(torus, ToolMaterial::Steel, 0.9);
}

/// A round plate about the joint's axis.
void add_plate(ToolBuilder& builder, double from_z_mm, double to_z_mm, double radius_mm) {
  const double edge_mm = 0.3;
  const std::array<ProfilePoint, 6> profile{{{from_z_mm, 0.0, ToolMaterial::Steel},
                                             {from_z_mm, radius_mm - edge_mm, ToolMaterial::Steel},
                                             {from_z_mm + edge_mm, radius_mm, ToolMaterial::Steel},
                                             {to_z_mm - edge_mm, radius_mm, ToolMaterial::Steel},
                                             {to_z_mm, radius_mm - edge_mm, ToolMaterial::Steel},
                                             {to_z_mm, 0.0, ToolMaterial::Steel}}};
  builder.add_turned(profile, {});
}

}  // namespace

ToolMesh jaw_mesh() {
  constexpr std::array<Station, 9> stations{{{Vec2(-7.0, -2.2), 2.4, 1.9},
                                             {Vec2(0.0, 0.0), 3.3, 2.0},
                                             {Vec2(8.0, 4.2), 2.9, 2.0},
                                             {Vec2(18.0, 9.0), 2.4, 1.9},
                                             {Vec2(30.0, 11.6), 2.0, 1.7},
                                             {Vec2(39.5, 10.2), 1.7, 1.5},
                                             {Vec2(44.6, 6.0), 1.25, 1.15},
                                             {Vec2(46.1, 2.6), 0.75, 0.75},
                                             {Vec2(jaw_length_mm, 0.0), 0.06, 0.06}}};
  ToolBuilder builder;
  add_bar(builder, stations, 5, 0.0);
  add_plate(builder, -2.9, 2.9, 3.4);
  add_plate(builder, 2.8, 3.4, 1.7);
  return builder.take();
}

ToolMesh forceps_handle_mesh() {
  constexpr std::array<Station, 7> stations{{{Vec2(-4.0, -1.0), 2.6, 1.9},
                                             {Vec2(-9.0, -3.2), 2.5, 2.0},
                                             {Vec2(-24.0, -9.0), 2.3, 2.0},
                                             {Vec2(-50.0, -13.6), 2.1, 1.9},
                                             {Vec2(-78.0, -13.6), 2.0, 1.9},
                                             {Vec2(-94.0, -12.4), 2.0, 1.9},
                                             {Vec2(-98.0, -13.4), 1.4, 1.4}}};
  /// Half of the ratchet, towards the other handle.
  constexpr std::array<Station, 4> ratchet{{{Vec2(-88.0, -12.5), 1.9, 0.9},
                                            {Vec2(-88.4, -6.0), 1.8, 0.8},
                                            {Vec2(-88.0, 0.5), 1.6, 0.8},
                                            {Vec2(-87.6, 2.6), 0.9, 0.5}}};
  ToolBuilder builder;
  add_bar(builder, stations, 5, 0.0);
  add_bar(builder, ratchet, 4, 0.8);
  add_finger_ring(builder, Vec2(-forceps_handle_mm + 14.8, -17.6));
  return builder.take();
}

RigidTransform tool_from_arm(double opening_mm) noexcept {
  const double half_mm = 0.5 * std::clamp(opening_mm, 0.0, forceps_opening_most_mm);
  const double sine = half_mm / jaw_length_mm, cosine = std::sqrt(1.0 - sine * sine);
  // Half the angle's quaternion, without an angle.
  const double half_cosine = std::sqrt(0.5 * (1.0 + cosine));
  return {Quat(half_cosine, 0.0, 0.0, 0.5 * sine / half_cosine),
          Vec3(-jaw_length_mm * cosine, 0.0, 0.0)};
}

}  // namespace hallux::ui
