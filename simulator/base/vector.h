/// The vectors and rotations of every room: GLM in double precision, set up here and nowhere else.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace hallux {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Quat = glm::dquat;

inline double length_of(const Vec2& vector) noexcept { return std::sqrt(glm::dot(vector, vector)); }
inline double length_of(const Vec3& vector) noexcept { return std::sqrt(glm::dot(vector, vector)); }
inline double squared_length(const Vec3& vector) noexcept { return glm::dot(vector, vector); }
/// needs   its length is above 0
inline Vec2 unit(const Vec2& direction) noexcept { return direction / length_of(direction); }
inline Vec3 unit(const Vec3& direction) noexcept { return direction / length_of(direction); }
/// Twice the area of the triangle that they span, above 0 where `b` is to the left of `a`.
inline double cross(const Vec2& a, const Vec2& b) noexcept { return a.x * b.y - a.y * b.x; }
/// At most `limit` long, in its own direction.
inline Vec3 shortened(const Vec3& vector, double limit) noexcept {
  const double length = length_of(vector);
  return length > limit ? limit / length * vector : vector;
}
inline bool is_finite(const Vec3& vector) noexcept {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

}  // namespace hallux
