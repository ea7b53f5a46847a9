/// The tool in the hand, the piece in the forceps, and the metal that was left in bone: as the loop
/// says it.
///
///     forceps   Open --asked--> Closing --Gripped--> Holding --Released--> Open
///                  '<--- GripRefused ---'
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scenarios/tray/laid_out_tools.h"
#include "simulator/record/record.h"
#include "ui/screens/operating/hand/notice.h"

namespace hallux::ui {

/// Of its drive: swings or turns.
double rate_per_minute(const simulator::Tool& tool) noexcept;

enum class Forceps : std::uint8_t { Open, Closing, Holding };

class ToolsInHand {
 public:
  ToolsInHand() = default;
  /// The first of the tray is in the hand.
  explicit ToolsInHand(std::vector<scenarios::LaidOutTool> tray) : tray_(std::move(tray)) {}

  /// Nothing where a test has no tray.
  const std::vector<scenarios::LaidOutTool>& tray() const noexcept { return tray_; }
  /// Of the tool in the hand.
  std::int32_t place() const noexcept { return place_; }
  /// Null without a tray.
  const scenarios::LaidOutTool* tool() const noexcept;
  /// Null while another tool is in the hand.
  const simulator::Saw* saw() const noexcept;
  bool is_saw() const noexcept { return tool() == nullptr || saw() != nullptr; }
  /// It may stay in the bone.
  bool is_implant_driver() const noexcept;

  Forceps forceps() const noexcept { return forceps_; }
  /// The fragment that they hold; -1: none.
  std::int32_t gripped() const noexcept { return gripped_; }

  /// The head of the screw in the hand stands on bone.
  bool is_seated() const noexcept { return is_seated_; }
  /// What the forceps hold was driven home.
  bool was_driven_home() const noexcept { return was_driven_home_; }

  void drive_home() noexcept { was_driven_home_ = true; }
  /// A grip was asked for.
  void close_forceps() noexcept { forceps_ = Forceps::Closing; }
  /// It is asked for no more.
  void open_forceps() noexcept { forceps_ = Forceps::Open; }
  /// Takes what happened at the bone; told is what did not come off.
  std::optional<Notice> apply(const simulator::CutEvent& event);

 private:
  std::vector<scenarios::LaidOutTool> tray_;
  std::int32_t place_ = 0;
  Forceps forceps_ = Forceps::Open;
  std::int32_t gripped_ = -1;
  bool is_seated_ = false, was_driven_home_ = false;
};

}  // namespace hallux::ui
