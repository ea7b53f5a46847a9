#include "ui/jobs/sawn_bone.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulator/base/progress.h"
#include "simulator/base/units.h"
#include "simulator/cutting/slice/plane_slice.h"
#include "simulator/cutting/solid/commit_patch.h"

namespace hallux::ui {

namespace {

using namespace simulator;

constexpr double field_spacing_mm = 0.05;
/// How far the grid reaches beyond the section: an outline through its outer nodes goes around all of it.
constexpr int margin_nodes = 4;
constexpr double section_limit_mm = 200.0;
/// The same plane again (docs/decisions/0002-a-blade-finds-its-slot.md).
constexpr double rejoin_degree = 0.5;
constexpr double rejoin_mm = 0.1;

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

/// The kerf frame of a plane: its origin near the mesh, its axes along the mesh's where the normal is one of them.
KerfPlane plane_of(const CutGroup& group, const Vec3& middle_mm) {
  const double length = std::sqrt(glm::dot(group.normal, group.normal));
  const Vec3 z = group.normal / length;
  const Vec3 origin_mm = middle_mm + (group.offset / length - glm::dot(z, middle_mm)) * z;
  const Vec3 size(std::abs(z.x), std::abs(z.y), std::abs(z.z));
  const Vec3 y_hint = size.x >= size.y && size.x >= size.z ? Vec3(0.0, 0.0, 1.0)
                      : size.y >= size.z                   ? Vec3(1.0, 0.0, 0.0)
                                                           : Vec3(0.0, 1.0, 0.0);
  const Vec3 x = glm::cross(y_hint, z);
  return {{rotation_from_axes(x / std::sqrt(glm::dot(x, x)), glm::cross(z, x)), origin_mm},
          group.kerf_mm};
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

void expect_field_fits(const FieldGrid& grid, const std::string& name) {
  const double nodes_mm = field_spacing_mm * std::max(grid.u_count, grid.v_count);
  if (nodes_mm <= section_limit_mm + 2.0 * (margin_nodes + 1) * field_spacing_mm) return;
  throw CutInputError(name + ": the plane's section of the mesh is wider than 200 mm; a sweep " +
                      "cuts smaller sections only, check that the mesh is in millimetres");
}

Vec2 far_corner_mm(const FieldGrid& grid) {
  return grid.origin_mm + grid.spacing_mm * Vec2(grid.u_count - 1, grid.v_count - 1);
}

std::optional<BladePath> path_of(const CutGroup& group, const KerfPlane& asked,
                                 const KerfPlane& kerf) {
  if (!group.sweep_file) return std::nullopt;
  return path_in_plane(read_sweep(*group.sweep_file), asked, kerf,
                       group.sweep_file->filename().string());
}

bool is_same_plane(const OpenedKerf& kerf, const KerfPlane& asked) {
  const KerfAxes axes = axes_of(kerf.plane);
  const Vec2 middle_mm = 0.5 * (kerf.grid.origin_mm + far_corner_mm(kerf.grid));
  const Vec3 middle_in_bone_mm = axes.origin_mm + middle_mm.x * axes.x + middle_mm.y * axes.y;
  const KerfAxes asked_axes = axes_of(asked);
  const Vec3 tilt = glm::cross(axes.z, asked_axes.z);
  return kerf.plane.thickness_mm == asked.thickness_mm &&
         std::sqrt(glm::dot(tilt, tilt)) <= radian_from_degree(rejoin_degree) &&
         std::abs(height_mm(asked_axes, middle_in_bone_mm)) <= rejoin_mm;
}

}  // namespace

SawnBone::SawnBone(IndexedMesh mesh)
    : whole_(uncut_solid(std::move(mesh))), solid_(whole_), whole_bvh_(whole_.mesh) {
  const Box box = box_of(whole_.mesh);
  middle_mm_ = 0.5 * (box.min_mm + box.max_mm);
}

double SawnBone::removed_mm3() const noexcept {
  double sum_mm3 = 0.0;
  for (const OpenedKerf& kerf : kerfs_) sum_mm3 += kerf.removed_mm3;
  return sum_mm3;
}

Section SawnBone::section_of_whole(const KerfPlane& plane) const {
  return slice_section(whole_, whole_bvh_, plane);
}

std::optional<std::size_t> SawnBone::place_of_kerf_in(const KerfPlane& asked) const {
  for (std::size_t i = 0; i < kerfs_.size(); ++i) {
    if (is_same_plane(kerfs_[i], asked)) return i;
  }
  return std::nullopt;
}

/// False where the plane misses the bone.
bool SawnBone::begin_kerf(const CutGroup& group, const KerfPlane& asked) {
  const Section section = section_of_whole(asked);
  if (section.regions.empty()) return false;
  OpenedKerf kerf;
  kerf.number = group_count_ - 1;
  kerf.plane = asked;
  kerf.grid = grid_around(section);
  if (group.sweep_file) {
    expect_field_fits(kerf.grid, group.sweep_file->filename().string());
    kerf.field.emplace(kerf.grid);
  }
  kerfs_.push_back(std::move(kerf));
  return true;
}

/// Makes the solid anew without this kerf, which then comes last.
void SawnBone::reopen_kerf(std::size_t place) {
  std::rotate(kerfs_.begin() + static_cast<std::ptrdiff_t>(place),
              kerfs_.begin() + static_cast<std::ptrdiff_t>(place) + 1, kerfs_.end());
  kerfs_.back().removed_mm3 = 0.0;
  solid_ = whole_;
  for (std::size_t i = 0; i + 1 < kerfs_.size(); ++i) {
    if (solid_.mesh.triangles.empty()) {
      kerfs_[i].removed_mm3 = 0.0;
      continue;
    }
    KerfCut cut = cut_opened_kerf(solid_, Bvh(solid_.mesh), kerfs_[i]);
    kerfs_[i].removed_mm3 = cut.removed_mm3;
    solid_ = std::move(cut.solid);
  }
}

void SawnBone::open_last_kerf(const std::optional<BladePath>& path, const Progress& progress,
                              GroupOutcome& outcome) {
  OpenedKerf& kerf = kerfs_.back();
  KerfFrames frames(solid_, kerf, outcome);
  if (path) {
    frames.follow(*path, progress);
  } else {
    frames.open_all();
  }
  KerfCut cut = frames.commit();
  kerf.removed_mm3 = cut.removed_mm3;
  solid_ = std::move(cut.solid);
}

GroupOutcome SawnBone::saw(const CutGroup& group, const Progress& progress) {
  ++group_count_;
  const KerfPlane asked = plane_of(group, middle_mm_);
  const std::optional<std::size_t> place = place_of_kerf_in(asked);
  const std::optional<BladePath> path = path_of(group, asked, place ? kerfs_[*place].plane : asked);
  const double before_mm3 = removed_mm3();
  GroupOutcome outcome;
  if (place) {
    outcome.kerf = kerfs_[*place].number;
    const bool is_through = !kerfs_[*place].field;
    if (is_through) return outcome;
    reopen_kerf(*place);
  } else {
    if (!begin_kerf(group, asked)) return outcome;
    outcome.kerf = kerfs_.back().number;
  }
  if (solid_.mesh.triangles.empty()) return outcome;
  open_last_kerf(path, progress, outcome);
  outcome.removed_mm3 = removed_mm3() - before_mm3;
  return outcome;
}

}  // namespace hallux::ui
