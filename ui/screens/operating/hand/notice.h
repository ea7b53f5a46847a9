/// What people are told of what did not come off, or stopped.
#pragma once

#include <cstdint>

namespace hallux::ui {

enum class Notice : std::uint8_t {
  NothingFree,
  HingeBroken,
  HingeStiff,
  HingeMissing,
  HingeUnanswered,
  KerfRefused,
  /// A tool is changed, a piece gripped, only with the tool out of the bone.
  ToolInBone,
  /// The forceps hold something.
  HandsFull,
  NothingToGrip,
  /// What the rest of the foot holds.
  BoneItself,
  /// By a screw, or wires that are not parallel.
  PieceFixed,
  TooManyMoved,
  NothingToLeave,
  /// No wire or screw of the tool in the hand stands in bone.
  NothingToTake,
  TooManyLeft,
  BoreRefused,
  /// It stopped the tool that ran.
  MetalMet
};

}  // namespace hallux::ui
