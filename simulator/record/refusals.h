/// Why a wish of the hand is not carried out, as the events say it.
#pragma once

#include <cstdint>

namespace hallux::simulator {

/// Why a tool is not taken into the hand.
enum class ToolRefusal : std::int32_t {
  /// No such place is on the tray.
  NoSuchTool = 1,
  /// The forceps hold a piece, or are about to.
  HandsFull = 2,
  /// The tool in the hand stands on bone, or in it.
  ToolInBone = 3
};

/// Why a piece is not gripped.
enum class GripRefusal : std::int32_t {
  /// None of that number lies in the wound.
  NoSuchPiece = 1,
  /// It is what the rest of the foot holds.
  BoneItself = 2,
  /// The forceps are closed, or about to.
  HandsFull = 3,
  /// The blade stands in bone.
  ToolInBone = 4,
  /// As many fragments were moved as there may be.
  TooMany = 5,
  /// A screw, wires that are not parallel, or a wire and a hinge hold it.
  Held = 6
};

/// Why a wire or screw is not left in the bone, or not taken.
enum class ImplantRefusal : std::int32_t {
  /// No wire or screw that the hand holds stands in bone.
  NothingToLeave = 1,
  /// None of that number stands in bone.
  NoSuchImplant = 2,
  /// Another tool left it than the one in the hand.
  OtherTool = 3,
  /// The tool in the hand stands on bone, or forceps hold a piece.
  HandsFull = 4,
  /// As many were left as there may be.
  TooMany = 5
};

}  // namespace hallux::simulator
