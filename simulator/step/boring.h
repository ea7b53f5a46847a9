/// A wire driver, drill or screwdriver in the hand: how it is moved, the bores that it begins and
/// enters, and the wires and screws that it leaves in the bone and takes out again.
/// Inside this corner only.
#pragma once

#include <array>
#include <cstdint>

#include "simulator/contact/bore/bore_motion.h"
#include "simulator/record/refusals.h"
#include "simulator/step/step_output.h"
#include "simulator/step/tool_hand.h"

namespace hallux::simulator {

/// The bores of an attempt as a tool meets them.
struct BoresAtHand {
  /// In the wound's frame, by their places; one that is shut has no depth.
  std::array<Bore, bore_place_limit> bores{};
  std::size_t count = 0;
  /// Of one fragment after the other, in its frame; of each where they end.
  std::array<Capsule, bore_place_limit> capsules{};
  OfFragments<std::size_t> ends{};

  std::span<const Bore> all() const noexcept { return {bores.data(), count}; }
  /// Borrowed from this.
  HolesOfFragments holes() const noexcept;
};

class Boring {
 public:
  const BoreToolState& tool() const noexcept { return tool_; }
  bool is_in_bore() const noexcept { return tool_.stage == BoreStage::InBore; }

  /// Comes into the hand there, free.
  void take_up(const RigidTransform& wound_from_handle) noexcept;
  /// Moves the tool for one tick and writes its sample.
  void move(const Tool& held, const ToolHand& hand, const ToolSite& site, StepWriter& out) noexcept;
  /// Leaves in the bone what the driver carries; false: nothing, which is said.
  bool leave_implant(const Tool& held, const ToolSite& site, StepWriter& out) noexcept;
  /// Takes hold of an implant where it stands.
  /// needs   it is there, and the tool in the hand left it
  void take_implant(std::int32_t implant, const ToolHand& hand, const ToolSite& site,
                    StepWriter& out) noexcept;

 private:
  void report(const BoreOutcome& outcome, std::int32_t bore, StepWriter& out) noexcept;
  void find_bore(const BoreOutcome& outcome, const BoresAtHand& at_hand, const BoreInput& input,
                 const ToolSite& site, StepWriter& out) noexcept;
  void begin(std::int32_t fragment, const RigidTransform& wound_from_bore, const ToolSite& site,
             StepWriter& out) noexcept;
  void enter(std::int32_t place, StepWriter& out) noexcept;
  void follow_bore(const BoresAtHand& at_hand, const BoreInput& input, const ToolSite& site,
                   StepWriter& out) noexcept;
  /// The fragment in which the tip stands, of those that count; -1: none.
  template <typename Counts>
  std::int32_t fragment_at_tip(const BoresAtHand& at_hand, const BoreInput& input,
                               const ToolSite& site, const StepWriter& out,
                               const Counts& counts) noexcept;
  /// Of the bore that holds the tool.
  const BorePlace& place(const StepWriter& out) const noexcept {
    return out.record().bores().places()[static_cast<std::size_t>(tool_.bore)];
  }

  BoreToolState tool_;
  /// How the hand holds what it took hold of in the bone.
  RigidTransform handle_from_tool_;
  /// Said, and not over yet.
  bool is_bore_refused_ = false, is_seated_ = false;
  std::int32_t metal_ = -1;
  /// Of the tip's disc, while there are so many fragments: one that parts is another solid.
  DiscMemories tip_{};
  std::int32_t tip_fragments_ = 0;
};

}  // namespace hallux::simulator
