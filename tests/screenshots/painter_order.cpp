#include "tests/screenshots/painter_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace hallux::tests {

namespace {

constexpr double sample_px = 0.5;
constexpr double cell_px = 12.0;
constexpr double least_overlap_px2 = 0.02;
/// In the depth's unit, millimetres: faces nearer than this to each other touch along an edge.
constexpr double least_depth = 1.0e-6;

double cross(const Vec2& a, const Vec2& b) noexcept { return a.x * b.y - a.y * b.x; }

struct Box {
  Vec2 min, max;
};

Box box_of(const PageTriangle& triangle) {
  const auto& [a, b, c] = triangle.places_px;
  return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

/// The plane of a triangle's depth over the page; none where it is seen edge on.
std::optional<Vec3> weights_at(const PageTriangle& triangle, const Vec2& place) {
  const auto& [a, b, c] = triangle.places_px;
  const double whole = cross(b - a, c - a);
  if (std::abs(whole) < 1.0e-9) return std::nullopt;
  const double second = cross(place - a, c - a) / whole;
  const double third = cross(b - a, place - a) / whole;
  return Vec3(1.0 - second - third, second, third);
}

double depth_at(const PageTriangle& triangle, const Vec3& weights) {
  return weights.x * triangle.depths[0] + weights.y * triangle.depths[1] +
         weights.z * triangle.depths[2];
}

class DepthBuffer {
 public:
  explicit DepthBuffer(const std::vector<PageTriangle>& triangles) {
    if (triangles.empty()) return;
    Box all = box_of(triangles.front());
    for (const PageTriangle& triangle : triangles) {
      const Box box = box_of(triangle);
      all = {glm::min(all.min, box.min), glm::max(all.max, box.max)};
    }
    min_ = all.min;
    width_ = static_cast<std::size_t>((all.max.x - all.min.x) / sample_px) + 2;
    height_ = static_cast<std::size_t>((all.max.y - all.min.y) / sample_px) + 2;
    depths_.assign(width_ * height_, -1.0e300);
    for (const PageTriangle& triangle : triangles) {
      for_samples(triangle, [](double& kept, double depth) { kept = std::max(kept, depth); });
    }
  }

  bool shows(const PageTriangle& triangle) {
    bool has_samples = false, is_seen = false;
    for_samples(triangle, [&](const double& kept, double depth) {
      has_samples = true;
      is_seen = is_seen || depth >= kept - least_depth;
    });
    return has_samples ? is_seen : shows_middle(triangle);
  }

 private:
  /// Whether the middle lies before what is seen at any of the nine samples around it.
  bool shows_middle(const PageTriangle& triangle) const {
    const auto& [a, b, c] = triangle.places_px;
    const Vec2 cell = ((a + b + c) / 3.0 - min_) / sample_px;
    const auto column = static_cast<std::size_t>(cell.x), row = static_cast<std::size_t>(cell.y);
    double farthest = 1.0e300;
    for (std::size_t i = std::max<std::size_t>(row, 1) - 1; i < std::min(row + 2, height_); ++i) {
      for (std::size_t j = std::max<std::size_t>(column, 1) - 1; j < std::min(column + 2, width_);
           ++j) {
        farthest = std::min(farthest, depths_[i * width_ + j]);
      }
    }
    return triangle.depths[0] + triangle.depths[1] + triangle.depths[2] >= 3.0 * farthest;
  }

  template <typename SignedInSession>
  void for_samples(const PageTriangle& triangle, SignedInSession&& visit) {
    const Box box = box_of(triangle);
    const auto index = [](double value) { return static_cast<std::size_t>(std::max(0.0, value)); };
    const std::size_t last_row = index((box.max.y - min_.y) / sample_px);
    const std::size_t last_column = index((box.max.x - min_.x) / sample_px);
    for (std::size_t row = index((box.min.y - min_.y) / sample_px); row <= last_row; ++row) {
      for (std::size_t column = index((box.min.x - min_.x) / sample_px); column <= last_column;
           ++column) {
        const Vec2 place =
            min_ +
            sample_px * (Vec2(static_cast<double>(column), static_cast<double>(row)) + Vec2(0.5));
        const std::optional<Vec3> weights = weights_at(triangle, place);
        if (!weights || weights->x < 0.0 || weights->y < 0.0 || weights->z < 0.0) continue;
        visit(depths_[row * width_ + column], depth_at(triangle, *weights));
      }
    }
  }

  Vec2 min_{0.0, 0.0};
  std::size_t width_ = 0, height_ = 0;
  std::vector<double> depths_;
};

/// What of `polygon` lies left of the line from a to b.
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const Vec2& a, const Vec2& b) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& from = polygon[i];
    const Vec2& to = polygon[(i + 1) % polygon.size()];
    const double from_side = cross(b - a, from - a), to_side = cross(b - a, to - a);
    if (from_side >= 0.0) kept.push_back(from);
    if ((from_side < 0.0) != (to_side < 0.0)) {
      kept.push_back(from + from_side / (from_side - to_side) * (to - from));
    }
  }
  return kept;
}

std::vector<Vec2> counter_clockwise(const PageTriangle& triangle) {
  const auto& [a, b, c] = triangle.places_px;
  if (cross(b - a, c - a) >= 0.0) return {a, b, c};
  return {a, c, b};
}

/// +1 where `a` covers `b`, -1 where `b` covers `a`, 0 where neither does.
int covering(const PageTriangle& a, const PageTriangle& b) {
  std::vector<Vec2> common = counter_clockwise(a);
  const std::vector<Vec2> other = counter_clockwise(b);
  for (std::size_t k = 0; k < 3 && common.size() > 2; ++k) {
    common = clipped(common, other[k], other[(k + 1) % 3]);
  }
  double doubled = 0.0;
  Vec2 sum(0.0);
  for (std::size_t i = 0; i < common.size(); ++i) {
    doubled += cross(common[i] - common[0], common[(i + 1) % common.size()] - common[0]);
    sum += common[i];
  }
  if (common.size() < 3 || doubled < 2.0 * least_overlap_px2) return 0;
  const Vec2 middle = sum / static_cast<double>(common.size());
  const std::optional<Vec3> at_a = weights_at(a, middle), at_b = weights_at(b, middle);
  if (!at_a || !at_b) return 0;
  const double difference = depth_at(a, *at_a) - depth_at(b, *at_b);
  if (std::abs(difference) < least_depth) return 0;
  return difference > 0.0 ? 1 : -1;
}

class Painter {
 public:
  Painter(const std::vector<PageTriangle>& triangles, const std::vector<std::uint32_t>& seen)
      : triangles_(triangles), covers_(triangles.size()), waits_(triangles.size(), 0) {
    std::map<std::pair<int, int>, std::vector<std::uint32_t>> cells;
    std::set<std::pair<std::uint32_t, std::uint32_t>> asked;
    for (const std::uint32_t triangle : seen) {
      const Box box = box_of(triangles[triangle]);
      for (int i = cell(box.min.x); i <= cell(box.max.x); ++i) {
        for (int j = cell(box.min.y); j <= cell(box.max.y); ++j) {
          for (const std::uint32_t other : cells[{i, j}]) {
            if (asked.insert({other, triangle}).second) compare(other, triangle);
          }
          cells[{i, j}].push_back(triangle);
        }
      }
    }
    for (const std::uint32_t triangle : seen) waiting_.insert(triangle);
    for (const std::uint32_t triangle : seen) {
      if (waits_[triangle] == 0) release(triangle);
    }
  }

  std::vector<std::uint32_t> order() {
    std::vector<std::uint32_t> painted;
    while (!ready_.empty() || !waiting_.empty()) {
      if (ready_.empty()) release(farthest_waiting());
      auto run = longest_run();
      while (!run->second.empty()) {
        const std::uint32_t triangle = *run->second.begin();
        run->second.erase(run->second.begin());
        painted.push_back(triangle);
        for (const std::uint32_t other : covers_[triangle]) {
          if (--waits_[other] == 0 && waiting_.contains(other)) release(other);
        }
      }
      ready_.erase(run);
    }
    return painted;
  }

 private:
  static int cell(double px) { return static_cast<int>(std::floor(px / cell_px)); }

  void compare(std::uint32_t a, std::uint32_t b) {
    const int result = covering(triangles_[a], triangles_[b]);
    if (result == 0) return;
    covers_[result > 0 ? b : a].push_back(result > 0 ? a : b);
    ++waits_[result > 0 ? a : b];
  }
  void release(std::uint32_t triangle) {
    waiting_.erase(triangle);
    ready_[triangles_[triangle].paint].insert(triangle);
  }
  std::map<std::uint32_t, std::set<std::uint32_t>>::iterator longest_run() {
    return std::max_element(ready_.begin(), ready_.end(), [](const auto& a, const auto& b) {
      return a.second.size() < b.second.size();
    });
  }
  std::uint32_t farthest_waiting() const {
    const auto depth = [&](std::uint32_t triangle) {
      const auto& depths = triangles_[triangle].depths;
      return depths[0] + depths[1] + depths[2];
    };
    return *std::min_element(waiting_.begin(), waiting_.end(),
                             [&](std::uint32_t a, std::uint32_t b) { return depth(a) < depth(b); });
  }

  const std::vector<PageTriangle>& triangles_;
  std::vector<std::vector<std::uint32_t>> covers_;  ///< per triangle: those that cover it
  std::vector<std::uint32_t> waits_;                ///< how many behind it are not painted yet
  std::set<std::uint32_t> waiting_;
  std::map<std::uint32_t, std::set<std::uint32_t>> ready_;  ///< by paint
};

}  // namespace

std::vector<std::uint32_t> seen_triangles(const std::vector<PageTriangle>& triangles) {
  DepthBuffer buffer(triangles);
  std::vector<std::uint32_t> seen;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (buffer.shows(triangles[i])) seen.push_back(i);
  }
  return seen;
}

std::vector<std::uint32_t> painter_order(const std::vector<PageTriangle>& triangles,
                                         const std::vector<std::uint32_t>& seen) {
  return Painter(triangles, seen).order();
}

}  // namespace hallux::tests
