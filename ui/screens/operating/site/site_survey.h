/// What is known of the site while somebody operates: what holds of each cut, and what lies ahead
/// of the teeth. Read off the geometry some times a second, on its thread.
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

struct SiteFacts {
  /// By the plan's cuts.
  std::vector<scenarios::HeldCut> cuts;
  /// Of the cuts that were begun and hold, to be drawn.
  std::vector<HeldBone> held;
  simulator::BladeAhead ahead;
  /// What the scenario's steps that remove ask for, in their order.
  std::vector<scenarios::WantedPart> parts;
  /// The pieces are worked out: until then nobody knows whether one is free.
  bool are_pieces_due = false;
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
  bool are_parts_off() const noexcept;
  void watch_for_crumbs(Time now);

  const PreparedCase& prepared_case_;
  scenarios::SiteWatch watch_;
  SiteFacts facts_;
  RigidTransform bone_from_tool_, seen_from_tool_;
  bool has_moved_ = false, has_grown_ = true, has_opened_since_pieces_ = false;
  /// Every cut seemed through and yet not all that is wanted came off, so crumbs hold it.
  bool do_crumbs_count_ = false;
  /// Pieces that the kernel said are free: it may be behind what is worked out here.
  std::vector<std::int32_t> freed_;
  bool are_parts_due_ = true;
  /// From when on the pieces are known as they are now.
  std::optional<Time> known_since_;
  Time last_;
};

}  // namespace hallux::ui
