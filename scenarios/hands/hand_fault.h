/// What a scripted hand does wrong on purpose, on top of the errors of its skill.
///
///     tilt:proximal_face=4     a name, what it is of, how much
///
/// A fault says what the hand does, never what a rubric makes of it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hallux::scenarios {

struct Scenario;
struct OperationStep;

enum class FaultKind {
  Tilt,
  Roll,
  Offset,
  OverCut,
  StopShort,
  Skip,
  Swap,
  Dry,
  Slow,
  Press,
  Restarts,
  TouchZone,
  ShiftBy,
  TurnBy,
  WrongWay,
  Direction,
  Entry,
  Length,
  Unicortical,
  WrongBlade
};

struct HandFault {
  FaultKind kind = FaultKind::Tilt;
  /// A cut, a step, a zone, a fragment or an implant; empty: of every cut, or of the whole attempt.
  std::string subject;
  /// In the unit of its row; 0 where it has none.
  double size = 0.0;

  friend bool operator==(const HandFault&, const HandFault&) = default;
};

/// MayBeCut: without one it is of every cut.
enum class FaultSubject { None, MayBeCut, Step, Zone, Fragment, Implant };

struct FaultRow {
  FaultKind kind;
  std::string_view name;
  FaultSubject subject;
  /// Empty: it has no size.
  std::string_view unit;
  double usual_size, least, greatest;
  bool is_whole;
  std::string_view effect;
};

/// One row for each kind, in the order of the kinds.
std::span<const FaultRow> fault_table() noexcept;

/// The longest name of a hand that an export of an attempt holds [bytes].
inline constexpr std::size_t hand_name_bytes_max = 255;

/// The faults that the texts name.
/// errors  ScenarioError with what there is: an unknown fault or subject, a size that is no number
///         or out of range, the same fault twice, more of them than a record names
std::vector<HandFault> parse_hand_faults(std::span<const std::string> texts,
                                         const Scenario& scenario);
std::string text_of(const HandFault& fault);
/// How a hand with these faults is named in the record.
std::string hand_with_faults(std::string_view hand, std::span<const HandFault> faults);

/// The sizes together, of those of the whole attempt, of every cut and of this subject.
double fault_size(std::span<const HandFault> faults, FaultKind kind,
                  std::string_view subject = {}) noexcept;
bool has_fault(std::span<const HandFault> faults, FaultKind kind) noexcept;
/// Of this subject, or of all.
bool is_faulty(std::span<const HandFault> faults, FaultKind kind,
               std::string_view subject) noexcept;
/// How a fault names the step: by its id, else its cut or what is done; empty for the last one,
/// which no hand leaves out.
std::string_view fault_name_of(const OperationStep& step) noexcept;
bool is_skipped(std::span<const HandFault> faults, const OperationStep& step) noexcept;

}  // namespace hallux::scenarios
