#include "tests/scenarios/foot/rigid_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <limits>
#include <numeric>

#include "simulator/base/random.h"

namespace hallux::scenarios_test {
namespace {

template <std::size_t N>
using Square = std::array<std::array<double, N>, N>;

/// Eigenvectors of a symmetric matrix as columns (Jacobi's rotations); the eigenvalues stay on the
/// diagonal.
template <std::size_t N>
Square<N> eigenvectors(Square<N>& m) {
  Square<N> v{};
  for (std::size_t i = 0; i < N; ++i) v[i][i] = 1.0;
  for (std::size_t sweep = 0; sweep < 50; ++sweep) {
    for (std::size_t p = 0; p < N; ++p) {
      for (std::size_t q = p + 1; q < N; ++q) {
        if (std::abs(m[p][q]) < 1e-14) continue;
        const double turn = 0.5 * std::atan2(2.0 * m[p][q], m[q][q] - m[p][p]);
        const double c = std::cos(turn);
        const double s = std::sin(turn);
        const auto mix = [c, s](double& a, double& b) {
          const double old = a;
          a = c * a - s * b;
          b = s * old + c * b;
        };
        for (std::size_t k = 0; k < N; ++k) mix(m[k][p], m[k][q]);
        for (std::size_t k = 0; k < N; ++k) mix(m[p][k], m[q][k]);
        for (std::size_t k = 0; k < N; ++k) mix(v[k][p], v[k][q]);
      }
    }
  }
  return v;
}

Vec3 mean_of(const std::vector<Vec3>& points) {
  const Vec3 sum = std::accumulate(points.begin(), points.end(), Vec3{0.0});
  return sum / static_cast<double>(points.size());
}

/// Unit axes of greatest to least spread.
std::array<Vec3, 3> principal_axes(const std::vector<Vec3>& points, const Vec3& mean) {
  Square<3> m{};
  for (const Vec3& p : points) {
    const Vec3 d = p - mean;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        m[i][j] += d[static_cast<glm::length_t>(i)] * d[static_cast<glm::length_t>(j)];
      }
    }
  }
  const Square<3> v = eigenvectors(m);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&m](auto a, auto b) { return m[a][a] > m[b][b]; });
  std::array<Vec3, 3> axes;
  for (std::size_t k = 0; k < 3; ++k) axes[k] = {v[0][order[k]], v[1][order[k]], v[2][order[k]]};
  return axes;
}

/// Horn 1987: the rotation is the eigenvector of the greatest eigenvalue.
RigidTransform best_motion(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  const Vec3 from_mean = mean_of(from);
  const Vec3 to_mean = mean_of(to);
  glm::dmat3 s{0.0};
  for (std::size_t i = 0; i < from.size(); ++i) {
    s += glm::outerProduct(to[i] - to_mean, from[i] - from_mean);
  }
  // s[j][k] holds from_j to_k.
  Square<4> n{};
  n[0] = {s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]};
  n[1] = {n[0][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]};
  n[2] = {n[0][2], n[1][2], s[1][1] - s[0][0] - s[2][2], s[1][2] + s[2][1]};
  n[3] = {n[0][3], n[1][3], n[2][3], s[2][2] - s[0][0] - s[1][1]};
  const Square<4> v = eigenvectors(n);
  std::size_t best = 0;
  for (std::size_t k = 1; k < 4; ++k) {
    if (n[k][k] > n[best][best]) best = k;
  }
  RigidTransform motion;
  motion.rotation = normalised(Quat{v[0][best], v[1][best], v[2][best], v[3][best]});
  motion.translation_mm = to_mean - transform_direction(motion, from_mean);
  return motion;
}

double mean_square(const std::vector<Vec3>& points, const simulator::Bvh& target,
                   const RigidTransform& motion) {
  double sum = 0.0;
  for (const Vec3& p : points) {
    const double d = target.nearest(transform_point(motion, p))->distance_mm;
    sum += d * d;
  }
  return sum / static_cast<double>(points.size());
}

}  // namespace

std::vector<Vec3> area_samples(const simulator::IndexedMesh& mesh, std::size_t count) {
  std::vector<double> area_until;
  double area = 0.0;
  for (const simulator::Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.points_mm[t[0]];
    const Vec3 normal = glm::cross(mesh.points_mm[t[1]] - a, mesh.points_mm[t[2]] - a);
    area += std::sqrt(glm::dot(normal, normal));
    area_until.push_back(area);
  }
  Random random(1, "area_samples");
  std::vector<Vec3> samples;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at =
        std::upper_bound(area_until.begin(), area_until.end(), random.uniform(0.0, area));
    const std::size_t index =
        std::min(static_cast<std::size_t>(at - area_until.begin()), mesh.triangles.size() - 1);
    const simulator::Triangle& t = mesh.triangles[index];
    double u = random.uniform();
    double v = random.uniform();
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const Vec3& a = mesh.points_mm[t[0]];
    samples.push_back(a + u * (mesh.points_mm[t[1]] - a) + v * (mesh.points_mm[t[2]] - a));
  }
  return samples;
}

RigidTransform refine_fit(const std::vector<Vec3>& points_mm, const simulator::Bvh& target,
                          RigidTransform target_from_points, int rounds) {
  std::vector<Vec3> nearest(points_mm.size(), Vec3{0.0});
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < points_mm.size(); ++i) {
      nearest[i] = target.nearest(transform_point(target_from_points, points_mm[i]))->point_mm;
    }
    target_from_points = best_motion(points_mm, nearest);
  }
  return target_from_points;
}

RigidTransform fit_rigidly(const std::vector<Vec3>& points_mm, const simulator::Bvh& target,
                           const std::vector<Vec3>& target_points_mm) {
  const Vec3 from_mean = mean_of(points_mm);
  const Vec3 to_mean = mean_of(target_points_mm);
  const auto from = principal_axes(points_mm, from_mean);
  const auto to = principal_axes(target_points_mm, to_mean);
  RigidTransform best;
  double least = std::numeric_limits<double>::infinity();
  for (const double x_sign : {1.0, -1.0}) {
    // A quarter turn more than the signs: the two lesser axes of a round shaft may be exchanged.
    for (const auto& [y_axis, sign] : {std::pair{1U, 1.0}, {1U, -1.0}, {2U, 1.0}, {2U, -1.0}}) {
      const RigidTransform from_axes{rotation_from_axes(from[0], from[1]), Vec3{0.0}};
      const RigidTransform to_axes{rotation_from_axes(x_sign * to[0], sign * to[y_axis]),
                                   Vec3{0.0}};
      RigidTransform start = to_axes * inverse(from_axes);
      start.translation_mm = to_mean - transform_direction(start, from_mean);
      const RigidTransform fitted = refine_fit(points_mm, target, start, 40);
      const double error = mean_square(points_mm, target, fitted);
      if (error < least) {
        least = error;
        best = fitted;
      }
    }
  }
  return best;
}

}  // namespace hallux::scenarios_test
