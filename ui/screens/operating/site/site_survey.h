/// What is known of the site while somebody operates: what holds of each cut, what lies ahead of
/// the teeth, and what forceps or driver would take hold of. Read off the geometry some times a
/// second, on its thread.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "scenarios/site/site_watch.h"
#include "scenarios/site/wanted_part.h"
#include "simulator/jobs/live_cut.h"
#include "simulator/sight/blade_ahead.h"
#include "ui/jobs/live_attempt.h"
#include "ui/render/scene/site.h"

namespace hallux::ui {

/// Nearest to the tip of what is in the hand.
struct WithinReach {
  /// That forceps would grip: what came free, or a fragment that was moved before.
  std::optional<std::int32_t> piece;
  /// That the driver in the hand left, and would take again.
  std::optional<std::int32_t> implant;
};

/// A wire or a screw that stands in bone.
struct StandingImplant {
  std::int32_t number = 0;
  /// That left it: its place on the tray.
  std::int32_t tool = 0;
  /// Origin at the tip, x along the axis.
  RigidTransform bone_from_tool;
};

/// A bore as it lies now; one through several fragments is told once.
struct BoredHole {
  double radius_mm = 0.0, depth_mm = 0.0;
  /// Origin where the tip met the bone, x into it.
  RigidTransform bone_from_bore;
};

/// A planned fragment in the wound: the piece that holds its place, and the fragment once it is
/// one.
struct FreedFragment {
  std::optional<std::int32_t> piece, fragment;
};

struct SiteFacts {
  /// By the plan's cuts, in the frame of the first bone.
  std::vector<scenarios::HeldCut> cuts;
  /// Of the cuts that were begun and hold, to be drawn.
  std::vector<HeldBone> held;
  simulator::BladeAhead ahead;
  /// A blade that is in no kerf lies within bone: it is not held before it is drawn back.
  bool is_blade_in_bone = false;
  /// What the scenario's steps that take bone out ask for, in their order.
  std::vector<scenarios::WantedPart> parts;
  /// The pieces are worked out: until then nobody knows whether one is free.
  bool are_pieces_due = false;
  /// Where each fragment lies, by their numbers, in the frame of the first bone; and what carried
  /// it there from where it was.
  std::vector<RigidTransform> bone_from_fragments, moved;
  WithinReach reach;
  std::vector<StandingImplant> implants;
  std::vector<BoredHole> bores;
  /// By the plan's fragments.
  std::vector<FreedFragment> freed;
};

class SiteSurvey {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// Borrows the case.
  explicit SiteSurvey(const PreparedCase& prepared_case);

  // What the loop feeds, after the cut took it.
  void apply(const simulator::ToolSample& sample) noexcept;
  void apply(const simulator::CutEvent& event, const simulator::LiveCut& cut);
  void apply(const simulator::JobRequest& request) noexcept;

  /// Nothing where nothing changed since the last, or that is too short ago.
  std::optional<SiteFacts> renew(simulator::LiveCut& cut, Time now);

 private:
  void renew_held(simulator::LiveCut& cut);
  void renew_parts(simulator::LiveCut& cut);
  void renew_ahead(simulator::LiveCut& cut);
  void renew_beside(simulator::LiveCut& cut);
  void renew_fragments(const simulator::LiveCut& cut);
  void renew_reach(simulator::LiveCut& cut);
  /// After the fragments.
  void renew_metal(const simulator::LiveCut& cut);
  void renew_freed(simulator::LiveCut& cut);
  void find_freed(simulator::LiveCut& cut, std::int32_t fragment, const Vec3& place_mm,
                  FreedFragment& freed) const;
  bool is_known_free(std::int32_t piece) const noexcept;
  bool are_parts_off() const noexcept;
  void watch_for_crumbs(Time now);
  bool is_part_caught() const;

  const PreparedCase& prepared_case_;
  scenarios::SiteWatch watch_;
  /// By the plan's cuts, each in the frame of its bone.
  std::vector<scenarios::HeldCut> held_;
  SiteFacts facts_;
  RigidTransform world_from_tool_;
  bool is_in_kerf_ = false;
  bool has_moved_ = false, has_grown_ = true, has_opened_since_pieces_ = false;
  /// What was sawn seemed through and yet not all that is wanted came off, so crumbs hold it, until
  /// the next piece comes free.
  bool do_crumbs_count_ = false;
  /// Pieces that the kernel said are free: it may be behind what is worked out here.
  std::vector<std::int32_t> freed_;
  bool are_parts_due_ = true;
  /// From when on the pieces are known as they are now.
  std::optional<Time> known_since_;
  Time last_;
};

}  // namespace hallux::ui
