// Cells of a lattice, closed by the sides between a full cell and an empty one.
#include "tests/ui/screens/operating/forked_block.h"

#include <array>
#include <map>
#include <utility>

#include "scenarios/practice_block.h"

namespace hallux::ui {

namespace {

using Place = std::array<int, 3>;

/// Along, up to the approach, across.
constexpr Place cells{30, 4, 18};
/// Of the slot between the prongs, from these cells on to the end.
constexpr int slot_along = 16, slot_across = 3, slot_width = 2;
/// As of the practice block, off the lattice of the cut.
constexpr double low_x_mm = -18.65, half_width_mm = 9.0, height_mm = 4.0, slope = 0.05;

bool is_full(const Place& cell) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (cell[axis] < 0 || cell[axis] >= cells[axis]) return false;
  const bool is_across = cell[2] >= slot_across && cell[2] < slot_across + slot_width;
  return cell[0] < slot_along || !is_across;
}

Vec3 place_mm(const Place& corner) {
  const double across_mm = corner[2] - half_width_mm;
  const double top_mm = height_mm - slope * across_mm;
  return {low_x_mm + corner[0], across_mm, -top_mm * corner[1] / cells[1]};
}

class ForkMesh {
 public:
  simulator::IndexedMesh take() {
    for (int i = 0; i < cells[0]; ++i)
      for (int j = 0; j < cells[1]; ++j)
        for (int k = 0; k < cells[2]; ++k)
          if (is_full({i, j, k})) close({i, j, k});
    return std::move(mesh_);
  }

 private:
  void close(const Place& cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int step : {-1, 1}) {
        Place beside = cell;
        beside[axis] += step;
        if (!is_full(beside)) add_side(cell, axis, step);
      }
    }
  }

  void add_side(const Place& cell, std::size_t axis, int step) {
    Place low = cell;
    if (step > 0) ++low[axis];
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto corner = [&](int more_u, int more_v) {
      Place place = low;
      place[u] += more_u;
      place[v] += more_v;
      return point(place);
    };
    const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
    const bool is_outward = step > 0;
    mesh_.triangles.push_back(is_outward ? simulator::Triangle{a, b, c}
                                         : simulator::Triangle{a, c, b});
    mesh_.triangles.push_back(is_outward ? simulator::Triangle{a, c, d}
                                         : simulator::Triangle{a, d, c});
  }

  std::uint32_t point(const Place& corner) {
    const auto next = static_cast<std::uint32_t>(mesh_.points_mm.size());
    const auto [found, is_new] = points_.emplace(corner, next);
    if (is_new) mesh_.points_mm.push_back(place_mm(corner));
    return found->second;
  }

  simulator::IndexedMesh mesh_;
  std::map<Place, std::uint32_t> points_;
};

}  // namespace

PreparedCase forked_case(double blade_width_mm) {
  scenarios::PracticeBlock block = scenarios::make_practice_block();
  block.bone.name = "forked_block";
  block.bone.outer = ForkMesh().take();
  block.scenario.saw.blade.width_mm = blade_width_mm;
  return prepare_case(std::move(block.scenario), std::move(block.bone));
}

}  // namespace hallux::ui
