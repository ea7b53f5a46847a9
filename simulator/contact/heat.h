/// Heat in the walls of the kerfs: a temperature and a thermal dose for each square millimetre,
/// followed by what is recorded.
///
///     sample: pose, push, saw on, irrigated --> teeth in bone --> heat into the cells behind them
///                                                                         |
///     each cell every 16th step: exact cooling over the time since <------'
///
/// A cell is a square millimetre of a kerf's plane with both its walls, `wall_depth_mm` deep. All
/// memory is taken at the beginning; a step costs the engaged teeth and a sixteenth of the cells
/// that were ever warmed.
#pragma once

#include <array>
#include <cstdint>

#include "simulator/base/fixed_array.h"
#include "simulator/contact/heat_law.h"
#include "simulator/contact/tissue.h"
#include "simulator/contact/tool_motion.h"

namespace hallux::simulator {

/// The cells of one kerf reach as far as its field: 40 mm to all sides of where the tool was
/// frozen.
inline constexpr std::int32_t heat_cells = 80;
inline constexpr double heat_cell_mm = 1.0;
inline constexpr double heat_cell_volume_mm3 = 2.0 * wall_depth_mm * heat_cell_mm * heat_cell_mm;
/// Marks are set once a patch of so many cells on a side, and taken at most one in
/// `ticks_per_heat_mark`.
inline constexpr std::int32_t heat_patch_cells = 5;
inline constexpr std::int64_t ticks_per_heat_mark = 100;

enum class HeatMarkKind : std::int32_t { Hot, Necrosis };

/// A patch of bone went above 47 degrees, or reached the dose of necrosis, for the first time.
struct HeatMark {
  HeatMarkKind kind = HeatMarkKind::Hot;
  std::int32_t kerf = 0;
  /// The first cell of the patch, in the kerf's plane.
  Vec2 place_mm{0.0, 0.0};
};

/// All of an attempt so far.
struct HeatSummary {
  double hottest_celsius = body_celsius;
  /// -1: no bone above body temperature.
  std::int32_t hottest_kerf = -1;
  Vec2 hottest_place_mm{0.0, 0.0};
  /// Time in which any bone was above 47 degrees.
  double hot_s = 0.0;
  double greatest_dose_min = 0.0;
  double necrotic_mm3 = 0.0;
};

class HeatField {
 public:
  /// Each cell is followed once in so many samples.
  static constexpr std::size_t group_count = 16;

  /// Takes all its memory here. A dull blade rubs as much more as it is less sharp than a new one.
  /// needs   saw.sharpness > 0
  explicit HeatField(const Saw& saw);
  /// Another saw heats from now on.
  void hold(const Saw& saw) noexcept;

  /// Follows the record by one sample: heat where the teeth stand in bone, and the time since the
  /// sample before. While the attempt does not run, time stands still here too.
  /// needs   samples in their order; `bone` as it stands after the sample
  /// errors  none: total, allocates nothing
  /// thread  haptic (and, on its own copy, assessment)
  void apply(const ToolSample& sample, const Wound& bone) noexcept;

  /// The next mark that waits, no sooner than `ticks_per_heat_mark` after the one before.
  bool take_mark(HeatMark& mark) noexcept;
  const HeatSummary& summary() const noexcept { return summary_; }
  /// Of the hottest cell, as each was followed last: within the last `group_count` samples.
  double hottest_now_celsius() const noexcept;
  /// Body temperature and 0 outside the cells.
  double celsius_at(std::int32_t kerf, const Vec2& place_mm) const noexcept;
  /// Of all kerfs, those whose dose lies between the two.
  std::int64_t cells_with_dose(double low_min, double high_min) const noexcept;

 private:
  static constexpr std::int32_t patches_over = heat_cells / heat_patch_cells;

  /// Whether a cell's middle lies in the bone as it was, asked when heat first comes there.
  enum class Place : std::uint8_t { Unknown, Bone, Air };
  /// All its bits are zero before it is visited: see visited().
  struct Cell {
    double celsius = 0.0;
    double dose_min = 0.0;
    /// Since the cell was followed last.
    double heat_joule = 0.0;
    Place place = Place::Unknown;
  };
  /// The cells of one kerf that were ever warmed: all that need to be followed.
  struct Warmed {
    std::int32_t u_first = heat_cells, u_last = -1, v_first = heat_cells, v_last = -1;
  };
  enum class PatchState : std::uint8_t { Quiet, Waiting, Said };
  struct Patch {
    PatchState state = PatchState::Quiet;
    std::int32_t cell = 0;
  };

  /// Which tissue each tooth is about to cut.
  struct Teeth {
    std::array<Tissue, tooth_count> tissue{};
    int engaged = 0;
  };
  /// What the saw gives to a kerf in one sample: the blade in its plane and the teeth in its
  /// fragment, the friction of each of them, and the way cut.
  struct Stroke {
    std::int32_t kerf = -1;
    PlanarPose pose;
    Teeth teeth;
    double tooth_friction_joule = 0.0;
    double advance_mm = 0.0;
  };

  void heat(const ToolSample& sample, const Wound& bone, double span_s) noexcept;
  Teeth teeth_in(std::int32_t kerf, const PlanarPose& pose, const Wound& bone) noexcept;
  void rub(const Stroke& stroke, const Wound& bone) noexcept;
  void add_heat(std::int32_t kerf, const Wound& bone, const Vec2& place_mm, double joule) noexcept;
  void add_to_cell(std::int32_t kerf, std::int32_t number, double joule) noexcept;
  bool is_bone_cell(std::int32_t kerf, std::int32_t number, const Wound& bone) noexcept;
  void cool(const KerfNumbers& rinsed_kerfs) noexcept;
  void update_cell(std::int32_t kerf, std::int32_t number, const Cooling& cooling,
                   double span_s) noexcept;
  void mark(HeatMarkKind kind, std::int32_t kerf, std::int32_t number) noexcept;
  std::int32_t cell_at(const Vec2& place_mm) const noexcept;
  /// Of body temperature the first time.
  Cell& visited(std::int32_t kerf, std::int32_t number) noexcept;

  Blade blade_;
  double tooth_speed_mm_s_ = 0.0;
  double friction_ = 0.0;
  /// Kerf by kerf, v running fastest.
  ZeroedArray<Cell> cells_;
  /// Kind by kind, kerf by kerf.
  FixedArray<Patch> patches_;
  std::array<Warmed, static_cast<std::size_t>(kerf_limit)> warmed_{};
  /// Per group of rows: time to be followed.
  std::array<double, group_count> since_s_{};
  /// Per group, when it was followed last.
  std::array<double, group_count> hottest_celsius_;
  OfFragments<std::array<TissueMemory, tooth_count>> teeth_{};
  HeatSummary summary_;
  std::size_t next_group_ = 0;
  std::int64_t last_tick_ = -1, mark_tick_ = 0;
  std::int32_t waiting_ = 0, hot_cells_ = 0;
  std::int32_t last_kerf_ = -1;
  PlanarPose last_pose_;
};

}  // namespace hallux::simulator
