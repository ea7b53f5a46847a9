// From the left, each mark joins the cluster before it where they would touch. A cluster is wider
// than a mark and stands in the middle of its marks, so that it may touch the one before it in
// turn: those are joined until nothing touches.
#include "ui/widgets/charts/mark_clusters.h"

#include <algorithm>

namespace hallux::ui {

namespace {

constexpr float gap = 2.0F, cluster_padding = 7.0F, digit_width = 6.5F;

bool touch(const MarkCluster& left, const MarkCluster& right) noexcept {
  return right.x - left.x < left.half_width + right.half_width + gap;
}

/// In the middle between its first and its last mark.
MarkCluster joined(const MarkCluster& left, const MarkCluster& right,
                   std::span<const PlacedMark> marks) noexcept {
  MarkCluster cluster{left.first, left.count + right.count, 0.0F, 0.0F};
  cluster.x = 0.5F * (marks[left.first].x + marks[right.first + right.count - 1].x);
  cluster.half_width = cluster_half_width(cluster.count);
  return cluster;
}

}  // namespace

float cluster_half_width(std::size_t count) noexcept {
  float digits = 1.0F;
  for (std::size_t rest = count; rest >= 10; rest /= 10) digits += 1.0F;
  return std::max(10.0F, cluster_padding + 0.5F * digit_width * digits);
}

std::vector<MarkCluster> clustered(std::span<const PlacedMark> marks) {
  std::vector<MarkCluster> clusters;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    clusters.push_back({i, 1, marks[i].x, marks[i].half_width});
    while (clusters.size() > 1 && touch(clusters[clusters.size() - 2], clusters.back())) {
      const MarkCluster last = clusters.back();
      clusters.pop_back();
      clusters.back() = joined(clusters.back(), last, marks);
    }
  }
  return clusters;
}

}  // namespace hallux::ui
