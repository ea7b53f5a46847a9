#include "simulator/cutting/field/field_rim.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace hallux::simulator {

namespace {

constexpr double node_margin = 0.001;  // of the spacing: as the outline's

class RimWalk {
 public:
  RimWalk(const KerfField& field, const Vec2& point_mm, double within_mm,
          double (*visit)(void*, const RimSegment&), void* context) noexcept
      : field_(field),
        place_((point_mm - field.grid().origin_mm) / field.grid().spacing_mm),
        within_(within_mm / field.grid().spacing_mm),
        visit_(visit),
        context_(context) {}

  void walk() noexcept {
    const std::int32_t columns = field_.grid().u_count - 1;
    const double middle = std::clamp(std::floor(place_.x), 0.0, static_cast<double>(columns - 1));
    const auto start = static_cast<std::int32_t>(middle);
    for (std::int32_t u = start; u < columns && is_near(u); ++u) {
      if (is_untouched(u)) {
        u = last_of_tile(u);
      } else {
        walk_column(u);
      }
    }
    for (std::int32_t u = start - 1; u >= 0 && is_near(u); --u) {
      if (!is_untouched(u)) walk_column(u);
    }
  }

 private:
  /// In node spacings, as all of the walk.
  double away_in_u(std::int32_t u) const noexcept {
    return std::max({static_cast<double>(u) - place_.x, place_.x - (u + 1.0), 0.0});
  }
  bool is_near(std::int32_t u) const noexcept { return away_in_u(u) < within_; }

  /// Whether no node of the field's tiles over this column ever rose. The cell above node u is the
  /// field's cell u + 1.
  bool is_untouched(std::int32_t u) const noexcept {
    const std::int32_t rows = KerfField::tiles_over(field_.grid().v_count);
    const auto first =
        field_.tile_revisions().begin() + std::ptrdiff_t{(u + 1) / KerfField::tile_cells} * rows;
    return std::all_of(first, first + rows, [](std::uint32_t revision) { return revision == 0; });
  }
  static std::int32_t last_of_tile(std::int32_t u) noexcept {
    return (u + 1) / KerfField::tile_cells * KerfField::tile_cells + KerfField::tile_cells - 2;
  }

  void walk_column(std::int32_t u) noexcept {
    const auto last_cell = static_cast<double>(field_.grid().v_count - 2);
    const double away = away_in_u(u);
    const double reach = std::sqrt(std::max(0.0, within_ * within_ - away * away));
    const double low = std::clamp(std::floor(place_.y - reach), 0.0, last_cell);
    const double high = std::clamp(std::floor(place_.y + reach), 0.0, last_cell);
    const double middle = std::clamp(std::floor(place_.y), low, high);
    // Away from the point in both directions: what is found first is likely nearest.
    walk_up(u, static_cast<std::int32_t>(middle), static_cast<std::int32_t>(high) + 1);
    walk_down(u, static_cast<std::int32_t>(low), static_cast<std::int32_t>(middle));
  }

  void walk_up(std::int32_t u, std::int32_t first, std::int32_t last) noexcept {
    for (std::int32_t v = first; v < last; v += 64) {
      for (std::uint64_t cells = rim_cells(u, v, last - v); cells != 0; cells &= cells - 1) {
        visit_cell(u, v + std::countr_zero(cells));
      }
    }
  }
  void walk_down(std::int32_t u, std::int32_t first, std::int32_t last) noexcept {
    for (std::int32_t end = last; end > first; end -= 64) {
      const std::int32_t v = std::max(first, end - 64);
      std::uint64_t cells = rim_cells(u, v, end - v);
      while (cells != 0) {
        const int highest = 63 - std::countl_zero(cells);
        cells &= ~(std::uint64_t{1} << highest);
        visit_cell(u, v + highest);
      }
    }
  }

  /// One bit for each of the cells from v on, at most 64, that has open and closed nodes.
  std::uint64_t rim_cells(std::int32_t u, std::int32_t v, std::int32_t count) const noexcept {
    const NodeBits& open = field_.open_nodes();
    const std::uint64_t a = open.from(u, v), b = open.from(u + 1, v);
    const std::uint64_t c = open.from(u, v + 1), d = open.from(u + 1, v + 1);
    const std::uint64_t mixed = (a | b | c | d) & ~(a & b & c & d);
    return count < 64 ? mixed & ((std::uint64_t{1} << count) - 1) : mixed;
  }

  void visit_cell(std::int32_t u, std::int32_t v) noexcept {
    const double away_u = away_in_u(u);
    const double away_v = std::max({static_cast<double>(v) - place_.y, place_.y - (v + 1.0), 0.0});
    if (away_u * away_u + away_v * away_v >= within_ * within_) return;
    const std::array<double, 4> value{field_.at(u, v), field_.at(u + 1, v), field_.at(u + 1, v + 1),
                                      field_.at(u, v + 1)};
    const Vec2 low(u, v);
    for (std::size_t enter = 0; enter < 4; ++enter) {
      if (value[enter] > 0.0 || !(value[(enter + 1) % 4] > 0.0)) continue;
      std::size_t leave = (enter + 1) % 4;
      while (value[(leave + 1) % 4] > 0.0) leave = (leave + 1) % 4;
      const RimSegment segment{place_mm(low + crossing(value, leave)),
                               place_mm(low + crossing(value, enter))};
      within_ = std::min(within_, visit_(context_, segment) / field_.grid().spacing_mm);
    }
  }

  /// On the cell's side from corner `side` to the next, counter-clockwise.
  static Vec2 crossing(const std::array<double, 4>& value, std::size_t side) noexcept {
    constexpr std::array<std::array<double, 2>, 4> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    const std::size_t next = (side + 1) % 4;
    const double share =
        std::clamp(value[side] / (value[side] - value[next]), node_margin, 1.0 - node_margin);
    const Vec2 from(corner[side][0], corner[side][1]), to(corner[next][0], corner[next][1]);
    return from + share * (to - from);
  }
  Vec2 place_mm(const Vec2& place) const noexcept {
    return field_.grid().origin_mm + field_.grid().spacing_mm * place;
  }

  const KerfField& field_;
  Vec2 place_;
  double within_;
  double (*visit_)(void*, const RimSegment&);
  void* context_;
};

}  // namespace

void visit_rim(const KerfField& field, const Vec2& point_mm, double within_mm,
               double (*visit)(void*, const RimSegment&), void* context) noexcept {
  if (field.grid().u_count < 2 || field.grid().v_count < 2) return;
  RimWalk(field, point_mm, within_mm, visit, context).walk();
}

}  // namespace hallux::simulator
