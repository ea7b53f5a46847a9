/// What a blade opened of a kerf, and when: a field's last values, and the tick at which each node
/// opened. A recording's kerfs as they stood after any tick are a threshold of it, without a stamp.
///
/// After the last tick that is the field itself, bit for bit. Before it the outline lies where it
/// lay but for half a spacing (0.025 mm) where the teeth stood: a node says when it opened, not how
/// far the blade had come beside it.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "simulator/cutting/field/kerf.h"
#include "simulator/cutting/field/node_bits.h"
#include "simulator/cutting/field/region_outline.h"

namespace hallux::simulator {

struct OpenedField {
  /// Later than any tick: what was never opened.
  static constexpr std::int32_t never = std::numeric_limits<std::int32_t>::max();

  KerfPlane plane;
  FieldGrid grid;
  /// Holds every node that is not as it was at first.
  FieldWindow window;
  // One entry for each node of the window, line by line.
  /// At last.
  std::vector<float> inside_mm;
  /// Or never.
  std::vector<std::int32_t> opened_tick;
  /// When something opened, ascending, each once.
  std::vector<std::int32_t> ticks() const;
};

/// Watches a field that is stamped.
class OpeningNotes {
 public:
  explicit OpeningNotes(const FieldGrid& grid);

  /// After each stamp.
  /// needs   the same field each time, `changed` as the stamp gave it; ticks never fall and lie
  ///         below `never`
  void note(const KerfField& field, const FieldWindow& changed, std::int64_t tick);
  OpenedField finish(const KerfPlane& plane, const KerfField& field) const;

 private:
  FieldGrid grid_;
  NodeBits seen_;
  FieldWindow window_;
  /// Of each node of the grid.
  std::vector<std::int32_t> opened_tick_;
};

/// A kerf at one moment after the other. Borrows what was opened.
class OpenedMoment {
 public:
  explicit OpenedMoment(const OpenedField& opened);

  /// Brings field and outline to what stood after this tick.
  void move_to(std::int64_t tick);
  const KerfField& field() const noexcept { return field_; }
  /// Without a loop where nothing was opened yet.
  const RegionOutline& outline() const noexcept { return tracker_.outline(); }

 private:
  float inside_mm_at(std::int64_t tick, std::size_t node) const noexcept;
  bool is_beside_later(std::int64_t tick, std::size_t node) const noexcept;

  const OpenedField& opened_;
  /// Nodes of the window in one line.
  std::size_t line_;
  KerfField field_;
  OutlineTracker tracker_;
  std::vector<float> inside_mm_;
};

/// The outline after a tick, from scratch.
RegionOutline outline_at(const OpenedField& opened, std::int64_t tick);

}  // namespace hallux::simulator
