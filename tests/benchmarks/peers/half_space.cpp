#include "tests/benchmarks/peers/half_space.h"

namespace hallux::benchmarks {

namespace {

HalfSpace below(const simulator::KerfPlane& plane, double height_mm) {
  const Vec3 normal = transform_direction(plane.bone_from_kerf, Vec3(0.0, 0.0, 1.0));
  return {normal, glm::dot(normal, plane.bone_from_kerf.translation_mm) + height_mm};
}

HalfSpace above(const simulator::KerfPlane& plane, double height_mm) {
  const HalfSpace side = below(plane, height_mm);
  return {-side.normal, -side.offset_mm};
}

}  // namespace

std::array<HalfSpace, 2> sides_of(const simulator::KerfPlane& plane, double height_mm) {
  return {below(plane, height_mm), above(plane, height_mm)};
}

std::array<HalfSpace, 2> sides_of_slab(const simulator::KerfPlane& plane) {
  return {below(plane, -0.5 * plane.thickness_mm), above(plane, 0.5 * plane.thickness_mm)};
}

}  // namespace hallux::benchmarks
