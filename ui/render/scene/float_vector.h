/// Single precision, for what goes to the graphics card and nothing else; every conversion from
/// double is here.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "simulator/base/transform.h"

namespace hallux::ui {

using Float2 = glm::vec2;
using Float3 = glm::vec3;
using Float4 = glm::vec4;
using Matrix4 = glm::mat4;
/// Matrices are multiplied in double and rounded once.
using DoubleMatrix4 = glm::dmat4;

inline Float3 to_float(const Vec3& v) noexcept { return Float3(v); }
inline Float2 to_float(const Vec2& v) noexcept { return Float2(v); }
inline Matrix4 to_float(const DoubleMatrix4& matrix) noexcept { return Matrix4(matrix); }

/// The transform as a matrix on points with w = 1.
inline DoubleMatrix4 matrix_of(const RigidTransform& to_from_from) noexcept {
  DoubleMatrix4 matrix(glm::mat3_cast(to_from_from.rotation));
  matrix[3] = glm::dvec4(to_from_from.translation_mm, 1.0);
  return matrix;
}

/// 0xRRGGBB of sRGB as it stands in the table of tokens, each part in [0, 1].
constexpr Float3 colour_of(std::uint32_t rgb) noexcept {
  return Float3(static_cast<float>((rgb >> 16U) & 255U) / 255.0F,
                static_cast<float>((rgb >> 8U) & 255U) / 255.0F,
                static_cast<float>(rgb & 255U) / 255.0F);
}

}  // namespace hallux::ui
