#include "ui/screens/operating/site/site_survey.h"

#include <utility>

namespace hallux::ui {

namespace {

using simulator::CutEventKind;
using simulator::LiveCut;
using simulator::ToolStatus;

constexpr std::chrono::milliseconds between_surveys{60};

HeldBone drawn(const scenarios::HeldCut& cut, const LiveCut& live,
               const RigidTransform& world_from_bone) {
  return {world_from_bone * cut.bone_from_kerf, cut.bone_mm, live.opening_of(cut.kerf).opened_mm};
}

}  // namespace

SiteSurvey::SiteSurvey(const PreparedCase& prepared_case)
    : prepared_case_(prepared_case), watch_(prepared_case.scenario, prepared_case.plan) {}

void SiteSurvey::apply(const simulator::ToolSample& sample) noexcept {
  bone_from_tool_ =
      inverse(prepared_case_.bone.world_from_bone) * transform_from(sample.world_from_tool);
  has_moved_ = true;
  if (sample.kerf < 0 || !has(sample.status, ToolStatus::SawOn)) return;
  has_grown_ = has_opened_since_pieces_ = true;
}

void SiteSurvey::apply(const simulator::CutEvent& event, const LiveCut& cut) {
  watch_.apply(event, cut.kerfs());
  if (event.kind == CutEventKind::PlaneFrozen || event.kind == CutEventKind::PieceRemoved)
    has_grown_ = true;
}

/// The same job runs here at the same place: from then on the pieces are known.
void SiteSurvey::apply(const simulator::JobRequest& request) noexcept {
  if (request.kind == simulator::JobKind::Pieces) has_opened_since_pieces_ = false;
}

std::optional<SiteFacts> SiteSurvey::renew(LiveCut& cut, Time now) {
  if (now - last_ < between_surveys || (!has_moved_ && !has_grown_)) return std::nullopt;
  last_ = now;
  if (std::exchange(has_grown_, false)) renew_held(cut);
  has_moved_ = false;
  const std::vector<const simulator::Bvh*> taken_out = cut.taken_out();
  facts_.ahead = look_ahead(bone_from_tool_, prepared_case_.scenario.saw.blade,
                            {cut.whole().bvh, cut.kerfs(), taken_out});
  facts_.are_pieces_due = has_opened_since_pieces_;
  return facts_;
}

void SiteSurvey::renew_held(LiveCut& cut) {
  facts_.cuts = watch_.held(cut.kerfs(), cut.whole());
  facts_.held.clear();
  for (const scenarios::HeldCut& held : facts_.cuts) {
    if (!held.is_begun() || held.is_through()) continue;
    facts_.held.push_back(drawn(held, cut, prepared_case_.bone.world_from_bone));
  }
}

}  // namespace hallux::ui
