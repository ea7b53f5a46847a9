#include "ui/screens/operating/site/site_survey.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "scenarios/site/parted_bone.h"

namespace hallux::ui {

namespace {

using simulator::CutEventKind;
using simulator::LiveCut;
using simulator::ToolStatus;

constexpr std::chrono::milliseconds between_surveys{60};
/// So long a piece that is free takes to be told.
constexpr std::chrono::milliseconds until_told{1000};
/// So many places along a blade are asked.
constexpr int blade_steps = 8;

HeldBone drawn(const scenarios::HeldCut& cut, const LiveCut& live) {
  return {live.world_from_fragment(cut.fragment) * cut.bone_from_kerf, cut.bone_mm,
          live.opening_of(cut.kerf).opened_mm};
}

std::vector<simulator::SolidWithTree> wholes_of(LiveCut& cut) {
  std::vector<simulator::SolidWithTree> wholes;
  wholes.reserve(static_cast<std::size_t>(cut.fragment_count()));
  for (std::int32_t fragment = 0; fragment < cut.fragment_count(); ++fragment)
    wholes.push_back(cut.whole(fragment));
  return wholes;
}

/// Asked on its middle line and along its edges, behind the teeth.
bool is_blade_in(const simulator::StandingBone& bone, const RigidTransform& bone_from_tool,
                 const simulator::Blade& blade) {
  for (const double aside : {-0.5, 0.0, 0.5}) {
    for (int step = 1; step <= blade_steps; ++step) {
      const Vec3 place_mm{-blade.depth_mm * step / blade_steps, aside * blade.width_mm, 0.0};
      if (is_standing(transform_point(bone_from_tool, place_mm), bone)) return true;
    }
  }
  return false;
}

/// Of several things the one that is nearest.
class Nearest {
 public:
  void offer(std::int32_t number, double distance_mm) noexcept {
    if (distance_mm >= distance_mm_) return;
    number_ = number;
    distance_mm_ = distance_mm;
  }
  std::optional<std::int32_t> number() const noexcept { return number_; }
  double distance_mm() const noexcept { return distance_mm_; }

 private:
  std::optional<std::int32_t> number_;
  double distance_mm_ = std::numeric_limits<double>::infinity();
};

/// Forceps reach no further.
constexpr double reached_mm = 200.0;

}  // namespace

SiteSurvey::SiteSurvey(const PreparedCase& prepared_case)
    : prepared_case_(prepared_case), watch_(prepared_case.scenario, prepared_case.plan) {}

void SiteSurvey::apply(const simulator::ToolSample& sample) noexcept {
  world_from_tool_ = transform_from(sample.world_from_tool);
  has_moved_ = true;
  is_in_kerf_ = has(sample.status, ToolStatus::InKerf);
  if (sample.kerf < 0 || !has(sample.status, ToolStatus::SawOn)) return;
  has_grown_ = true;
  has_opened_since_pieces_ |= has(sample.status, ToolStatus::Cutting);
}

void SiteSurvey::apply(const simulator::CutEvent& event, const LiveCut& cut) {
  watch_.apply(event, cut.kerfs());
  has_grown_ |= event.kind == CutEventKind::PlaneFrozen ||
                event.kind == CutEventKind::PieceRemoved ||
                event.kind == CutEventKind::FragmentParted || event.kind == CutEventKind::Released;
  if (event.kind == CutEventKind::PieceFreed) {
    freed_.push_back(event.subject);
    do_crumbs_count_ = false;
  }
  are_parts_due_ |= event.kind == CutEventKind::PieceFreed ||
                    event.kind == CutEventKind::PieceRemoved ||
                    event.kind == CutEventKind::FragmentParted;
}

/// The same job runs here at the same place: from then on the pieces are known.
void SiteSurvey::apply(const simulator::JobRequest& request) noexcept {
  if (request.kind != simulator::JobKind::Pieces) return;
  has_opened_since_pieces_ = false;
  are_parts_due_ |= !freed_.empty();
}

std::optional<SiteFacts> SiteSurvey::renew(LiveCut& cut, Time now) {
  const bool is_waiting = known_since_.has_value() && !do_crumbs_count_;
  const bool is_news = has_moved_ || has_grown_ || are_parts_due_ || is_waiting;
  if (now - last_ < between_surveys || !is_news) return std::nullopt;
  last_ = now;
  watch_for_crumbs(now);
  if (std::exchange(has_grown_, false)) renew_held(cut);
  if (std::exchange(are_parts_due_, false)) {
    renew_parts(cut);
    renew_freed(cut);
  }
  has_moved_ = false;
  renew_ahead(cut);
  renew_fragments(cut);
  renew_reach(cut);
  renew_metal(cut);
  facts_.are_pieces_due = has_opened_since_pieces_;
  return facts_;
}

void SiteSurvey::renew_ahead(LiveCut& cut) {
  facts_.ahead = {};
  facts_.is_blade_in_bone = false;
  if (cut.kerfs().tray().saw(cut.kerfs().tool()) == nullptr) return renew_beside(cut);
  const simulator::Blade& blade = cut.kerfs().blade();
  bool is_first = true;
  for (std::int32_t fragment = 0; fragment < cut.fragment_count(); ++fragment) {
    if (cut.is_out(fragment) || fragment == cut.gripped()) continue;
    const std::vector<const simulator::Bvh*> taken_out = cut.taken_out(fragment);
    const simulator::StandingBone bone{cut.whole(fragment).bvh, {cut.kerfs(), fragment}, taken_out};
    const RigidTransform bone_from_tool =
        inverse(cut.world_from_fragment(fragment)) * world_from_tool_;
    const simulator::BladeAhead ahead = look_ahead(bone_from_tool, blade, bone);
    facts_.ahead = std::exchange(is_first, false) ? ahead : ahead_of_both(facts_.ahead, ahead);
    if (!is_in_kerf_) facts_.is_blade_in_bone |= is_blade_in(bone, bone_from_tool, blade);
  }
}

/// Of a tip: only how near to bone it is.
void SiteSurvey::renew_beside(LiveCut& cut) {
  double nearest_mm = simulator::looked_ahead_mm;
  for (std::int32_t fragment = 0; fragment < cut.fragment_count(); ++fragment) {
    if (cut.is_out(fragment)) continue;
    const Vec3 tip_mm = transform_point(inverse(cut.world_from_fragment(fragment)),
                                        world_from_tool_.translation_mm);
    nearest_mm =
        std::min(nearest_mm, cut.whole(fragment).bvh.signed_distance_mm(tip_mm, nearest_mm));
  }
  facts_.ahead.beside_mm = std::max(0.0, nearest_mm);
}

void SiteSurvey::renew_fragments(const LiveCut& cut) {
  const RigidTransform bone_from_world = inverse(prepared_case_.bone().world_from_bone);
  facts_.bone_from_fragments.clear();
  facts_.moved.clear();
  for (std::int32_t fragment = 0; fragment < cut.fragment_count(); ++fragment) {
    facts_.bone_from_fragments.push_back(bone_from_world * cut.world_from_fragment(fragment));
    const auto bone = static_cast<std::size_t>(cut.kerfs().fragments()[fragment].bone);
    facts_.moved.push_back(facts_.bone_from_fragments.back() *
                           inverse(first_from(prepared_case_.bones, bone)));
  }
}

/// Pieces by what is nearest of their surface, implants by their tips.
void SiteSurvey::renew_reach(LiveCut& cut) {
  Nearest piece, implant;
  for (std::int32_t fragment = 0; fragment < cut.fragment_count(); ++fragment) {
    if (cut.is_out(fragment)) continue;
    const Vec3 tip_mm = transform_point(inverse(cut.world_from_fragment(fragment)),
                                        world_from_tool_.translation_mm);
    const auto offer = [&](std::int32_t number, const simulator::Bvh& surface) {
      const double most_mm = std::min(piece.distance_mm(), reached_mm);
      if (const auto near = surface.nearest(tip_mm, most_mm))
        piece.offer(number, near->distance_mm);
    };
    for (const simulator::PieceBody& free : cut.pieces(fragment)) {
      if (free.id != cut.own_piece(fragment) && is_known_free(free.id)) offer(free.id, *free.bvh);
    }
    if (fragment >= cut.kerfs().fragments().bone_count())
      offer(cut.own_piece(fragment), cut.whole(fragment).bvh);
  }
  const std::span<const simulator::Implant> implants = cut.implants().all();
  for (std::int32_t number = 0; number < cut.implants().count(); ++number) {
    const simulator::Implant& each = implants[static_cast<std::size_t>(number)];
    if (each.is_taken || each.tool != cut.kerfs().tool()) continue;
    const Vec3 tip_mm = transform_point(cut.world_from_fragment(each.fragment),
                                        each.fragment_from_tool.translation_mm);
    implant.offer(number, length_of(tip_mm - world_from_tool_.translation_mm));
  }
  facts_.reach = {piece.number(), implant.number()};
}

void SiteSurvey::renew_metal(const LiveCut& cut) {
  const auto bone_from = [&](std::int32_t fragment) {
    return facts_.bone_from_fragments[static_cast<std::size_t>(fragment)];
  };
  facts_.implants.clear();
  for (std::int32_t number = 0; number < cut.implants().count(); ++number) {
    const simulator::Implant& each = cut.implants()[number];
    if (!each.is_taken)
      facts_.implants.push_back(
          {number, each.tool, bone_from(each.fragment) * each.fragment_from_tool});
  }
  facts_.bores.clear();
  std::int32_t told = -1;
  for (const simulator::BorePlace& place : cut.bores().places()) {
    if (place.number <= told || place.bore.depth_mm <= 0.0) continue;
    told = place.number;
    facts_.bores.push_back({place.bore.radius_mm, place.bore.depth_mm,
                            bone_from(place.fragment) * place.bore.body_from_bore});
  }
}

/// The places are said in the bone as it was, which is the frame of each fragment.
void SiteSurvey::renew_freed(LiveCut& cut) {
  facts_.freed.clear();
  for (const scenarios::PlannedFragment& planned : prepared_case_.plan.fixation.fragments) {
    FreedFragment& freed = facts_.freed.emplace_back();
    for (std::int32_t fragment = 0; fragment < cut.fragment_count(); ++fragment) {
      const std::int32_t bone = cut.kerfs().fragments()[fragment].bone;
      if (!cut.is_out(fragment) && bone == static_cast<std::int32_t>(planned.bone))
        find_freed(cut, fragment, planned.holds_in_bone_mm, freed);
    }
  }
}

void SiteSurvey::find_freed(LiveCut& cut, std::int32_t fragment, const Vec3& place_mm,
                            FreedFragment& freed) const {
  for (const simulator::PieceBody& piece : cut.pieces(fragment)) {
    const bool is_own = piece.id == cut.own_piece(fragment);
    const bool is_free =
        is_own ? fragment >= cut.kerfs().fragments().bone_count() : is_known_free(piece.id);
    const simulator::Bvh& tree = is_own ? cut.whole(fragment).bvh : *piece.bvh;
    if (!is_free || !tree.contains(place_mm)) continue;
    freed.piece = piece.id;
    if (is_own) freed.fragment = fragment;
  }
}

bool SiteSurvey::is_known_free(std::int32_t piece) const noexcept {
  return std::ranges::find(freed_, piece) != freed_.end();
}

/// Where all cuts around a part seem through and it does not come off, crumbs hold it: those are
/// told of like all that holds.
void SiteSurvey::watch_for_crumbs(Time now) {
  if (has_opened_since_pieces_ || !is_part_caught()) return known_since_.reset();
  if (!known_since_) known_since_ = now;
  if (do_crumbs_count_ || now - *known_since_ < until_told) return;
  do_crumbs_count_ = has_grown_ = true;
}

bool SiteSurvey::is_part_caught() const {
  const auto is_sawn_through = [&](const std::string& cut) {
    const scenarios::HeldCut& held = facts_.cuts[index_of_cut(prepared_case_.plan, cut)];
    return held.is_begun() && held.is_through();
  };
  std::size_t part = 0;
  for (const scenarios::OperationStep& step : prepared_case_.scenario.steps) {
    if (!scenarios::takes_out(step.kind)) continue;
    if (part == facts_.parts.size()) return false;
    if (!facts_.parts[part++].is_off &&
        std::ranges::all_of(cuts_around(step, prepared_case_.plan), is_sawn_through))
      return true;
  }
  return false;
}

bool SiteSurvey::are_parts_off() const noexcept {
  return std::ranges::all_of(facts_.parts, &scenarios::WantedPart::is_off);
}

void SiteSurvey::renew_parts(LiveCut& cut) {
  std::vector<scenarios::FragmentInPieces> fragments;
  for (std::int32_t number = 0; number < cut.fragment_count(); ++number) {
    fragments.push_back({cut.whole(number), {cut.kerfs(), number}, {}, cut.taken_out(number)});
    for (const simulator::PieceBody& piece : cut.pieces(number)) {
      if (piece.id != cut.own_piece(number) && is_known_free(piece.id))
        fragments.back().free.push_back(&piece);
    }
  }
  const std::vector<scenarios::WantedPart> before = std::exchange(facts_.parts, {});
  for (const scenarios::OperationStep& step : prepared_case_.scenario.steps) {
    if (!scenarios::takes_out(step.kind)) continue;
    facts_.parts.push_back(wanted_part(step, prepared_case_.plan, held_, fragments));
    // What came off before its fragment was divided has come off for good.
    const std::size_t part = facts_.parts.size() - 1;
    const bool was_out = part < before.size() && before[part].is_off && before[part].pieces.empty();
    if (was_out) facts_.parts[part].is_off = true;
  }
}

void SiteSurvey::renew_held(LiveCut& cut) {
  const bool do_count = do_crumbs_count_ && !are_parts_off();
  const std::vector<simulator::SolidWithTree> wholes = wholes_of(cut);
  held_ = watch_.held(cut.kerfs(), wholes,
                      do_count ? scenarios::Crumbs::Told : scenarios::Crumbs::Ignored);
  facts_.cuts = held_;
  for (std::size_t index = 0; index < held_.size(); ++index) {
    const std::size_t bone = prepared_case_.plan.cuts[index].bone;
    if (bone == 0) continue;
    const RigidTransform first_from_bone = first_from(prepared_case_.bones, bone);
    scenarios::HeldCut& told = facts_.cuts[index];
    told.bone_from_fragment = first_from_bone * told.bone_from_fragment;
    told.deepest_in_bone_mm = transform_point(first_from_bone, told.deepest_in_bone_mm);
  }
  facts_.held.clear();
  for (const scenarios::HeldCut& held : facts_.cuts) {
    if (!held.is_begun() || held.is_through()) continue;
    facts_.held.push_back(drawn(held, cut));
  }
}

}  // namespace hallux::ui
