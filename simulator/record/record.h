/// What leaves the room: device states, commands, tool samples and cut events, as the integers that
/// are kept.
///
/// Every number is rounded to its quantum before the step uses it, so the record is exact: what is
/// recorded is what cut, and a replay can be compared bit by bit. Tick t covers the simulated time
/// from t to t + 1 milliseconds.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulator/base/bits.h"
#include "simulator/base/digest.h"
#include "simulator/base/transform.h"

namespace hallux::simulator {

/// Raised by hand whenever the same input may give another output; committed with the golden
/// hashes.
inline constexpr std::int32_t engine_version = 8;

/// A pose in whole quanta: translation in micrometres, quaternion (w, x, y, z) in millionths.
struct QuantisedPose {
  std::array<std::int32_t, 3> translation_um{};
  std::array<std::int32_t, 4> rotation_micro{1000000, 0, 0, 0};

  friend bool operator==(const QuantisedPose&, const QuantisedPose&) = default;
};

/// The nearest pose in whole quanta; the quaternion's sign is chosen so that its first non-zero
/// part is positive.
QuantisedPose quantise(const RigidTransform& pose) noexcept;
/// The rigid transform meant by the quanta; its quaternion is normalised again.
RigidTransform transform_from(const QuantisedPose& pose) noexcept;

/// What a device says at one tick: the handle's pose in the world (foot frame) and its switches.
struct DeviceState {
  QuantisedPose world_from_handle;
  /// Bits of Switch.
  std::uint32_t switches = 0;
  /// Bits of DeviceFault, set by the loop; each brings the force to zero.
  std::uint32_t faults = 0;

  friend bool operator==(const DeviceState&, const DeviceState&) = default;
};

enum class Switch : std::uint32_t { SawRuns = 1U << 0U, Irrigates = 1U << 1U };

enum class DeviceFault : std::uint32_t {
  /// No state came.
  Lost = 1U << 0U,
  /// The device said NaN or infinity.
  NotFinite = 1U << 1U,
  /// Moved faster than a hand can.
  Jumped = 1U << 2U,
  /// The same to the last bit for longer than the device ever is.
  Frozen = 1U << 3U,
  /// No new packet for longer than one may be late.
  Late = 1U << 4U
};

enum class CommandKind : std::int32_t {
  /// Begins the attempt's clock.
  Start = 1,
  /// The tool is safe, nothing cuts.
  Pause = 2,
  /// Argument as Pause: each ends its own.
  Resume = 3,
  /// Argument: index of the operation step declared done.
  StepDone = 4,
  /// Argument: piece to take out of the wound, or piece_freed_last.
  PickUp = 5,
  /// The operator declares the operation done.
  Finish = 6,
  /// Argument: job id; detail: tick of the state it was computed from.
  ApplyJob = 7,
  Abandon = 8,
  /// Turn the bone about the bridge that the cuts have left, until the wedge is closed. Argument:
  /// which hinge of the operation.
  CloseHinge = 9,
  /// Argument: index of an operation step that was declared done and is at hand again.
  ReopenStep = 10,
  /// The forceps take hold of a piece. Argument: as PickUp.
  Grip = 11,
  /// The forceps let go.
  Release = 12,
  /// The gripped piece is driven home: into what its sawn walls came from, until the faces touch.
  Impact = 13,
  /// Another tool is taken into the hand. Argument: its place on the tray.
  ChooseTool = 14,
  /// The driver lets go of the wire or screw that stands in bone.
  LeaveImplant = 15,
  /// The driver takes hold of a wire or screw that it left. Argument: the implant.
  TakeImplant = 16
};

/// A decision applied at a tick: of the operator, the loop, or a job that is ready.
struct Command {
  CommandKind kind = CommandKind::Start;
  std::int32_t argument = 0;
  std::int64_t detail = 0;

  friend bool operator==(const Command&, const Command&) = default;
};

/// Of pieces that come free at once the smallest is announced last: a wedge, where the bone falls
/// in two beside it.
inline constexpr std::int32_t piece_freed_last = -1;
inline constexpr std::int32_t paused_by_operator = 0;
inline constexpr std::int32_t paused_by_loop = 1;

inline constexpr std::size_t commands_per_tick = 4;

/// Beyond this many ticks in one line an attempt pauses instead of jumping on.
inline constexpr std::int64_t ticks_per_line_max = 3;

/// Everything the step may depend on at one tick; one line of the input tape.
struct TapeLine {
  /// First tick this line covers.
  std::int64_t tick = 0;
  DeviceState device;
  /// Simulated ticks this line covers: 1, or 2 to 3 after missed ones.
  std::uint8_t ticks = 1;
  /// Used entries of `commands`.
  std::uint8_t command_count = 0;
  std::array<Command, commands_per_tick> commands{};

  friend bool operator==(const TapeLine&, const TapeLine&) = default;
};

enum class ToolStatus : std::uint32_t {
  /// The attempt's clock runs.
  Running = 1U << 0U,
  SawOn = 1U << 1U,
  /// Teeth or a tip touch bone, or a piece in the forceps touches another.
  InContact = 1U << 2U,
  /// Teeth advance in bone.
  Cutting = 1U << 3U,
  /// The blade is held by a frozen plane.
  InKerf = 1U << 4U,
  Irrigated = 1U << 5U,
  ForceLimited = 1U << 6U,
  Faulted = 1U << 7U,
  /// A wire, drill or screw is held by the axis of its bore.
  InBore = 1U << 8U,
  /// The drive of a wire, drill or screw runs; of a saw it is SawOn.
  DriveOn = 1U << 9U,
  /// The tip of a wire, drill or screw advances in bone; of teeth it is Cutting.
  Boring = 1U << 10U
};

/// The tool as it was after the constraint, at the end of one tick, in the world (foot frame).
struct ToolSample {
  std::int64_t tick = 0;
  /// Of a saw: origin at the middle of the tooth line, +x from handle to teeth, z blade normal.
  /// Of a wire, drill or screw: origin at the tip, +x along the axis. Of forceps that hold a piece:
  /// the piece.
  QuantisedPose world_from_tool;
  /// On the hand, world frame, simulated newtons in millinewton.
  std::array<std::int32_t, 3> force_mn{};
  /// Bits of ToolStatus.
  std::uint32_t status = 0;
  /// Index of the kerf the blade is in, or -1.
  std::int32_t kerf = -1;

  friend bool operator==(const ToolSample&, const ToolSample&) = default;
};

enum class CutEventKind : std::int32_t {
  Started = 1,
  /// Teeth touched bone without the plane being frozen; value: depth [um].
  Scratch = 2,
  /// First touch of a stroke.
  Contact = 3,
  /// Subject: kerf; value: the fragment that it is in; pose: fragment_from_tool at freezing. Where
  /// the blade stands in a kerf of another fragment, the sample before says so: both are one cut.
  PlaneFrozen = 4,
  /// Subject: kerf; the contact job was applied; value: section area [um2 / 1000].
  SectionKnown = 5,
  /// Subject: kerf; the teeth left bone at the far side.
  Breakthrough = 6,
  /// Subject: kerf; it has taken its whole section.
  SectionCovered = 7,
  /// Subject: piece; value: volume [mm3 / 1000]; pose: a point inside it, bone frame (from engine 7
  /// on).
  PieceFreed = 8,
  /// Subject: piece; value and pose as of PieceFreed, as the piece was known last (from engine 7
  /// on).
  PieceRemoved = 9,
  /// Subject: operation step.
  StepDone = 10,
  Paused = 11,
  Resumed = 12,
  /// Value: bits of DeviceFault.
  Fault = 13,
  Finished = 14,
  Abandoned = 15,
  /// The touch asked for more kerfs than an attempt may have.
  KerfRefused = 16,
  /// Subject: the hinge, in the operation's order (-1 up to engine 7); value: angle [urad]; pose:
  /// bone_from_moved, of the half that turned.
  HingeClosed = 17,
  /// Subject: why (HingeOutcome: 1 broken, 2 stiff, 3 nothing to close); value: bridge [um].
  HingeRefused = 18,
  /// Subject: kerf; a patch of its walls went above 47 degrees; value: there, now [0.001 degree
  /// Celsius].
  BoneHot = 19,
  /// Subject: kerf; a patch of its walls reached the dose of necrosis; value: so far in all [mm3 /
  /// 1000].
  BoneNecrosis = 20,
  /// Subject: zone; the running saw touches it; value: distance [um], negative inside.
  DangerContact = 21,
  /// Subject: zone; the contact is over; value: the least distance in it [um].
  DangerLeft = 22,
  /// The teeth caught; subject: why (KickCause: 1 started in bone, 2 a corner); value: impulse [mN
  /// s].
  Kick = 23,
  /// Subject: operation step.
  StepReopened = 24,
  /// Subject: the piece that is a fragment from now on, with the next number; value: the fragment
  /// that it was a part of.
  FragmentParted = 25,
  /// Subject: fragment; pose: bone_from_fragment.
  Gripped = 26,
  /// Subject: fragment; pose: bone_from_fragment, where it lies from now on.
  Released = 27,
  /// Subject: why (GripRefusal); value: the piece that was asked for.
  GripRefused = 28,
  /// Subject: the tool's place on the tray; before the first it is the tray's first.
  ToolChosen = 29,
  /// Subject: why (ToolRefusal); value: the place that was asked for.
  ToolRefused = 30,
  /// The point of a wire, drill or screw met bone.
  PointContact = 31,
  /// Subject: bore; value: the fragment that it is in; pose: fragment_from_bore. A tool that is in
  /// a bore of another fragment says the same axis in this one.
  BoreBegun = 32,
  /// Subject: bore; value: the fragment; a tool is in it again.
  BoreEntered = 33,
  /// The point asked for more bores than an attempt may have.
  BoreRefused = 34,
  /// Subject: bore; the tip came out at the far side; value: the push just before [mN].
  BoreThrough = 35,
  /// Subject: implant; it stops the running tool.
  MetalMet = 36,
  /// Subject: bore; the screw's head stands on bone.
  ScrewSeated = 37,
  /// Subject: implant, with the next number; value: the fragment that it goes along with; pose:
  /// fragment_from_tool.
  ImplantLeft = 38,
  /// As ImplantLeft, of one that goes along with another fragment from now on.
  ImplantCarried = 39,
  /// Subject: implant; it is in the driver again.
  ImplantTaken = 40,
  /// Subject: why (ImplantRefusal); value: the implant, -1 where one was to be left.
  ImplantRefused = 41,
  /// Subject: piece, whose PieceFreed follows; value: the fragment that it is of. Of a piece of the
  /// first bone it is not said.
  PieceOfFragment = 42
};

/// Something that happened once, at the end of one tick.
struct CutEvent {
  std::int64_t tick = 0;
  CutEventKind kind = CutEventKind::Started;
  std::int32_t subject = -1;
  std::int64_t value = 0;
  /// bone_from_tool for cutting and danger events, bone_from_moved for HingeClosed and fragments,
  /// bone_from_place (in the kerf's axes) for heat, the point of a piece for pieces, as said there
  /// for bores and implants, identity otherwise.
  QuantisedPose pose;

  friend bool operator==(const CutEvent&, const CutEvent&) = default;
};

/// An attempt as it can be computed again: all that came in and all that came out, in order of
/// ticks.
struct Recording {
  std::int32_t engine = engine_version;
  std::vector<TapeLine> tape;
  std::vector<ToolSample> samples;
  std::vector<CutEvent> events;
};

/// The golden hash: a digest of every output of a recording.
Digest digest_outputs(const Recording& recording) noexcept;

/// The integers of one row in the order in which they are digested and packed; `count` is fixed per
/// type.
inline constexpr std::size_t tape_columns = 11 + 3 * commands_per_tick;
inline constexpr std::size_t sample_columns = 13;
inline constexpr std::size_t event_columns = 11;
std::array<std::int64_t, tape_columns> columns_of(const TapeLine& line) noexcept;
std::array<std::int64_t, sample_columns> columns_of(const ToolSample& sample) noexcept;
std::array<std::int64_t, event_columns> columns_of(const CutEvent& event) noexcept;
TapeLine tape_line_from(const std::array<std::int64_t, tape_columns>& columns) noexcept;
ToolSample tool_sample_from(const std::array<std::int64_t, sample_columns>& columns) noexcept;
CutEvent cut_event_from(const std::array<std::int64_t, event_columns>& columns) noexcept;

}  // namespace hallux::simulator
