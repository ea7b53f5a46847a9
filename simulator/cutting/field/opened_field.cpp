#include "simulator/cutting/field/opened_field.h"

#include <algorithm>
#include <bit>

#include "simulator/base/check.h"

namespace hallux::simulator {

namespace {

constexpr std::int32_t bits_at_once = 64;

std::size_t width_of(const FieldWindow& window) noexcept {
  return static_cast<std::size_t>(window.v_last - window.v_first);
}

void include(FieldWindow& window, const FieldWindow& other) noexcept {
  if (window.is_empty()) {
    window = other;
    return;
  }
  window.u_first = std::min(window.u_first, other.u_first);
  window.v_first = std::min(window.v_first, other.v_first);
  window.u_last = std::max(window.u_last, other.u_last);
  window.v_last = std::max(window.v_last, other.v_last);
}

}  // namespace

std::vector<std::int32_t> OpenedField::ticks() const {
  std::vector<std::int32_t> ticks;
  std::copy_if(opened_tick.begin(), opened_tick.end(), std::back_inserter(ticks),
               [](std::int32_t tick) { return tick != never; });
  std::sort(ticks.begin(), ticks.end());
  ticks.erase(std::unique(ticks.begin(), ticks.end()), ticks.end());
  return ticks;
}

OpeningNotes::OpeningNotes(const FieldGrid& grid)
    : grid_(grid),
      seen_(grid.u_count, grid.v_count),
      opened_tick_(static_cast<std::size_t>(grid.u_count) * static_cast<std::size_t>(grid.v_count),
                   OpenedField::never) {}

void OpeningNotes::note(const KerfField& field, const FieldWindow& changed, std::int64_t tick) {
  if (changed.is_empty()) return;
  CHECK(tick >= 0 && tick < OpenedField::never);
  include(window_, changed);
  for (std::int32_t u = changed.u_first; u < changed.u_last; ++u) {
    std::int32_t* const line =
        opened_tick_.data() + static_cast<std::size_t>(u) * static_cast<std::size_t>(grid_.v_count);
    for (std::int32_t v = changed.v_first; v < changed.v_last; v += bits_at_once) {
      std::uint64_t fresh = field.open_nodes().from(u, v) & ~seen_.from(u, v);
      for (; fresh != 0; fresh &= fresh - 1) {
        const std::int32_t node = v + std::countr_zero(fresh);
        line[node] = static_cast<std::int32_t>(tick);
        seen_.set(u, node);
      }
    }
  }
}

OpenedField OpeningNotes::finish(const KerfPlane& plane, const KerfField& field) const {
  OpenedField opened{plane, grid_, window_, {}, {}};
  for (std::int32_t u = window_.u_first; u < window_.u_last; ++u) {
    for (std::int32_t v = window_.v_first; v < window_.v_last; ++v) {
      opened.inside_mm.push_back(field.at(u, v));
      opened.opened_tick.push_back(
          opened_tick_[static_cast<std::size_t>(u) * static_cast<std::size_t>(grid_.v_count) +
                       static_cast<std::size_t>(v)]);
    }
  }
  return opened;
}

OpenedMoment::OpenedMoment(const OpenedField& opened)
    : opened_(opened),
      line_(width_of(opened.window)),
      field_(opened.grid),
      tracker_(opened.grid),
      inside_mm_(opened.inside_mm.size()) {}

void OpenedMoment::move_to(std::int64_t tick) {
  for (std::size_t node = 0; node < inside_mm_.size(); ++node) {
    inside_mm_[node] = inside_mm_at(tick, node);
  }
  field_.put(opened_.window, inside_mm_);
  tracker_.update(field_);
}

float OpenedMoment::inside_mm_at(std::int64_t tick, std::size_t node) const noexcept {
  const auto half_way_mm = static_cast<float>(0.5 * opened_.grid.spacing_mm);
  const std::int32_t opened_tick = opened_.opened_tick[node];
  const float last_mm = opened_.inside_mm[node];
  if (opened_tick == OpenedField::never) return last_mm;
  if (opened_tick > tick) return -half_way_mm;
  // Between a node that was open and one that was not yet the outline runs half way.
  if (last_mm > half_way_mm && is_beside_later(tick, node)) return half_way_mm;
  return last_mm;
}

bool OpenedMoment::is_beside_later(std::int64_t tick, std::size_t node) const noexcept {
  const auto is_later = [&](std::size_t other) {
    return opened_.opened_tick[other] > tick && opened_.opened_tick[other] != OpenedField::never;
  };
  const std::size_t place = node % line_;
  return (place > 0 && is_later(node - 1)) || (place + 1 < line_ && is_later(node + 1)) ||
         (node >= line_ && is_later(node - line_)) ||
         (node + line_ < inside_mm_.size() && is_later(node + line_));
}

RegionOutline outline_at(const OpenedField& opened, std::int64_t tick) {
  OpenedMoment moment(opened);
  moment.move_to(tick);
  return moment.outline();
}

}  // namespace hallux::simulator
