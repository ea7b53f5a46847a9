/// The best plane through points holds their centre, and its normal is the direction in which they
/// spread least: the eigenvector of a symmetric 3 x 3 matrix, by Jacobi's rotations, which need no
/// library. Points beyond 2.5 sigma are left out and the plane is fitted anew until none changes
/// sides; points that are exact but for rounding are never trimmed.
#include "assessment/metrics/face_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hallux::assessment {

namespace {

/// Trimming stops at what is only rounding: points of an exact plane are never outliers.
constexpr double rounding_mm = 1.0e-9;
constexpr double trim_sigmas = 2.5;
constexpr int trim_rounds = 20;
constexpr int sweeps = 12;
constexpr double line_ratio = 1.0e-10;

using Symmetric = std::array<std::array<double, 3>, 3>;

struct Eigen3 {
  std::array<double, 3> values{};  ///< ascending
  Vec3 least{0.0, 0.0, 0.0};       ///< unit vector of the smallest
};

/// One Jacobi rotation in the plane of axes p and q, which makes matrix[p][q] zero; `vectors` turns
/// with it.
void rotate_away(Symmetric& matrix, std::array<Vec3, 3>& vectors, std::size_t p, std::size_t q) {
  if (matrix[p][q] == 0.0) return;
  const double theta = (matrix[q][q] - matrix[p][p]) / (2.0 * matrix[p][q]);
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double c = 1.0 / std::hypot(t, 1.0);
  const double s = t * c;
  const std::size_t r = 3 - p - q;
  const double rp = matrix[r][p], rq = matrix[r][q];
  matrix[p][p] -= t * matrix[p][q];
  matrix[q][q] += t * matrix[p][q];
  matrix[p][q] = matrix[q][p] = 0.0;
  matrix[r][p] = matrix[p][r] = c * rp - s * rq;
  matrix[r][q] = matrix[q][r] = s * rp + c * rq;
  const Vec3 vp = vectors[p], vq = vectors[q];
  vectors[p] = c * vp - s * vq;
  vectors[q] = s * vp + c * vq;
}

/// source  Jacobi's method: a few sweeps of rotations leave only the diagonal
Eigen3 eigen_of_symmetric(Symmetric matrix) {
  std::array<Vec3, 3> vectors{Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}};
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    rotate_away(matrix, vectors, 0, 1);
    rotate_away(matrix, vectors, 0, 2);
    rotate_away(matrix, vectors, 1, 2);
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return matrix[a][a] < matrix[b][b]; });
  Eigen3 eigen;
  for (std::size_t index = 0; index < 3; ++index) {
    eigen.values[index] = matrix[order[index]][order[index]];
  }
  eigen.least = vectors[order[0]];
  return eigen;
}

Symmetric spread_about(std::span<const Vec3> points_mm, const Vec3& centre_mm) noexcept {
  Symmetric spread{};
  for (const Vec3& point : points_mm) {
    const Vec3 offset = point - centre_mm;
    const std::array<double, 3> parts{offset.x, offset.y, offset.z};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        spread[row][column] += parts[row] * parts[column];
      }
    }
  }
  return spread;
}

std::optional<FacePlane> least_squares_plane(std::span<const Vec3> points_mm, const Vec3& side) {
  if (points_mm.size() < 3) return std::nullopt;
  Vec3 sum_mm{0.0, 0.0, 0.0};
  for (const Vec3& point : points_mm) sum_mm += point;
  const Vec3 centre_mm = sum_mm / static_cast<double>(points_mm.size());
  const Eigen3 eigen = eigen_of_symmetric(spread_about(points_mm, centre_mm));
  // The middle spread of points on a line is rounding only: no plane is meant by them.
  if (!(eigen.values[1] > line_ratio * eigen.values[2])) return std::nullopt;
  Vec3 normal = eigen.least / std::sqrt(glm::dot(eigen.least, eigen.least));
  if (glm::dot(normal, side) < 0.0) normal = -normal;
  return FacePlane{normal, glm::dot(normal, centre_mm)};
}

std::vector<Vec3> within_sigmas(std::span<const Vec3> points_mm, const FacePlane& plane,
                                double sigma_mm) {
  std::vector<Vec3> kept;
  for (const Vec3& point : points_mm) {
    if (std::abs(signed_distance_mm(plane, point)) <= trim_sigmas * sigma_mm) kept.push_back(point);
  }
  return kept;
}

double rms_distance_mm(std::span<const Vec3> points_mm, const FacePlane& plane) noexcept {
  double sum = 0.0;
  for (const Vec3& point : points_mm) {
    const double distance_mm = signed_distance_mm(plane, point);
    sum += distance_mm * distance_mm;
  }
  return std::sqrt(sum / static_cast<double>(points_mm.size()));
}

}  // namespace

double signed_distance_mm(const FacePlane& plane, const Vec3& point_mm) noexcept {
  return glm::dot(plane.normal, point_mm) - plane.offset_mm;
}

double distance_along_mm(const FacePlane& plane, const Vec3& point_mm,
                         const Vec3& direction) noexcept {
  const double along = glm::dot(plane.normal, direction);
  if (along == 0.0) return std::numeric_limits<double>::infinity();
  return -signed_distance_mm(plane, point_mm) / along;
}

double angle_between_rad(const Vec3& a, const Vec3& b) noexcept {
  const Vec3 across = glm::cross(a, b);
  return std::atan2(std::sqrt(glm::dot(across, across)), glm::dot(a, b));
}

std::optional<FacePlane> fit_plane(std::span<const Vec3> points_mm, const Vec3& side) {
  std::vector<Vec3> used(points_mm.begin(), points_mm.end());
  std::optional<FacePlane> plane = least_squares_plane(used, side);
  for (int round = 0; plane && round < trim_rounds; ++round) {
    const double sigma_mm = rms_distance_mm(used, *plane);
    if (sigma_mm < rounding_mm) break;
    std::vector<Vec3> kept = within_sigmas(points_mm, *plane, sigma_mm);
    if (kept.size() == used.size()) break;
    const std::optional<FacePlane> trimmed = least_squares_plane(kept, side);
    if (!trimmed) break;
    plane = trimmed;
    used = std::move(kept);
  }
  return plane;
}

double percentile(std::vector<double> values, double fraction) {
  std::sort(values.begin(), values.end());
  const double rank = fraction * static_cast<double>(values.size() - 1);
  const std::size_t below = static_cast<std::size_t>(std::floor(rank));
  const std::size_t above = std::min(below + 1, values.size() - 1);
  const double part = rank - static_cast<double>(below);
  return values[below] + part * (values[above] - values[below]);
}

}  // namespace hallux::assessment
