/// A cell's temperature follows one linear law with a constant source over a short span, and that
/// has an exact solution: so cells may be followed every sixteenth step, row group by row group,
/// without a step size that could become unstable. Heat goes to the cells behind the teeth, shared
/// by two neighbours along the tooth line. Only cells that were ever warmed are visited.
#include "simulator/contact/heat.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"
#include "simulator/contact/blade_probe.h"
#include "simulator/record/sample_force.h"

namespace hallux::simulator {

namespace {

constexpr std::int32_t cells_per_kerf = heat_cells * heat_cells;
constexpr double grid_half_mm = 0.5 * heat_cell_mm * heat_cells;
constexpr double cell_capacity_joule_per_kelvin =
    bone_heat_joule_per_mm3_kelvin * heat_cell_volume_mm3;
/// Places behind each tooth at which its share of the heat is put.
constexpr int rubbing_parts = 4;
RigidTransform blade_in_plane(const KerfPlane& plane, const PlanarPose& pose) noexcept {
  const Vec3 ahead{pose.direction, 0.0}, along{-pose.direction.y, pose.direction.x, 0.0};
  return plane.bone_from_kerf *
         RigidTransform{rotation_from_axes(ahead, along), Vec3{pose.tip_mm, 0.0}};
}

/// The hand's push along the feed direction, as the record has it [N].
double push_newton(const ToolSample& sample) noexcept {
  const Vec3 ahead = axis_x(transform_from(sample.world_from_tool));
  return std::max(0.0, -glm::dot(force_newton(sample), ahead));
}

Vec2 middle_of(std::int32_t number) noexcept {
  const std::int32_t u = number / heat_cells;
  const std::int32_t v = number % heat_cells;
  return {(u + 0.5) * heat_cell_mm - grid_half_mm, (v + 0.5) * heat_cell_mm - grid_half_mm};
}

bool is_within(std::int32_t index) noexcept { return index >= 0 && index < heat_cells; }

/// floor as an index; what is far outside, or nowhere, stays outside.
std::int32_t index_of(double cells) noexcept {
  if (!(cells > -1.0)) return -1;
  return static_cast<std::int32_t>(std::floor(std::min(cells, heat_cells + 1.0)));
}

/// Where a kerf's cell of that number stands among all cells.
std::size_t cell_of(std::int32_t kerf, std::int32_t number) noexcept {
  return static_cast<std::size_t>(kerf) * cells_per_kerf + static_cast<std::size_t>(number);
}

}  // namespace

HeatField::HeatField(const Saw& saw)
    : cells_(static_cast<std::size_t>(kerf_limit) * cells_per_kerf),
      patches_(static_cast<std::size_t>(2 * kerf_limit * patches_over * patches_over)) {
  hottest_celsius_.fill(body_celsius);
  hold(saw);
}

void HeatField::hold(const Saw& saw) noexcept {
  blade_ = saw.blade;
  tooth_speed_mm_s_ = mean_tooth_speed_mm_s(saw.blade.depth_mm, saw.cycles_per_minute);
  friction_ = saw_friction / saw.sharpness;
}

HeatField::Cell& HeatField::visited(std::int32_t kerf, std::int32_t number) noexcept {
  Cell& cell = cells_[cell_of(kerf, number)];
  if (!(cell.celsius > 0.0)) cell.celsius = body_celsius;
  return cell;
}

std::int32_t HeatField::cell_at(const Vec2& place_mm) const noexcept {
  const std::int32_t u = index_of((place_mm.x + grid_half_mm) / heat_cell_mm);
  const std::int32_t v = index_of((place_mm.y + grid_half_mm) / heat_cell_mm);
  return is_within(u) && is_within(v) ? u * heat_cells + v : -1;
}

double HeatField::celsius_at(std::int32_t kerf, const Vec2& place_mm) const noexcept {
  const std::int32_t number = cell_at(place_mm);
  if (number < 0) return body_celsius;
  const double celsius = cells_[cell_of(kerf, number)].celsius;
  return celsius > 0.0 ? celsius : body_celsius;
}

std::int64_t HeatField::cells_with_dose(double low_min, double high_min) const noexcept {
  return std::count_if(cells_.begin(), cells_.end(), [&](const Cell& cell) {
    return cell.dose_min >= low_min && cell.dose_min <= high_min;
  });
}

double HeatField::hottest_now_celsius() const noexcept {
  return *std::max_element(hottest_celsius_.begin(), hottest_celsius_.end());
}

void HeatField::apply(const ToolSample& sample, const Wound& bone) noexcept {
  const std::int64_t ticks =
      std::clamp<std::int64_t>(sample.tick - last_tick_, 0, ticks_per_line_max);
  last_tick_ = sample.tick;
  if (!has(sample.status, ToolStatus::Running)) {
    last_kerf_ = -1;
    return;
  }
  const double span_s = static_cast<double>(ticks) * step_s;
  heat(sample, bone, span_s);
  if (hot_cells_ > 0) summary_.hot_s += span_s;
  for (double& since_s : since_s_) since_s += span_s;
  const bool is_rinsed = has(sample.status, ToolStatus::Irrigated) && sample.kerf >= 0;
  cool(is_rinsed ? bone.kerfs().one_cut_with(sample.kerf) : KerfNumbers{});
}

void HeatField::heat(const ToolSample& sample, const Wound& bone, double span_s) noexcept {
  const bool is_same_kerf = sample.kerf >= 0 && sample.kerf == last_kerf_;
  last_kerf_ = sample.kerf;
  if (sample.kerf < 0) return;
  const KerfSet& kerfs = bone.kerfs();
  const RigidTransform world_from_tool = transform_from(sample.world_from_tool);
  const auto pose_in = [&](std::int32_t kerf) {
    const FragmentPose& fragment = kerfs.fragments()[kerfs.fragment_of(kerf)];
    return planar_pose(kerfs.plane(kerf), fragment.fragment_from_world * world_from_tool);
  };
  const PlanarPose pose = pose_in(sample.kerf);
  const Vec2 way_mm = is_same_kerf ? pose.tip_mm - last_pose_.tip_mm : Vec2{0.0, 0.0};
  last_pose_ = pose;
  const bool rubs =
      has(sample.status, ToolStatus::SawOn) && has(sample.status, ToolStatus::InContact);
  if (!rubs) return;
  // Newton times millimetre are thousandths of a joule.
  const double friction_joule =
      0.001 * friction_ * push_newton(sample) * tooth_speed_mm_s_ * span_s;
  const double advance_mm = std::max(0.0, glm::dot(way_mm, pose.direction));
  const KerfNumbers cut = kerfs.one_cut_with(sample.kerf);
  std::array<Teeth, static_cast<std::size_t>(kerf_limit)> teeth;
  int engaged = 0;
  for (const std::int32_t kerf : cut) {
    Teeth& own = teeth[static_cast<std::size_t>(kerf)];
    own = teeth_in(kerf, pose_in(kerf), bone);
    engaged += own.engaged;
  }
  if (engaged == 0) return;
  for (const std::int32_t kerf : cut) {
    rub({kerf, pose_in(kerf), teeth[static_cast<std::size_t>(kerf)], friction_joule / engaged,
         advance_mm},
        bone);
  }
}

/// As they stand in a kerf's fragment.
HeatField::Teeth HeatField::teeth_in(std::int32_t kerf, const PlanarPose& pose,
                                     const Wound& bone) noexcept {
  Teeth teeth;
  const WoundFragment& standing = bone.fragment_of_kerf(kerf);
  auto& memory = teeth_[static_cast<std::size_t>(bone.kerfs().fragment_of(kerf))];
  const auto points =
      tooth_points(blade_in_plane(bone.kerfs().plane(kerf), pose), bone.blade(), probe_ahead_mm);
  for (std::size_t tooth = 0; tooth < tooth_count; ++tooth) {
    teeth.tissue[tooth] = standing.tissue.at(points[tooth], memory[tooth]);
    if (is_bone(teeth.tissue[tooth])) ++teeth.engaged;
  }
  return teeth;
}

/// The heat of each engaged tooth goes to the walls behind it.
void HeatField::rub(const Stroke& stroke, const Wound& bone) noexcept {
  const PlanarPose& pose = stroke.pose;
  const Teeth& teeth = stroke.teeth;
  const Vec2 along{-pose.direction.y, pose.direction.x};
  const double share_mm = blade_.width_mm / static_cast<double>(tooth_count);
  for (std::size_t tooth = 0; tooth < tooth_count; ++tooth) {
    if (!is_bone(teeth.tissue[tooth])) continue;
    const double cutting_joule = cutting_work_joule_per_mm3(teeth.tissue[tooth]) * blade_.kerf_mm *
                                 share_mm * stroke.advance_mm;
    const double joule = wall_share * (stroke.tooth_friction_joule + cutting_joule) / rubbing_parts;
    const double aside_mm = (static_cast<double>(tooth) + 0.5) * share_mm - 0.5 * blade_.width_mm;
    const Vec2 tooth_mm = pose.tip_mm + aside_mm * along;
    for (int part = 0; part < rubbing_parts; ++part) {
      const double back_mm = (part + 0.5) * rubbing_length_mm / rubbing_parts;
      add_heat(stroke.kerf, bone, tooth_mm - back_mm * pose.direction, joule);
    }
  }
}

/// Along the tooth line the heat is shared by the two nearest cells, else teeth that stand closer
/// than cells would warm some of them twice as much as others. What rubs in air warms nothing.
void HeatField::add_heat(std::int32_t kerf, const Wound& bone, const Vec2& place_mm,
                         double joule) noexcept {
  const double v_cells = (place_mm.y + grid_half_mm) / heat_cell_mm - 0.5;
  const double upper_share = v_cells - std::floor(v_cells);
  const Vec2 down_mm{0.0, upper_share * heat_cell_mm};
  const std::int32_t lower = cell_at(place_mm - down_mm);
  const std::int32_t upper = cell_at(place_mm - down_mm + Vec2{0.0, heat_cell_mm});
  const bool has_lower = is_bone_cell(kerf, lower, bone);
  const bool has_upper = is_bone_cell(kerf, upper, bone);
  if (!has_lower && !has_upper) return;
  const double share = !has_lower ? 1.0 : (has_upper ? upper_share : 0.0);
  add_to_cell(kerf, lower, (1.0 - share) * joule);
  add_to_cell(kerf, upper, share * joule);
}

bool HeatField::is_bone_cell(std::int32_t kerf, std::int32_t number, const Wound& bone) noexcept {
  if (number < 0) return false;
  Place& place = visited(kerf, number).place;
  if (place == Place::Unknown) {
    const Vec3 middle_mm =
        transform_point(bone.kerfs().plane(kerf).bone_from_kerf, Vec3{middle_of(number), 0.0});
    const TissueMap& original = bone.fragment_of_kerf(kerf).tissue.original;
    place = original.clearance_mm(middle_mm) < 0.0 ? Place::Bone : Place::Air;
  }
  return place == Place::Bone;
}

void HeatField::add_to_cell(std::int32_t kerf, std::int32_t number, double joule) noexcept {
  if (number < 0 || !(joule > 0.0)) return;
  visited(kerf, number).heat_joule += joule;
  const std::int32_t u = number / heat_cells, v = number % heat_cells;
  Warmed& warmed = warmed_[static_cast<std::size_t>(kerf)];
  warmed.u_first = std::min(warmed.u_first, u);
  warmed.u_last = std::max(warmed.u_last, u);
  warmed.v_first = std::min(warmed.v_first, v);
  warmed.v_last = std::max(warmed.v_last, v);
}

/// Every sixteenth row, in turn.
void HeatField::cool(const KerfNumbers& rinsed_kerfs) noexcept {
  const std::size_t group = next_group_;
  next_group_ = (next_group_ + 1) % group_count;
  const double span_s = since_s_[group];
  if (!(span_s > 0.0)) return;
  since_s_[group] = 0.0;
  hottest_celsius_[group] = body_celsius;
  const Cooling dry = cooling_over(span_s, false), rinsed = cooling_over(span_s, true);
  constexpr auto stride = static_cast<std::int32_t>(group_count);
  for (std::int32_t kerf = 0; kerf < kerf_limit; ++kerf) {
    const Warmed& warmed = warmed_[static_cast<std::size_t>(kerf)];
    for (auto u = static_cast<std::int32_t>(group); u <= warmed.u_last; u += stride) {
      if (u < warmed.u_first) continue;
      for (std::int32_t v = warmed.v_first; v <= warmed.v_last; ++v) {
        const std::int32_t number = u * heat_cells + v;
        update_cell(kerf, number, rinsed_kerfs.has(kerf) ? rinsed : dry, span_s);
        hottest_celsius_[group] = std::max(hottest_celsius_[group], visited(kerf, number).celsius);
      }
    }
  }
}

void HeatField::update_cell(std::int32_t kerf, std::int32_t number, const Cooling& cooling,
                            double span_s) noexcept {
  Cell& cell = visited(kerf, number);
  const double before_celsius = cell.celsius, before_min = cell.dose_min;
  const double heating_celsius_per_s = cell.heat_joule / (cell_capacity_joule_per_kelvin * span_s);
  cell.heat_joule = 0.0;
  cell.celsius = warmed_celsius(before_celsius, heating_celsius_per_s, cooling);
  cell.dose_min += dose_rate(0.5 * (before_celsius + cell.celsius)) * span_s / 60.0;

  if (cell.celsius > summary_.hottest_celsius) {
    summary_.hottest_celsius = cell.celsius;
    summary_.hottest_kerf = kerf;
    summary_.hottest_place_mm = middle_of(number);
  }
  summary_.greatest_dose_min = std::max(summary_.greatest_dose_min, cell.dose_min);
  const bool was_hot = before_celsius > hot_celsius, is_hot = cell.celsius > hot_celsius;
  if (is_hot != was_hot) hot_cells_ += is_hot ? 1 : -1;
  if (is_hot && !was_hot) mark(HeatMarkKind::Hot, kerf, number);
  if (before_min < necrosis_dose_min && cell.dose_min >= necrosis_dose_min) {
    summary_.necrotic_mm3 += heat_cell_volume_mm3;
    mark(HeatMarkKind::Necrosis, kerf, number);
  }
}

void HeatField::mark(HeatMarkKind kind, std::int32_t kerf, std::int32_t number) noexcept {
  const std::int32_t u = number / heat_cells / heat_patch_cells;
  const std::int32_t v = number % heat_cells / heat_patch_cells;
  const std::int32_t which =
      ((static_cast<std::int32_t>(kind) * kerf_limit + kerf) * patches_over + u) * patches_over + v;
  Patch& patch = patches_[static_cast<std::size_t>(which)];
  if (patch.state != PatchState::Quiet) return;
  patch = {PatchState::Waiting, number};
  ++waiting_;
}

bool HeatField::take_mark(HeatMark& mark) noexcept {
  if (waiting_ == 0 || last_tick_ < mark_tick_) return false;
  const auto found = std::find_if(patches_.begin(), patches_.end(), [](const Patch& patch) {
    return patch.state == PatchState::Waiting;
  });
  const auto which = static_cast<std::int32_t>(found - patches_.begin());
  constexpr std::int32_t patches_per_kerf = patches_over * patches_over;
  mark.kind = static_cast<HeatMarkKind>(which / (kerf_limit * patches_per_kerf));
  mark.kerf = which / patches_per_kerf % kerf_limit;
  mark.place_mm = middle_of(found->cell);
  found->state = PatchState::Said;
  --waiting_;
  mark_tick_ = last_tick_ + ticks_per_heat_mark;
  return true;
}

}  // namespace hallux::simulator
