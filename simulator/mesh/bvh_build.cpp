#include <algorithm>
#include <bit>
#include <limits>

#include "simulator/base/check.h"
#include "simulator/mesh/bvh_tree.h"

/// Top-down building by the surface area heuristic over 16 bins (Wald 2007); below a depth that no
/// sensible mesh reaches, by halves, so that the depth is bounded whatever the mesh.
namespace hallux::simulator {

namespace {

constexpr std::size_t bin_count = 16;
/// Deeper than this, and the halves of 2^32 triangles would not fit the queries' stack.
constexpr std::size_t greatest_halving_depth = 44;

struct Box {
  Vec3 low{std::numeric_limits<double>::infinity()};
  Vec3 high{-std::numeric_limits<double>::infinity()};

  void add(const Vec3& point) noexcept {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  void add(const Box& box) noexcept {
    add(box.low);
    add(box.high);
  }
  double half_area() const noexcept {
    const Vec3 size = high - low;
    return size.x < 0.0 ? 0.0 : size.x * size.y + size.y * size.z + size.z * size.x;
  }
};

struct Item {
  Box box;
  Vec3 middle_mm{0.0, 0.0, 0.0};
  std::uint32_t triangle = 0;
};

struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::size_t size() const noexcept { return end - begin; }
};

struct Bin {
  Box box;
  std::size_t count = 0;
};

/// Steps a float to its neighbour; the order of floats is that of their bits.
float next_float(float value, bool upward) noexcept {
  if (value == 0.0F) return upward ? 0x1p-149F : -0x1p-149F;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return std::bit_cast<float>((value > 0.0F) == upward ? bits + 1 : bits - 1);
}

float rounded(double value, bool upward) noexcept {
  const auto near = static_cast<float>(value);
  const auto back = static_cast<double>(near);
  const bool is_outward = upward ? back >= value : back <= value;
  return is_outward ? near : next_float(near, upward);
}

TreeBox tree_box(const Box& box) noexcept {
  TreeBox result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.low[axis] = rounded(box.low[static_cast<glm::length_t>(axis)], false);
    result.high[axis] = rounded(box.high[static_cast<glm::length_t>(axis)], true);
  }
  return result;
}

Box box_of(const std::vector<Item>& items, const Range& range) noexcept {
  Box box;
  for (std::size_t i = range.begin; i < range.end; ++i) box.add(items[i].box);
  return box;
}

class Builder {
 public:
  Builder(std::vector<Item> items, const BvhBuild& build, std::vector<TreeNode>& nodes)
      : items_(std::move(items)), build_(build), nodes_(nodes) {}

  /// Makes the node over the range and all below it.
  void build(const Range& range, std::size_t depth) {
    CHECK(depth < tree_stack_size);
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    const std::size_t middle = divide(range, depth);
    const std::array<Range, 2> parts{Range{range.begin, middle}, Range{middle, range.end}};
    for (std::size_t side = 0; side < 2; ++side) {
      nodes_[node].box[side] = tree_box(box_of(items_, parts[side]));
      if (parts[side].size() <= build_.leaf_size) {
        make_leaf(nodes_[node], side, parts[side]);
      } else {
        nodes_[node].child[side] = static_cast<std::uint32_t>(nodes_.size());
        build(parts[side], depth + 1);
      }
    }
  }
  const std::vector<Item>& items() const noexcept { return items_; }

 private:
  void make_leaf(TreeNode& node, std::size_t side, const Range& range) {
    std::sort(items_.begin() + static_cast<std::ptrdiff_t>(range.begin),
              items_.begin() + static_cast<std::ptrdiff_t>(range.end),
              [](const Item& a, const Item& b) { return a.triangle < b.triangle; });
    node.child[side] = static_cast<std::uint32_t>(range.begin);
    node.count[side] = static_cast<std::uint32_t>(range.size());
  }

  std::size_t divide(const Range& range, std::size_t depth) {
    if (range.size() <= build_.leaf_size) return range.end;
    Box middles;
    for (std::size_t i = range.begin; i < range.end; ++i) middles.add(items_[i].middle_mm);
    const Vec3 size = middles.high - middles.low;
    const glm::length_t axis =
        size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    if (depth >= build_.halving_depth || !(size[axis] > 0.0)) return halve(range, axis);
    const double low = middles.low[axis];
    const double scale = static_cast<double>(bin_count) / size[axis];
    const auto bin_of = [&](const Item& item) {
      const auto bin = static_cast<std::size_t>((item.middle_mm[axis] - low) * scale);
      return std::min(bin, bin_count - 1);
    };
    std::array<Bin, bin_count> bins;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      Bin& bin = bins[bin_of(items_[i])];
      bin.box.add(items_[i].box);
      ++bin.count;
    }
    const std::size_t best = cheapest_cut(bins);
    const auto first = items_.begin() + static_cast<std::ptrdiff_t>(range.begin);
    const auto last = items_.begin() + static_cast<std::ptrdiff_t>(range.end);
    const auto middle =
        std::stable_partition(first, last, [&](const Item& item) { return bin_of(item) < best; });
    return static_cast<std::size_t>(middle - items_.begin());
  }

  /// The number of bins on the lower side. The first and the last bin are never empty.
  static std::size_t cheapest_cut(const std::array<Bin, bin_count>& bins) noexcept {
    std::array<double, bin_count> cost{};
    Bin above;
    for (std::size_t i = bin_count - 1; i > 0; --i) {
      above.box.add(bins[i].box);
      above.count += bins[i].count;
      cost[i] = above.box.half_area() * static_cast<double>(above.count);
    }
    Bin below;
    std::size_t best = 1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < bin_count; ++i) {
      below.box.add(bins[i - 1].box);
      below.count += bins[i - 1].count;
      cost[i] += below.box.half_area() * static_cast<double>(below.count);
      if (cost[i] < least) {
        least = cost[i];
        best = i;
      }
    }
    return best;
  }

  std::size_t halve(const Range& range, glm::length_t axis) {
    const std::size_t middle = range.begin + range.size() / 2;
    std::nth_element(items_.begin() + static_cast<std::ptrdiff_t>(range.begin),
                     items_.begin() + static_cast<std::ptrdiff_t>(middle),
                     items_.begin() + static_cast<std::ptrdiff_t>(range.end),
                     [axis](const Item& a, const Item& b) {
                       return a.middle_mm[axis] != b.middle_mm[axis]
                                  ? a.middle_mm[axis] < b.middle_mm[axis]
                                  : a.triangle < b.triangle;
                     });
    return middle;
  }

  std::vector<Item> items_;
  BvhBuild build_;
  std::vector<TreeNode>& nodes_;
};

std::vector<Item> items_of(const IndexedMesh& mesh) {
  std::vector<Item> items(mesh.triangles.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (const std::uint32_t index : mesh.triangles[i]) items[i].box.add(mesh.points_mm[index]);
    items[i].middle_mm = 0.5 * (items[i].box.low + items[i].box.high);
    items[i].triangle = static_cast<std::uint32_t>(i);
  }
  return items;
}

}  // namespace

void build_nodes(const IndexedMesh& mesh, const BvhBuild& build, std::vector<TreeNode>& nodes,
                 std::vector<TreeSlot>& slots) {
  CHECK(build.leaf_size > 0 && build.halving_depth <= greatest_halving_depth);
  if (mesh.triangles.empty()) return;
  nodes.reserve(mesh.triangles.size());
  Builder builder{items_of(mesh), build, nodes};
  builder.build({0, mesh.triangles.size()}, 0);
  // A third of the room is used where leaves hold several triangles.
  nodes.shrink_to_fit();
  slots.reserve(mesh.triangles.size());
  for (const Item& item : builder.items()) {
    const Triangle& triangle = mesh.triangles[item.triangle];
    TreeSlot slot;
    for (std::size_t k = 0; k < 3; ++k) slot.corner_mm[k] = mesh.points_mm[triangle[k]];
    slot.triangle = item.triangle;
    slots.push_back(slot);
  }
}

}  // namespace hallux::simulator
