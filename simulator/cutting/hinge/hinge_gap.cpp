/// Section and opened region are cut into rows across the hinge's line; in a row both are sorted
/// crossings, and the bridge is what the bone has beyond the furthest opened one. Rows stand in the
/// middles of steps, where edges along a row are rare. Distances are said along the hinge's own two
/// directions, in a tilted kerf too: that is what was planned and what a ruler would show.
#include "simulator/cutting/hinge/hinge_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "simulator/cutting/slice/plane_slice.h"

namespace hallux::simulator {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// The area that a unit of plane covers, seen along both of the hinge's directions; a plane steeper
/// than this against them has no bridge to speak of.
constexpr double least_area = 0.4;

/// Places in the kerf's plane, said along the hinge's line (x) and outward (y), from the hinge's
/// point.
struct RowFrame {
  Vec2 along_of{1.0, 0.0}, outward_of{0.0, 1.0};  ///< what a step in the plane adds
  Vec2 origin_mm{0.0, 0.0};                       ///< of the plane's own frame, said in this one
  double area = 1.0;

  Vec2 from_plane(const Vec2& place_mm) const noexcept {
    return origin_mm + Vec2(glm::dot(along_of, place_mm), glm::dot(outward_of, place_mm));
  }
  Vec2 to_plane(const Vec2& said_mm) const noexcept {
    const Vec2 arm_mm = said_mm - origin_mm;
    return Vec2(outward_of.y * arm_mm.x - along_of.y * arm_mm.y,
                along_of.x * arm_mm.y - outward_of.x * arm_mm.x) /
           area;
  }
};

std::optional<RowFrame> row_frame(const KerfAxes& axes, const HingeLine& line) noexcept {
  RowFrame frame;
  frame.along_of = Vec2(glm::dot(line.axis, axes.x), glm::dot(line.axis, axes.y));
  frame.outward_of = Vec2(glm::dot(line.outward, axes.x), glm::dot(line.outward, axes.y));
  const Vec3 arm_mm = axes.origin_mm - line.point_in_bone_mm;
  frame.origin_mm = Vec2(glm::dot(line.axis, arm_mm), glm::dot(line.outward, arm_mm));
  frame.area = frame.along_of.x * frame.outward_of.y - frame.along_of.y * frame.outward_of.x;
  if (!(std::abs(frame.area) >= least_area)) return std::nullopt;
  return frame;
}

struct Extent {
  double low_mm = infinity, high_mm = -infinity;
};

/// The rows at which loops are looked at: in the middles of steps, so that rows along edges of the
/// section are rare.
struct RowGrid {
  double first_mm = 0.0;
  std::size_t count = 0;

  double along_mm(std::size_t row) const noexcept {
    return first_mm + (static_cast<double>(row) + 0.5) * hinge_row_step_mm;
  }
};

/// Where loops cross each row, ascending: a row is inside between the first and the second
/// crossing, and so on.
class RowCrossings {
 public:
  RowCrossings(const RowFrame& frame, const RowGrid& grid) noexcept
      : frame_(frame), grid_(grid), crossings_mm_(grid.count) {}

  void add_loop(std::span<const Vec2> corners_mm) {
    for (std::size_t i = 0; i < corners_mm.size(); ++i) {
      add_edge(frame_.from_plane(corners_mm[i]),
               frame_.from_plane(corners_mm[(i + 1) % corners_mm.size()]));
    }
  }
  void sort() {
    for (std::vector<double>& row : crossings_mm_) std::sort(row.begin(), row.end());
  }
  const std::vector<double>& row(std::size_t index) const noexcept { return crossings_mm_[index]; }

 private:
  void add_edge(const Vec2& a, const Vec2& b) {
    const auto [low_mm, high_mm] = std::minmax(a.x, b.x);
    const double before = std::floor((low_mm - grid_.first_mm) / hinge_row_step_mm) - 1.0;
    const double count = static_cast<double>(grid_.count);
    for (auto row = static_cast<std::size_t>(std::clamp(before, 0.0, count)); row < grid_.count;
         ++row) {
      const double along_mm = grid_.along_mm(row);
      if (along_mm > high_mm) return;
      if ((a.x > along_mm) == (b.x > along_mm)) continue;
      crossings_mm_[row].push_back(a.y + (along_mm - a.x) / (b.x - a.x) * (b.y - a.y));
    }
  }

  const RowFrame& frame_;
  RowGrid grid_;
  std::vector<std::vector<double>> crossings_mm_;
};

RowGrid grid_over(const Section& section, const RowFrame& frame) noexcept {
  Extent extent;
  for (const SectionRegion& region : section.regions) {
    for (const Contour& contour : region.contours) {
      for (const Vec2& corner_mm : contour) {
        const double along_mm = frame.from_plane(corner_mm).x;
        extent.low_mm = std::min(extent.low_mm, along_mm);
        extent.high_mm = std::max(extent.high_mm, along_mm);
      }
    }
  }
  if (!(extent.low_mm < extent.high_mm)) return {};
  const double steps = std::ceil((extent.high_mm - extent.low_mm) / hinge_row_step_mm);
  return {extent.low_mm, static_cast<std::size_t>(steps)};
}

RowCrossings crossings_of(const Section& section, const RowFrame& frame, const RowGrid& grid) {
  RowCrossings bone(frame, grid);
  for (const SectionRegion& region : section.regions) {
    for (const Contour& contour : region.contours) bone.add_loop(contour);
  }
  bone.sort();
  return bone;
}

RowCrossings crossings_of(const RegionOutline& outline, const RowFrame& frame,
                          const RowGrid& grid) {
  RowCrossings opened(frame, grid);
  const std::span<const Vec2> corners_mm(outline.corners_mm);
  std::size_t first = 0;
  for (const std::uint32_t end : outline.loop_ends) {
    opened.add_loop(corners_mm.subspan(first, end - first));
    first = end;
  }
  opened.sort();
  return opened;
}

HingeRow measure_row(double along_mm, const std::vector<double>& bone_mm,
                     const std::vector<double>& opened_mm) noexcept {
  HingeRow row;
  row.along_mm = along_mm;
  row.far_mm = bone_mm.back();
  row.is_opened = !opened_mm.empty() && opened_mm.back() > bone_mm.front();
  row.tip_mm = row.is_opened ? opened_mm.back() : bone_mm.front();
  for (std::size_t i = 0; i + 1 < bone_mm.size(); i += 2) {
    row.intact_mm += std::max(0.0, bone_mm[i + 1] - std::max(bone_mm[i], row.tip_mm));
  }
  return row;
}

Vec3 place_in_bone(const KerfAxes& axes, const RowFrame& frame, double along_mm,
                   double outward_mm) noexcept {
  const Vec2 place = frame.to_plane(Vec2(along_mm, outward_mm));
  return axes.origin_mm + place.x * axes.x + place.y * axes.y;
}

/// The row's intact bone as if its far surface lay at `far_mm`; below 0 where the kerf passed even
/// that.
double intact_to(const HingeRow& row, double far_mm) noexcept {
  return row.intact_mm + (far_mm - std::max(row.far_mm, row.tip_mm));
}

void conclude(HingeGap& gap, const KerfAxes& axes, const RowFrame& frame, double planned_mm) {
  const HingeRow outermost =
      *std::max_element(gap.rows.begin(), gap.rows.end(),
                        [](const HingeRow& a, const HingeRow& b) { return a.far_mm < b.far_mm; });
  const HingeRow *thinnest = nullptr, *deepest = nullptr;
  Vec2 sum_mm(0.0);
  double apex_rows = 0.0;
  for (HingeRow& row : gap.rows) {
    row.is_apex = row.far_mm >= outermost.far_mm - planned_mm;
    if (row.is_opened && (deepest == nullptr || row.tip_mm > deepest->tip_mm)) deepest = &row;
    if (!row.is_apex) continue;
    gap.is_opened = gap.is_opened || row.is_opened;
    sum_mm += Vec2(row.along_mm, row.tip_mm);
    apex_rows += 1.0;
    const bool is_thinner = thinnest == nullptr || intact_to(row, outermost.far_mm) <
                                                       intact_to(*thinnest, outermost.far_mm);
    if (is_thinner) thinnest = &row;
  }
  gap.thickness_mm = std::max(0.0, intact_to(*thinnest, outermost.far_mm));
  const HingeRow* tip = thinnest;
  if (deepest != nullptr && deepest->tip_mm > outermost.far_mm) {
    gap.over_cut_mm = deepest->tip_mm - outermost.far_mm;
    tip = deepest;
  }
  gap.tip_in_bone_mm = place_in_bone(axes, frame, tip->along_mm, tip->tip_mm);
  gap.far_in_bone_mm = place_in_bone(axes, frame, outermost.along_mm, outermost.far_mm);
  gap.middle_in_bone_mm = place_in_bone(axes, frame, sum_mm.x / apex_rows, sum_mm.y / apex_rows);
}

}  // namespace

std::optional<HingeGap> measure_hinge_gap(const Section& section, const RegionOutline& opened,
                                          const HingeLine& line) {
  const KerfAxes axes = axes_of(section.plane);
  const std::optional<RowFrame> frame = row_frame(axes, line);
  if (!frame) return std::nullopt;
  const RowGrid grid = grid_over(section, *frame);
  const RowCrossings bone = crossings_of(section, *frame, grid);
  const RowCrossings kerf = crossings_of(opened, *frame, grid);
  HingeGap gap;
  for (std::size_t i = 0; i < grid.count; ++i) {
    if (bone.row(i).size() < 2) continue;
    gap.rows.push_back(measure_row(grid.along_mm(i), bone.row(i), kerf.row(i)));
  }
  if (gap.rows.empty()) return std::nullopt;
  conclude(gap, axes, *frame, line.thickness_mm);
  return gap;
}

}  // namespace hallux::simulator
