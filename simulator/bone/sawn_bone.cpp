/// A plane asked for again within half a degree and a tenth of a millimetre is the kerf that is
/// there: it is moved to the end of the order and goes on from its own field. A blade's field lies
/// around the section of the whole bone, so it need not grow when other kerfs have taken parts
/// away.
#include "simulator/bone/sawn_bone.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulator/base/units.h"
#include "simulator/cutting/slice/plane_slice.h"
#include "simulator/mesh/mesh_error.h"

namespace hallux::simulator {

namespace {

constexpr double field_spacing_mm = 0.05;
/// How far the grid reaches beyond the section: an outline through its outer nodes goes around all
/// of it.
constexpr int margin_nodes = 4;
constexpr double section_limit_mm = 200.0;
/// The same plane again (docs/decisions/0002-a-blade-finds-its-slot.md).
constexpr double rejoin_degree = 0.5;
constexpr double rejoin_mm = 0.1;
constexpr std::uint32_t nudges_at_most = 8;  // as cut_kerf promises

struct Box {
  Vec3 min_mm{0.0, 0.0, 0.0}, max_mm{0.0, 0.0, 0.0};
};

Box box_of(const IndexedMesh& mesh) {
  Box box{mesh.points_mm.front(), mesh.points_mm.front()};
  for (const Vec3& point_mm : mesh.points_mm) {
    box.min_mm = glm::min(box.min_mm, point_mm);
    box.max_mm = glm::max(box.max_mm, point_mm);
  }
  return box;
}

FieldGrid grid_around(const Section& section) {
  Vec2 min_mm = section.regions.front().min_mm, max_mm = section.regions.front().max_mm;
  for (const SectionRegion& region : section.regions) {
    min_mm = glm::min(min_mm, region.min_mm);
    max_mm = glm::max(max_mm, region.max_mm);
  }
  const auto nodes = [](double length_mm) {
    return static_cast<std::int32_t>(std::ceil(length_mm / field_spacing_mm)) + 2 * margin_nodes +
           1;
  };
  return {min_mm - Vec2(margin_nodes * field_spacing_mm), field_spacing_mm,
          nodes(max_mm.x - min_mm.x), nodes(max_mm.y - min_mm.y)};
}

bool is_too_wide(const FieldGrid& grid) noexcept {
  const double nodes_mm = field_spacing_mm * std::max(grid.u_count, grid.v_count);
  return nodes_mm > section_limit_mm + 2.0 * (margin_nodes + 1) * field_spacing_mm;
}

Vec2 far_corner_mm(const FieldGrid& grid) {
  return grid.origin_mm + grid.spacing_mm * Vec2(grid.u_count - 1, grid.v_count - 1);
}

bool is_same_plane(const OpenedKerf& kerf, const KerfPlane& asked) {
  const KerfAxes axes = axes_of(kerf.plane);
  const Vec2 middle_mm = 0.5 * (kerf.grid.origin_mm + far_corner_mm(kerf.grid));
  const Vec3 middle_in_bone_mm = axes.origin_mm + middle_mm.x * axes.x + middle_mm.y * axes.y;
  const KerfAxes asked_axes = axes_of(asked);
  return kerf.plane.thickness_mm == asked.thickness_mm &&
         length_of(glm::cross(axes.z, asked_axes.z)) <= radian_from_degree(rejoin_degree) &&
         std::abs(height_mm(asked_axes, middle_in_bone_mm)) <= rejoin_mm;
}

RegionOutline outline_around(const FieldGrid& grid) {
  const Vec2 low = grid.origin_mm, high = far_corner_mm(grid);
  return {{low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)}, {4}};
}

}  // namespace

SawnBone::SawnBone(IndexedMesh mesh) : bone_(std::move(mesh)) {
  const Box box = box_of(bone_.whole().mesh);
  middle_mm_ = 0.5 * (box.min_mm + box.max_mm);
}

/// The frame's axes lie along the mesh's where the normal is one of them.
KerfPlane SawnBone::plane_of(const Vec3& normal, double offset, double kerf_mm) const {
  const double length = length_of(normal);
  const Vec3 z = normal / length;
  const Vec3 origin_mm = middle_mm_ + (offset / length - glm::dot(z, middle_mm_)) * z;
  const Vec3 size(std::abs(z.x), std::abs(z.y), std::abs(z.z));
  const Vec3 y_hint = size.x >= size.y && size.x >= size.z ? Vec3(0.0, 0.0, 1.0)
                      : size.y >= size.z                   ? Vec3(1.0, 0.0, 0.0)
                                                           : Vec3(0.0, 1.0, 0.0);
  const Vec3 x = glm::cross(y_hint, z);
  return {{rotation_from_axes(unit(x), glm::cross(z, x)), origin_mm}, kerf_mm};
}

std::optional<std::size_t> SawnBone::find_kerf(const KerfPlane& asked) const {
  for (std::size_t place = 0; place < kerf_count(); ++place) {
    if (is_same_plane(kerf(place), asked)) return place;
  }
  return std::nullopt;
}

const OpenedKerf* SawnBone::find_number(std::size_t number) const noexcept {
  for (std::size_t place = 0; place < kerf_count(); ++place) {
    if (kerf(place).number == static_cast<std::int32_t>(number)) return &kerf(place);
  }
  return nullptr;
}

BegunKerf SawnBone::begin(const KerfPlane& asked, bool is_swept) {
  const std::size_t number = begun_count_++;
  const std::optional<std::size_t> place = find_kerf(asked);
  if (!place) return begin_new(number, asked, is_swept);
  const auto first = static_cast<std::size_t>(kerf(*place).number);
  if (!fields_[*place]) return {first, false};
  const auto moved = fields_.begin() + static_cast<std::ptrdiff_t>(*place);
  std::rotate(moved, moved + 1, fields_.end());
  bone_.move_last(static_cast<std::int32_t>(*place));
  return {first, is_bone_left()};
}

BegunKerf SawnBone::begin_new(std::size_t number, const KerfPlane& asked, bool is_swept) {
  const Section section = section_of_whole(asked);
  if (section.regions.empty()) return {std::nullopt, false};
  const FieldGrid grid = grid_around(section);
  if (is_swept && is_too_wide(grid)) {
    throw MeshError(
        "the plane's section of the mesh is wider than 200 mm; a sweep cuts smaller "
        "sections only, check that the mesh is in millimetres");
  }
  fields_.emplace_back();
  if (is_swept) fields_.back().emplace(grid);
  bone_.put_kerf(bone_.kerf_count(), {static_cast<std::int32_t>(number), asked, grid, {}});
  return {number, is_bone_left()};
}

bool SawnBone::is_bone_left() { return !bone_.before(last()).solid.mesh.triangles.empty(); }

SolidWithTree SawnBone::stands() { return bone_.before(last()); }

RegionOutline SawnBone::open_all() {
  fields_.back().reset();
  return outline_around(begun().grid);
}

const KerfTally& SawnBone::commit(RegionOutline region) {
  OpenedKerf opened = begun();
  opened.region = std::move(region);
  bone_.put_kerf(last(), std::move(opened));
  return bone_.cut(last());
}

double SawnBone::removed_mm3() {
  double sum_mm3 = 0.0;
  for (std::int32_t place = 0; place <= last(); ++place) sum_mm3 += bone_.cut(place).removed_mm3;
  return sum_mm3;
}

std::optional<std::size_t> SawnBone::refused_kerf() {
  for (std::int32_t place = 0; place <= last(); ++place) {
    if (bone_.cut(place).nudges > nudges_at_most)
      return static_cast<std::size_t>(bone_.kerf(place).number);
  }
  return std::nullopt;
}

Section SawnBone::section_of_whole(const KerfPlane& plane) {
  const SolidWithTree whole = bone_.before(0);
  return slice_section(whole.solid, whole.bvh, plane);
}

}  // namespace hallux::simulator
