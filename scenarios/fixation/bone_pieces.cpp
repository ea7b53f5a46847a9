// Which piece a point belongs to cannot be told by the sides of the planes alone: the arms of a V
// end at their apex, the bone beyond one side's plane may belong to either piece. So the bone is
// filled with cells, a row along x at a time, and cells are joined to their neighbours wherever no
// face lies between: what hangs together is one piece. A millimetre is fine enough for what a plan
// asks, and takes a few hundredths of a second.
#include "scenarios/fixation/bone_pieces.h"

#include <algorithm>
#include <cmath>

namespace hallux::scenarios {
namespace {

constexpr std::int32_t no_bone = -1, no_piece_yet = -2;
constexpr double cell_mm = 1.0;
/// Rows pass beside the corners of meshes whose corners lie on whole millimetres.
const Vec3 off_lattice_mm{0.137, 0.211, 0.173};
constexpr std::int64_t near_cells = 3;

/// Where the row along x at (y, z) crosses the triangle; nothing where it passes by.
std::optional<double> crossing_x_mm(const std::array<Vec3, 3>& corner_mm, double y_mm,
                                    double z_mm) {
  const auto side = [&](const Vec3& a, const Vec3& b) {
    return (b.y - a.y) * (z_mm - a.z) - (b.z - a.z) * (y_mm - a.y);
  };
  const double of_c = side(corner_mm[0], corner_mm[1]), of_a = side(corner_mm[1], corner_mm[2]),
               of_b = side(corner_mm[2], corner_mm[0]);
  const bool is_inside = (of_a > 0.0) == (of_b > 0.0) && (of_b > 0.0) == (of_c > 0.0);
  const double whole = of_a + of_b + of_c;
  if (!is_inside || whole == 0.0) return std::nullopt;
  return (of_a * corner_mm[0].x + of_b * corner_mm[1].x + of_c * corner_mm[2].x) / whole;
}

bool is_parted(const Vec3& from_mm, const Vec3& to_mm, std::span<const PartingFace> faces) {
  return std::ranges::any_of(faces, [&](const PartingFace& wall) {
    const double from_off_mm = glm::dot(wall.face.normal, from_mm) - wall.face.offset_mm;
    const double to_off_mm = glm::dot(wall.face.normal, to_mm) - wall.face.offset_mm;
    if ((from_off_mm > 0.0) == (to_off_mm > 0.0)) return false;
    if (!wall.window) return true;
    const Vec3 place_mm = from_mm + from_off_mm / (from_off_mm - to_off_mm) * (to_mm - from_mm);
    return lies_within(*wall.window, place_mm);
  });
}

}  // namespace

BonePieces::BonePieces(const simulator::IndexedMesh& outer, std::span<const PartingFace> faces) {
  Vec3 high_mm = low_mm_ = outer.points_mm.front();
  for (const Vec3& point : outer.points_mm) {
    low_mm_ = glm::min(low_mm_, point);
    high_mm = glm::max(high_mm, point);
  }
  low_mm_ -= off_lattice_mm;
  for (int axis = 0; axis < 3; ++axis) {
    size_[static_cast<std::size_t>(axis)] =
        1 + static_cast<std::int64_t>(std::floor((high_mm - low_mm_)[axis] / cell_mm));
  }
  fill(outer);
  part(faces);
}

void BonePieces::fill(const simulator::IndexedMesh& outer) {
  std::vector<std::vector<double>> crossings_mm(static_cast<std::size_t>(size_[1] * size_[2]));
  for (std::size_t index = 0; index < outer.triangles.size(); ++index) {
    const std::array<Vec3, 3> corner_mm = simulator::corners_of(outer, index);
    const Cell low = cell_of(glm::min(glm::min(corner_mm[0], corner_mm[1]), corner_mm[2]));
    const Cell high = cell_of(glm::max(glm::max(corner_mm[0], corner_mm[1]), corner_mm[2]));
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        const Vec3 row_mm = middle_mm({0, y, z});
        const auto x_mm = crossing_x_mm(corner_mm, row_mm.y, row_mm.z);
        if (x_mm) crossings_mm[static_cast<std::size_t>(y * size_[2] + z)].push_back(*x_mm);
      }
    }
  }
  pieces_.assign(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]), no_bone);
  for (std::size_t index = 0; index < pieces_.size(); ++index) {
    const Cell cell = cell_at(index);
    const double x_mm = middle_mm(cell).x;
    const auto& row = crossings_mm[static_cast<std::size_t>(cell[1] * size_[2] + cell[2])];
    const auto before = std::ranges::count_if(row, [&](double at_mm) { return at_mm < x_mm; });
    if (before % 2 == 1) pieces_[index] = no_piece_yet;
  }
}

void BonePieces::part(std::span<const PartingFace> faces) {
  for (std::size_t index = 0; index < pieces_.size(); ++index) {
    if (pieces_[index] != no_piece_yet) continue;
    volumes_mm3_.push_back(grow(index, static_cast<std::int32_t>(volumes_mm3_.size()), faces));
  }
}

/// From one cell to all that hang together with it; their volume.
double BonePieces::grow(std::size_t seed, std::int32_t number, std::span<const PartingFace> faces) {
  std::vector<std::size_t> border{seed};
  pieces_[seed] = number;
  double cells = 0.0;
  while (!border.empty()) {
    const Cell cell = cell_at(border.back());
    border.pop_back();
    cells += 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const std::int64_t step : {-1, 1}) {
        Cell beside = cell;
        beside[axis] += step;
        const std::optional<std::size_t> index = index_of(beside);
        if (!index || pieces_[*index] != no_piece_yet) continue;
        if (is_parted(middle_mm(cell), middle_mm(beside), faces)) continue;
        pieces_[*index] = number;
        border.push_back(*index);
      }
    }
  }
  return cells * cell_mm * cell_mm * cell_mm;
}

std::optional<std::size_t> BonePieces::at(const Vec3& point_in_bone_mm) const noexcept {
  const std::optional<std::size_t> index = index_of(cell_of(point_in_bone_mm));
  if (!index || pieces_[*index] < 0) return std::nullopt;
  return static_cast<std::size_t>(pieces_[*index]);
}

std::optional<std::size_t> BonePieces::near(const Vec3& point_in_bone_mm) const noexcept {
  const Cell middle = cell_of(point_in_bone_mm);
  std::optional<std::size_t> nearest;
  double nearest_mm = static_cast<double>(near_cells) * cell_mm;
  for (std::int64_t x = -near_cells; x <= near_cells; ++x) {
    for (std::int64_t y = -near_cells; y <= near_cells; ++y) {
      for (std::int64_t z = -near_cells; z <= near_cells; ++z) {
        const Vec3 place_mm = middle_mm({middle[0] + x, middle[1] + y, middle[2] + z});
        const std::optional<std::size_t> piece = at(place_mm);
        const double away_mm = length_of(place_mm - point_in_bone_mm);
        if (!piece || away_mm > nearest_mm) continue;
        nearest = piece;
        nearest_mm = away_mm;
      }
    }
  }
  return nearest;
}

Vec3 BonePieces::middle_mm(const Cell& cell) const noexcept {
  return low_mm_ + cell_mm * (Vec3{static_cast<double>(cell[0]), static_cast<double>(cell[1]),
                                   static_cast<double>(cell[2])} +
                              0.5);
}

BonePieces::Cell BonePieces::cell_of(const Vec3& point_mm) const noexcept {
  Cell cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = (point_mm - low_mm_)[axis] / cell_mm;
    cell[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::clamp(
        std::floor(cells), -1.0, static_cast<double>(size_[static_cast<std::size_t>(axis)])));
  }
  return cell;
}

BonePieces::Cell BonePieces::cell_at(std::size_t index) const noexcept {
  const auto at = static_cast<std::int64_t>(index);
  return {at / (size_[1] * size_[2]), at / size_[2] % size_[1], at % size_[2]};
}

std::optional<std::size_t> BonePieces::index_of(const Cell& cell) const noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (cell[axis] < 0 || cell[axis] >= size_[axis]) return std::nullopt;
  }
  return static_cast<std::size_t>((cell[0] * size_[1] + cell[1]) * size_[2] + cell[2]);
}

}  // namespace hallux::scenarios
