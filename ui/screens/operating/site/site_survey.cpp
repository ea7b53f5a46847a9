#include "ui/screens/operating/site/site_survey.h"

#include <algorithm>
#include <utility>

namespace hallux::ui {

namespace {

using simulator::CutEventKind;
using simulator::LiveCut;
using simulator::ToolStatus;

constexpr std::chrono::milliseconds between_surveys{60};
/// So long a piece that is free takes to be told.
constexpr std::chrono::milliseconds until_told{1000};

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
  has_grown_ = true;
  has_opened_since_pieces_ |= has(sample.status, ToolStatus::Cutting);
}

void SiteSurvey::apply(const simulator::CutEvent& event, const LiveCut& cut) {
  watch_.apply(event, cut.kerfs());
  if (event.kind == CutEventKind::PlaneFrozen || event.kind == CutEventKind::PieceRemoved)
    has_grown_ = true;
  if (event.kind == CutEventKind::PieceFreed) freed_.push_back(event.subject);
  are_parts_due_ |=
      event.kind == CutEventKind::PieceFreed || event.kind == CutEventKind::PieceRemoved;
}

/// The same job runs here at the same place: from then on the pieces are known.
void SiteSurvey::apply(const simulator::JobRequest& request) noexcept {
  if (request.kind != simulator::JobKind::Pieces) return;
  has_opened_since_pieces_ = false;
  are_parts_due_ |= !freed_.empty();
}

std::optional<SiteFacts> SiteSurvey::renew(LiveCut& cut, Time now) {
  const bool is_news = has_moved_ || has_grown_ || are_parts_due_ || known_since_.has_value();
  if (now - last_ < between_surveys || !is_news) return std::nullopt;
  last_ = now;
  watch_for_crumbs(now);
  if (std::exchange(has_grown_, false)) renew_held(cut);
  if (std::exchange(are_parts_due_, false)) renew_parts(cut);
  has_moved_ = false;
  const std::vector<const simulator::Bvh*> taken_out = cut.taken_out();
  facts_.ahead = look_ahead(bone_from_tool_, prepared_case_.scenario.saw.blade,
                            {cut.whole().bvh, cut.kerfs(), taken_out});
  facts_.are_pieces_due = has_opened_since_pieces_;
  return facts_;
}

/// What seems through is so but for crumbs. Where then not all that is wanted comes off, crumbs
/// hold it, and are told of like all that holds.
void SiteSurvey::watch_for_crumbs(Time now) {
  const bool seem_through =
      !facts_.cuts.empty() && std::ranges::all_of(facts_.cuts, &scenarios::HeldCut::is_through);
  if (are_parts_off() || has_opened_since_pieces_ || !seem_through) return known_since_.reset();
  if (!known_since_) known_since_ = now;
  if (now - *known_since_ < until_told) return;
  do_crumbs_count_ = has_grown_ = true;
}

bool SiteSurvey::are_parts_off() const noexcept {
  return std::ranges::all_of(facts_.parts, &scenarios::WantedPart::is_off);
}

void SiteSurvey::renew_parts(LiveCut& cut) {
  std::vector<const simulator::PieceBody*> free;
  for (const simulator::PieceBody& piece : cut.pieces())
    if (std::ranges::find(freed_, piece.id) != freed_.end()) free.push_back(&piece);
  const std::vector<const simulator::Bvh*> taken_out = cut.taken_out();
  const scenarios::BoneInPieces bone{cut.whole(), cut.kerfs(), free, taken_out};
  facts_.parts.clear();
  for (const scenarios::OperationStep& step : prepared_case_.scenario.steps) {
    if (step.kind == scenarios::StepKind::Remove)
      facts_.parts.push_back(wanted_part(step, prepared_case_.plan, facts_.cuts, bone));
  }
}

void SiteSurvey::renew_held(LiveCut& cut) {
  const bool do_count = do_crumbs_count_ && !are_parts_off();
  facts_.cuts = watch_.held(cut.kerfs(), cut.whole(),
                            do_count ? scenarios::Crumbs::Told : scenarios::Crumbs::Ignored);
  facts_.held.clear();
  for (const scenarios::HeldCut& held : facts_.cuts) {
    if (!held.is_begun() || held.is_through()) continue;
    facts_.held.push_back(drawn(held, cut, prepared_case_.bone.world_from_bone));
  }
}

}  // namespace hallux::ui
