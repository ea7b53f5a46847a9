/// The bores of one attempt, opened from what is recorded: one rule for the step and for scoring.
///
/// The rule: a BoreBegun event fixes a bore's axis in a fragment, as thick as the tool that was
/// chosen last; every sample in a bore with the drive running opens it to the tip, and with it
/// every bore as thick that lies along the same axis in another fragment. A fragment that is parted
/// from another has its bores as well. Nothing else opens bone.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "simulator/cutting/hole/bore.h"
#include "simulator/record/fragment_poses.h"
#include "simulator/record/record.h"
#include "simulator/tool/tray.h"

namespace hallux::simulator {

/// As many as an attempt may begin; and the places of them, in the fragments that they are in.
inline constexpr std::int32_t bore_limit = 24;
inline constexpr std::size_t bore_place_limit = 64;

/// A bore in one of the fragments that it goes through.
struct BorePlace {
  /// By BoreBegun, counted from 0.
  std::int32_t number = -1;
  std::int32_t fragment = 0;
  /// That began it: its place on the tray.
  std::int32_t tool = 0;
  /// In the fragment's frame.
  Bore bore;
};

class BoreSet {
 public:
  /// tray  with the tools that bore
  explicit BoreSet(const Tray& tray);

  std::int32_t count() const noexcept { return count_; }
  bool is_full() const noexcept { return count_ == bore_limit || place_count_ == bore_place_limit; }
  /// They keep their index.
  std::span<const BorePlace> places() const noexcept { return {places_.data(), place_count_}; }
  /// Opened by the next sample in a bore; -1: none is.
  std::int32_t entered() const noexcept { return entered_; }
  /// Whether the bore that was entered goes on in this fragment.
  bool is_entered_in(std::int32_t fragment) const noexcept;
  /// The index of a bore's place in a fragment; -1: it is in no such.
  std::int32_t place_of(std::int32_t number, std::int32_t fragment) const noexcept;

  /// Follows the events: the tool in the hand, bores, fragments that part; others change nothing.
  /// fragments  after the event
  /// errors  false where it names a bore that is not the next, or one beyond the limit, or a tool
  ///         that bores nothing; nothing changed then
  /// thread  haptic; allocates nothing
  bool apply(const CutEvent& event, const FragmentPoses& fragments) noexcept;
  void apply(const ToolSample& sample, const FragmentPoses& fragments) noexcept;

 private:
  bool begin(const CutEvent& event, const FragmentPoses& fragments) noexcept;
  bool enter(std::int32_t place, const FragmentPoses& fragments) noexcept;
  void part(std::int32_t parent, std::int32_t fragment) noexcept;

  Tray tray_;
  std::array<BorePlace, bore_place_limit> places_{};
  std::array<bool, bore_place_limit> is_open_{};
  std::size_t place_count_ = 0;
  std::int32_t count_ = 0;
  std::int32_t tool_ = 0;
  std::int32_t entered_ = -1;
};

}  // namespace hallux::simulator
