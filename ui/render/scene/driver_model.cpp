// One body for three drivers, each with a chuck of its own. What is held is as the simulator has
// it, what holds it is of one size.
//
// The facets of a trocar point are planes: a section across it is the wire's circle cut by three
// lines, which move outwards from the tip on. The rings' points lie where circle and lines meet, so
// the facets' edges are true. A bit's section turns along it; its flutes run out before the shank.
#include "ui/render/scene/driver_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "simulator/base/units.h"
#include "ui/render/scene/screw_model.h"

namespace hallux::ui {

namespace {

using simulator::Drill;
using simulator::DrillBit;
using simulator::Screw;
using simulator::Screwdriver;
using simulator::Tool;
using simulator::Wire;
using simulator::WireDriver;

/// Between a screw's head and the chuck.
constexpr double screw_shaft_mm = 42.0;

Vec2 polar(double radius_mm, double angle_rad) {
  return radius_mm * Vec2(std::cos(angle_rad), std::sin(angle_rad));
}

constexpr int facets = 3, points_on_line = 2, points_on_arc = 12;

/// A section through a trocar point: the facets stand this share of the radius from the axis.
ToolRing trocar_ring(double x_mm, double radius_mm, double line_share) {
  const double line_mm = line_share * radius_mm;
  const double end_rad = line_share <= 0.5 ? pi / 3.0 : std::acos(std::min(line_share, 1.0));
  std::vector<Vec2> outline;
  for (int facet = 0; facet < facets; ++facet) {
    const double middle_rad = 2.0 * pi * facet / facets;
    for (int i = 0; i < points_on_line; ++i) {
      const double angle_rad = end_rad * (2.0 * i / points_on_line - 1.0);
      outline.push_back(polar(line_mm / std::cos(angle_rad), middle_rad + angle_rad));
    }
    const double arc_mm = std::min(radius_mm, line_mm / std::cos(end_rad));
    const double arc_rad = 2.0 * pi / facets - 2.0 * end_rad;
    for (int i = 0; i < points_on_arc; ++i) {
      outline.push_back(polar(arc_mm, middle_rad + end_rad + arc_rad * i / points_on_arc));
    }
  }
  return ring_around_x(x_mm, outline);
}

/// As pliers leave it.
ToolRing pinched(ToolRing ring, double y_share, double z_share) {
  for (Vec3& point_mm : ring.points_mm) point_mm *= Vec3(1.0, y_share, z_share);
  return ring;
}

void add_wire(ToolBuilder& builder, const Wire& wire, double back_x_mm) {
  const double radius_mm = 0.5 * wire.diameter_mm;
  const auto whole = [&](double x_mm) { return trocar_ring(x_mm, radius_mm, 1.0); };
  std::vector<ToolRing> rings{pinched(whole(back_x_mm), 0.95, 0.35),
                              pinched(whole(back_x_mm + 0.35 * wire.diameter_mm), 1.0, 0.75),
                              whole(back_x_mm + 0.7 * wire.diameter_mm)};
  for (const double share : {1.0, 0.985, 0.95, 0.89, 0.81, 0.72, 0.62, 0.55, 0.5, 0.0})
    rings.push_back(trocar_ring(-share * wire.point_mm, radius_mm, share));
  // A facet leans so little that its edge to the cylinder is told by its points, not by its angle.
  std::vector<int> surfaces;
  constexpr int of_facet = points_on_line + points_on_arc;
  surfaces.reserve(std::size_t{facets} * of_facet);
  for (int i = 0; i < facets * of_facet; ++i)
    surfaces.push_back(i % of_facet < points_on_line ? 1 : 0);
  builder.add_rings(rings, 0.5, surfaces);
}

constexpr int land_points = 5, flute_points = 9;
constexpr double land_rad = 1.40, web_share = 0.30;

/// A bit's section by its points' angles and radii as shares of the bit's: land, flute, land,
/// flute. Of the flute only that share of its depth.
std::vector<Vec2> bit_section(double depth_share) {
  std::vector<Vec2> section;
  for (const double from_rad : {0.0, pi}) {
    for (int i = 0; i < land_points; ++i)
      section.emplace_back(from_rad + land_rad * i / land_points, 1.0);
    for (int i = 0; i < flute_points; ++i) {
      const double share = static_cast<double>(i) / flute_points;
      const double off = 2.0 * share - 1.0;
      section.emplace_back(from_rad + land_rad + (pi - land_rad) * share,
                           1.0 - depth_share * (1.0 - web_share) * (1.0 - off * off));
    }
  }
  return section;
}

/// Where a bit's flutes begin, and their way in a turn: the helix leans by 30 degrees.
struct Flutes {
  double from_x_mm = 0.0, run_out_mm = 0.0, lead_mm = 0.0;

  explicit Flutes(const DrillBit& bit)
      : from_x_mm(-std::min(0.62 * bit.length_mm, 14.0 * bit.diameter_mm)),
        run_out_mm(1.6 * bit.diameter_mm),
        lead_mm(pi * bit.diameter_mm * std::sqrt(3.0)) {}

  ToolRing ring_at(double x_mm, double radius_mm, double most_mm) const {
    const double share = std::clamp((x_mm - from_x_mm) / run_out_mm, 0.0, 1.0);
    const double turned_rad = 2.0 * pi * std::max(x_mm, from_x_mm) / lead_mm;
    std::vector<Vec2> outline;
    for (const Vec2& point : bit_section(share * (2.0 - share)))
      outline.push_back(polar(std::min(radius_mm * point.y, most_mm), turned_rad + point.x));
    return ring_around_x(x_mm, outline);
  }
};

void add_bit(ToolBuilder& builder, const DrillBit& bit, double back_x_mm) {
  const Flutes flutes(bit);
  const double radius_mm = 0.5 * bit.diameter_mm;
  const auto ring_at = [&](double x_mm) { return flutes.ring_at(x_mm, radius_mm, radius_mm); };
  std::vector<ToolRing> rings{ring_at(back_x_mm)};
  const double step_mm = flutes.lead_mm / 24.0;
  const int steps = std::max(1, static_cast<int>((-bit.point_mm - flutes.from_x_mm) / step_mm));
  for (int step = 0; step <= steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    rings.push_back(ring_at(flutes.from_x_mm + share * (-bit.point_mm - flutes.from_x_mm)));
  }
  if (bit.point_mm > 0.0) {
    for (const double share : {0.8, 0.6, 0.42, 0.28, 0.14, 0.0})
      rings.push_back(flutes.ring_at(-share * bit.point_mm, radius_mm, share * radius_mm));
  }
  builder.add_rings(rings, 0.8);
}

/// The shaft of a screwdriver: its hexagon stands in the screw's.
void add_screw_shaft(ToolBuilder& builder, const Screw& screw, double back_x_mm) {
  constexpr std::uint32_t count = 24;
  const HexagonSize hexagon = hexagon_of(screw);
  const double head_x_mm = -screw.length_mm - screw.head_height_mm;
  const double across_mm =
      hexagon.depth_mm > 0.0 ? 0.97 * hexagon.across_mm : 0.6 * screw.shaft_diameter_mm;
  const double shaft_mm = std::max(1.75, 0.75 * across_mm);
  const std::vector<Vec2> outline = hexagon_mm(across_mm, count);
  const auto circle = [&](double x_mm, double radius_mm) {
    return circle_around_x(x_mm, radius_mm, count);
  };
  builder.add_rings(std::array{circle(back_x_mm, shaft_mm), circle(head_x_mm - 24.0, shaft_mm),
                               circle(head_x_mm - 22.0, std::max(1.35, 0.62 * across_mm)),
                               circle(head_x_mm - 6.0, std::max(1.35, 0.62 * across_mm)),
                               ring_around_x(head_x_mm - 4.6, outline),
                               ring_around_x(head_x_mm + 0.9 * hexagon.depth_mm, outline)});
}

/// A chuck's outline from back to mouth, which lies at 0; a knurled part has a jagged section.
struct ChuckPoint {
  double x_mm = 0.0, radius_mm = 0.0;
  bool is_knurled = false;
  ToolMaterial material = ToolMaterial::Steel;
};

constexpr std::array<ChuckPoint, 12> drill_chuck{{{-24.0, 5.4},
                                                  {-23.5, 5.9},
                                                  {-19.4, 6.0, false, ToolMaterial::Band},
                                                  {-19.0, 5.5, false, ToolMaterial::Band},
                                                  {-18.2, 5.5},
                                                  {-17.8, 6.1, true},
                                                  {-17.3, 6.6, true},
                                                  {-9.0, 6.6, true},
                                                  {-8.5, 6.1, true},
                                                  {-7.6, 5.8},
                                                  {-1.4, 3.3},
                                                  {0.0, 2.9}}};
constexpr std::array<ChuckPoint, 12> wire_collet{{{-26.0, 5.2},
                                                  {-25.5, 5.7},
                                                  {-24.6, 5.7, true},
                                                  {-24.1, 6.1, true},
                                                  {-16.4, 6.1, true},
                                                  {-15.9, 5.6, true},
                                                  {-15.0, 5.4, false, ToolMaterial::Band},
                                                  {-14.2, 5.0},
                                                  {-11.0, 4.2},
                                                  {-4.0, 2.9},
                                                  {-0.7, 2.5},
                                                  {0.0, 2.1}}};
constexpr std::array<ChuckPoint, 12> screw_coupling{{{-20.0, 4.6},
                                                     {-19.5, 5.0},
                                                     {-17.2, 5.0},
                                                     {-16.8, 4.6, false, ToolMaterial::Band},
                                                     {-16.0, 4.6},
                                                     {-15.6, 5.2, true},
                                                     {-15.1, 5.5, true},
                                                     {-9.6, 5.5, true},
                                                     {-9.1, 5.2, true},
                                                     {-8.6, 4.4},
                                                     {-0.8, 4.0},
                                                     {0.0, 3.4}}};

const std::array<ChuckPoint, 12>& chuck_of(const Tool& tool) noexcept {
  if (std::holds_alternative<WireDriver>(tool)) return wire_collet;
  return std::holds_alternative<Drill>(tool) ? drill_chuck : screw_coupling;
}

ToolRing chuck_ring(const ChuckPoint& point, double mouth_x_mm) {
  constexpr std::uint32_t count = 64;
  constexpr double knurl_mm = 0.30;
  ToolRing ring = circle_around_x(mouth_x_mm + point.x_mm, point.radius_mm, count, point.material);
  if (!point.is_knurled) return ring;
  for (std::uint32_t i = 1; i < count; i += 2) {
    const double share = 1.0 - knurl_mm / point.radius_mm;
    ring.points_mm[i] *= Vec3(1.0, share, share);
  }
  return ring;
}

/// Three jaws that stand out of a chuck around a bit.
void add_jaws(ToolBuilder& builder, double mouth_x_mm, double held_mm) {
  constexpr int count = 36, lobe = count / facets;
  const auto ring_at = [&](double x_mm, double outside_mm) {
    std::vector<Vec2> outline;
    for (int i = 0; i < count; ++i) {
      const bool is_jaw = i % lobe < 8;
      outline.push_back(polar(is_jaw ? outside_mm : held_mm + 0.05, 2.0 * pi * i / count));
    }
    return ring_around_x(mouth_x_mm + x_mm, outline);
  };
  builder.add_rings(std::array{ring_at(-1.0, held_mm + 1.1), ring_at(1.0, held_mm + 0.95),
                               ring_at(2.0, held_mm + 0.45)});
}

/// A wire driver's lever, which closes the collet.
void add_lever(ToolBuilder& builder, double back_x_mm) {
  struct Station {
    double x_mm, z_mm, half_y_mm, half_z_mm;
  };
  constexpr std::array<Station, 9> stations{{{-84.0, -14.6, 1.2, 0.5},
                                             {-83.0, -14.7, 2.6, 1.0},
                                             {-78.0, -15.2, 3.4, 1.2},
                                             {-60.0, -15.9, 3.6, 1.2},
                                             {-38.0, -15.4, 3.5, 1.2},
                                             {-18.0, -13.2, 3.3, 1.2},
                                             {-8.0, -10.2, 3.0, 1.3},
                                             {-2.5, -6.4, 2.6, 1.6},
                                             {-1.0, -3.0, 2.2, 1.6}}};
  constexpr int count = 16;
  std::vector<ToolRing> rings;
  for (const Station& station : stations) {
    ToolRing ring;
    for (int i = 0; i < count; ++i) {
      const Vec2 round = polar(1.0, 2.0 * pi * i / count);
      // Between a circle and a rectangle.
      const double most = std::max(std::abs(round.x), std::abs(round.y));
      const Vec2 at = glm::mix(round, round / most, 0.55);
      ring.points_mm.emplace_back(back_x_mm + station.x_mm, at.x * station.half_y_mm,
                                  station.z_mm + at.y * station.half_z_mm);
    }
    rings.push_back(std::move(ring));
  }
  builder.add_rings(rings, 0.7);
}

double held_length_mm(const Tool& tool) noexcept {
  if (const auto* driver = std::get_if<WireDriver>(&tool)) return driver->wire.length_mm;
  if (const auto* drill = std::get_if<Drill>(&tool)) return drill->bit.length_mm;
  const auto* screwdriver = std::get_if<Screwdriver>(&tool);
  if (screwdriver == nullptr) return 0.0;
  return screwdriver->screw.length_mm + screwdriver->screw.head_height_mm + screw_shaft_mm;
}

}  // namespace

ToolMesh wire_mesh(const Wire& wire) {
  ToolBuilder builder;
  add_wire(builder, wire, -wire.length_mm);
  return builder.take();
}

ToolMesh held_mesh(const Tool& tool) {
  ToolBuilder builder;
  const double back_x_mm = chuck_x_mm(tool) - held_in_chuck_mm;
  if (const auto* driver = std::get_if<WireDriver>(&tool))
    add_wire(builder, driver->wire, back_x_mm);
  if (const auto* drill = std::get_if<Drill>(&tool)) add_bit(builder, drill->bit, back_x_mm);
  if (const auto* screwdriver = std::get_if<Screwdriver>(&tool)) {
    add_screw(builder, screwdriver->screw);
    add_screw_shaft(builder, screwdriver->screw, back_x_mm);
  }
  return builder.take();
}

ToolMesh blur_mesh(const Tool& tool) {
  ToolBuilder builder;
  const auto* drill = std::get_if<Drill>(&tool);
  if (drill == nullptr) return builder.take();
  constexpr std::uint32_t count = 24;
  const double radius_mm = 0.515 * drill->bit.diameter_mm;
  builder.add_rings(std::array{circle_around_x(Flutes(drill->bit).from_x_mm, radius_mm, count),
                               circle_around_x(-drill->bit.point_mm, radius_mm, count),
                               circle_around_x(0.01, 0.02, count)});
  return builder.take();
}

ToolMesh chuck_mesh(const Tool& tool) {
  ToolBuilder builder;
  std::vector<ToolRing> rings;
  for (const ChuckPoint& point : chuck_of(tool))
    rings.push_back(chuck_ring(point, chuck_x_mm(tool)));
  builder.add_rings(rings, 0.5);
  if (std::holds_alternative<Drill>(tool))
    add_jaws(builder, chuck_x_mm(tool), held_radius_mm(tool));
  return builder.take();
}

ToolMesh driver_body_mesh(const Tool& tool) {
  constexpr auto steel = ToolMaterial::Steel;
  constexpr auto grip = ToolMaterial::Grip;
  constexpr auto band = ToolMaterial::Band;
  // `along` counts from the chuck's back.
  constexpr double cable_mm = driver_length_mm - 26.0;
  constexpr std::array<ProfilePoint, 26> body{
      {{-0.4, 0.0, steel},    {-0.4, 4.9, steel},   {0.4, 5.3, steel},  {6.0, 5.6, steel},
       {8.0, 6.3, steel},     {9.2, 6.5, steel},    {10.4, 6.5, band},  {10.8, 6.0, grip},
       {11.4, 6.0, grip},     {12.4, 7.0, grip},    {20.0, 7.9, grip},  {34.0, 8.3, grip},
       {48.0, 8.0, grip},     {57.0, 8.0, grip},    {57.6, 7.5, band},  {59.4, 7.5, band},
       {60.0, 8.1, grip},     {79.0, 8.8, grip},    {97.0, 9.0, grip},  {105.0, 8.2, grip},
       {108.0, 6.9, steel},   {112.0, 6.3, steel},  {113.0, 4.2, grip}, {119.0, 3.0, grip},
       {cable_mm, 3.0, grip}, {cable_mm, 0.0, grip}}};
  const double back_x_mm = chuck_x_mm(tool) + chuck_of(tool).front().x_mm;
  const Quat along_handle = rotation_from_axes(Vec3(0.0, 0.0, 1.0), Vec3(0.0, 1.0, 0.0));
  ToolBuilder builder;
  builder.add_turned(body, {along_handle, Vec3(back_x_mm, 0.0, 0.0)});
  if (std::holds_alternative<WireDriver>(tool)) add_lever(builder, back_x_mm);
  return builder.take();
}

double chuck_x_mm(const Tool& tool) noexcept { return -held_length_mm(tool); }

double held_radius_mm(const Tool& tool) noexcept {
  if (const auto* driver = std::get_if<WireDriver>(&tool)) return 0.5 * driver->wire.diameter_mm;
  if (const auto* drill = std::get_if<Drill>(&tool)) return 0.5 * drill->bit.diameter_mm;
  const auto* screwdriver = std::get_if<Screwdriver>(&tool);
  if (screwdriver == nullptr) return 0.0;
  return 0.5 * std::max(screwdriver->screw.head_diameter_mm, screwdriver->screw.thread_diameter_mm);
}

}  // namespace hallux::ui
