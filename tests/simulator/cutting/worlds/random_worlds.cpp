#include "tests/simulator/cutting/worlds/random_worlds.h"

#include <cmath>

#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/simulator/cutting/worlds/outlines.h"
#include "tests/support/worlds.h"

namespace hallux::tests {

using namespace simulator;

namespace {

constexpr double quarter_mm = 0.25;

IndexedMesh with_void(IndexedMesh outer, const IndexedMesh& hollow) {
  append_mesh(outer, inside_out(hollow));
  return outer;
}

/// A shear that bends: orientation and closedness stay.
void bend(IndexedMesh& mesh, const Vec3& slope) {
  for (Vec3& point_mm : mesh.points_mm) {
    point_mm.y += slope.x * point_mm.x + 0.002 * slope.y * point_mm.x * point_mm.x;
    point_mm.z += slope.z * point_mm.x;
  }
}

/// A square field around the plane's origin.
FieldGrid field_around(double reach_mm, double spacing_mm) {
  const auto count = static_cast<std::int32_t>(2.0 * reach_mm / spacing_mm) + 1;
  return {
      .origin_mm = Vec2(-reach_mm), .spacing_mm = spacing_mm, .u_count = count, .v_count = count};
}

}  // namespace

Vec3 random_direction(Random& random) {
  Vec3 direction(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
  const double length = std::sqrt(glm::dot(direction, direction));
  return length > 0.1 ? direction / length : Vec3(0.0, 0.6, 0.8);
}

IndexedMesh random_bone(Random& random) {
  IndexedMesh mesh;
  switch (random.bits() % 6) {
    case 0:
    case 1:
      mesh = hollow_tube({.segments = 24, .rings = 1 + random.bits() % 12});
      break;
    case 2:
      mesh = with_void(sphere(9.0, 3 + random.bits() % 10), sphere(6.0, 2 + random.bits() % 6));
      break;
    case 3:
      mesh = sphere(9.0, 3 + random.bits() % 10);
      break;
    case 4:
      mesh = u_shape(Vec3(30.0, 20.0, 8.0), 6.0);
      break;
    default:
      mesh = solid_block(Vec3(25.0, 12.0, 10.0));
      break;
  }
  bend(mesh, 0.1 * random_direction(random));
  return mesh;
}

KerfPlane random_plane(Random& random) {
  const Vec3 point_mm(random.uniform(-8.0, 8.0), random.uniform(-4.0, 4.0),
                      random.uniform(-3.0, 3.0));
  return plane_through(point_mm, random_direction(random), random.uniform(0.2, 1.2),
                       random_direction(random));
}

double random_multiple(Random& random, int reach, double step) {
  const auto count = 2 * static_cast<std::uint64_t>(reach) + 1;
  return step * (static_cast<double>(random.bits() % count) - reach);
}

IndexedMesh lattice_bone(Random& random) {
  switch (random.bits() % 3) {
    case 0:
      return solid_block(Vec3(4.0, 3.0, 2.0));
    case 1:
      return u_shape(Vec3(5.0, 4.0, 2.0), 1.0);
    default:
      return with_void(solid_block(Vec3(4.0, 4.0, 3.0)), solid_block(Vec3(2.0, 2.0, 1.0)));
  }
}

KerfPlane lattice_plane(Random& random) {
  if (random.bits() % 3 != 0) {
    return axis_plane(random.bits() % 3, random_multiple(random, 6, quarter_mm), 0.5);
  }
  const Vec3 point_mm(random_multiple(random, 4, quarter_mm),
                      random_multiple(random, 4, quarter_mm),
                      random_multiple(random, 3, quarter_mm));
  Vec3 normal(random_multiple(random, 1, 1.0), random_multiple(random, 1, 1.0), 1.0);
  return plane_through(point_mm, normal, 0.5, Vec3(1.0, 0.0, -normal.x));
}

StrokedRegion::StrokedRegion(Random& random, double reach_mm, std::int32_t frame_count)
    : random_(random),
      field_(field_around(reach_mm + 8.0, random.uniform(0.1, 0.4))),
      frame_count_(frame_count) {
  blade_ = {.width_mm = random.uniform(3.0, 2.0 * reach_mm),
            .depth_mm = random.uniform(0.5 * reach_mm, 3.0 * reach_mm)};
  const double turn = random.uniform(-3.2, 3.2);
  feed_ = Vec2(std::cos(turn), std::sin(turn));
  const double aside_mm = random.uniform(-0.3, 0.3) * reach_mm;
  start_mm_ = -random.uniform(0.5, 1.0) * reach_mm * feed_ + aside_mm * Vec2(-feed_.y, feed_.x);
  way_mm_ = random.uniform(0.6, 2.6) * reach_mm;
  last_ = pose_at(0);
}

PlanarPose StrokedRegion::pose_at(std::int32_t frame) {
  const double way_mm = way_mm_ * frame / frame_count_;
  const double turn = random_.uniform(-0.1, 0.1);
  const Vec2 aside(-feed_.y, feed_.x);
  const double length = std::sqrt(1.0 + turn * turn);
  return {start_mm_ + way_mm * feed_ + random_.uniform(-1.0, 1.0) * aside,
          (feed_ + turn * aside) / length};
}

RegionOutline StrokedRegion::next() {
  const PlanarPose pose = pose_at(++frame_);
  FieldWindow changed;
  field_.stamp(blade_, last_, pose, changed);
  last_ = pose;
  return outline_of(field_);
}

LatticeRegion::LatticeRegion(Random& random) : shape_(random.bits() % 4) {
  middle_mm_ = Vec2(random_multiple(random, 6, quarter_mm), random_multiple(random, 6, quarter_mm));
  half_mm_ = quarter_mm * Vec2(static_cast<double>(4 + random.bits() % 10),
                               static_cast<double>(4 + random.bits() % 10));
}

RegionOutline LatticeRegion::next() {
  grown_mm_ += quarter_mm;
  const Vec2 outer_mm = half_mm_ + Vec2(grown_mm_);
  const LoopCorners outer = rectangle_loop(middle_mm_ - outer_mm, middle_mm_ + outer_mm);
  switch (shape_) {
    case 0:
      return outline_from({outer});
    case 1:
      return outline_from({diamond_loop(middle_mm_, outer_mm.x)});
    case 2: {
      const Vec2 hole_mm = glm::max(half_mm_ - Vec2(grown_mm_), Vec2(0.0));
      if (hole_mm.x == 0.0 || hole_mm.y == 0.0) return outline_from({outer});
      return outline_from(
          {outer, turned_back(rectangle_loop(middle_mm_ - hole_mm, middle_mm_ + hole_mm))});
    }
    default: {
      const Vec2 aside_mm(2.0 * half_mm_.x + 3.0, 0.0);
      return outline_from({outer, rectangle_loop(middle_mm_ + aside_mm - half_mm_,
                                                 middle_mm_ + aside_mm + half_mm_)});
    }
  }
}

}  // namespace hallux::tests
