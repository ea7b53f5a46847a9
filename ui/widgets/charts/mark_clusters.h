/// Marks on a line that would lie over each other, drawn as one with their number.
/// Inside this corner only.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace hallux::ui {

/// Where a mark would be drawn, and how far it reaches to both sides.
struct PlacedMark {
  float x = 0.0F, half_width = 6.0F;
};

/// Marks that follow each other; one alone, or so many that are drawn as one.
struct MarkCluster {
  std::size_t first = 0, count = 1;
  float x = 0.0F, half_width = 6.0F;
};

/// How far a cluster of so many reaches to both sides of its middle.
float cluster_half_width(std::size_t count) noexcept;

/// needs   the marks stand by their places
/// ensures each mark is in one cluster, and no two clusters touch
std::vector<MarkCluster> clustered(std::span<const PlacedMark> marks);

}  // namespace hallux::ui
