/// The next thing to do where wires and screws are set and fragments led, in practice.
/// Inside this corner only.
///
///     wire, screw   tool --> direction --> entry --> drive on --> push --> leave --> draw back
///     drill         tool --> direction --> entry --> drive on --> push --> draw back
///     fragment      grip --> turn and lead --> drive home --> let go
#pragma once

#include <optional>

#include "ui/screens/operating/coach.h"
#include "ui/screens/pictures/fixation_reading.h"

namespace hallux::ui {

/// Of a step that sets implants.
/// needs   the site is known, and there is a tray
std::optional<Hint> implant_hint(const CoachView& view);
/// Of a step that shifts a fragment which is free; nothing while none is.
/// needs   as of implant_hint
std::optional<Hint> shift_hint(const CoachView& view);
/// Wires that have done what they were set for come out before bone is sawn or shifted.
/// needs   as of implant_hint
std::optional<Hint> temporary_wire_hint(const CoachView& view);
/// Another tool is to come into the hand; nothing where it is that one.
std::optional<Hint> tool_hint(const CoachView& view, std::int32_t place);

/// The planned implant that is set next in the step at hand, with the tool of its turn.
struct ImplantTask {
  const scenarios::PlannedImplant* implant = nullptr;
  /// On the tray.
  std::int32_t tool = 0;
  /// A hole for a screw.
  bool is_pilot = false;
};
/// Nothing where all are set, or the step sets none.
std::optional<ImplantTask> implant_at_hand(const CoachView& view);

/// The shift of the step at hand; nothing in other steps.
std::optional<std::size_t> shift_at_hand(const CoachView& view);
/// The piece that this shift moves, once it is free.
std::optional<std::int32_t> piece_of_shift(const CoachView& view, std::size_t shift);
/// How its fragment lies now.
ShiftReading shift_reading(const CoachView& view, std::size_t shift);

}  // namespace hallux::ui
