#include "simulator/step/boring.h"

#include <algorithm>
#include <limits>

#include "simulator/base/fixed_list.h"
#include "simulator/base/units.h"
#include "simulator/step/carried_implants.h"
#include "simulator/step/recorded_tool.h"

namespace hallux::simulator {

namespace {

/// Implants that stand, in the wound's frame.
using StandingImplants = FixedList<RigidTransform, static_cast<std::size_t>(implant_limit)>;

StandingImplants standing_implants(const ImplantSet& implants, const Wound& wound) noexcept {
  StandingImplants standing;
  for (const Implant& implant : implants.all()) {
    if (stands(implant, wound)) standing.push(wound_from_implant(implant, wound));
  }
  return standing;
}

void find_bores(std::span<const BorePlace> places, const StandingImplants& implants,
                const Wound& wound, BoresAtHand& at_hand) noexcept {
  for (const BorePlace& place : places) {
    Bore& bore = at_hand.bores[at_hand.count++];
    bore = place.bore;
    const WoundFragment* const standing = wound.fragment(place.fragment);
    if (standing != nullptr) bore.body_from_bore = standing->wound_from(bore.body_from_bore);
    const bool has_implant = std::any_of(
        implants.begin(), implants.end(),
        [&](const RigidTransform& implant) { return is_along(bore.body_from_bore, implant); });
    if (standing == nullptr || has_implant)
      bore.depth_mm = -std::numeric_limits<double>::infinity();
  }
}

void find_holes(std::span<const BorePlace> places, const Wound& wound,
                BoresAtHand& at_hand) noexcept {
  std::size_t end = 0;
  for (std::int32_t fragment = 0; fragment < fragment_limit; ++fragment) {
    if (wound.fragment(fragment) != nullptr) {
      for (const BorePlace& place : places) {
        if (place.fragment == fragment) at_hand.capsules[end++] = capsule_of(place.bore);
      }
    }
    at_hand.ends[static_cast<std::size_t>(fragment)] = end;
  }
}

BoresAtHand bores_at_hand(const FollowedRecord& record, const Wound& wound) noexcept {
  BoresAtHand at_hand;
  const std::span<const BorePlace> places = record.bores().places();
  find_bores(places, standing_implants(record.implants(), wound), wound, at_hand);
  find_holes(places, wound, at_hand);
  return at_hand;
}

}  // namespace

HolesOfFragments BoresAtHand::holes() const noexcept {
  HolesOfFragments holes;
  std::size_t begin = 0;
  for (std::size_t fragment = 0; fragment < ends.size(); ++fragment) {
    holes[fragment] = std::span(capsules).subspan(begin, ends[fragment] - begin);
    begin = ends[fragment];
  }
  return holes;
}

void Boring::take_up(const RigidTransform& wound_from_handle) noexcept {
  *this = {};
  tool_.wound_from_tool = wound_from_handle;
}

void Boring::move(const Tool& held, const ToolHand& hand, const ToolSite& site,
                  StepWriter& out) noexcept {
  const BoreTool tool = *bore_tool(held);
  const BoresAtHand at_hand = bores_at_hand(out.record(), site.wound);
  const BoreInput input{tool,          hand.bone_from_handle * handle_from_tool_,
                        hand.runs(),   hand.duration_s,
                        at_hand.all(), at_hand.holes(),
                        site.metal};
  const bool was_in_bore = is_in_bore();
  const std::int32_t bore = was_in_bore ? place(out).number : -1;
  const BoreOutcome outcome = move_bore(tool_, input, site.wound, site.settings);
  report(outcome, bore, out);
  if (is_in_bore() && !was_in_bore) {
    enter(tool_.bore, out);
  } else if (is_in_bore() && input.drive_runs) {
    follow_bore(at_hand, input, site, out);
  } else if (!is_in_bore()) {
    find_bore(outcome, at_hand, input, site, out);
  }
  out.put(sample_of({out.tick(), site.world_from_bone}, tool_, input, outcome));
  out.output().engaged = outcome.engaged;
  out.output().torque_in_world_newton_mm =
      transform_direction(site.world_from_bone, outcome.torque_in_wound_newton_mm);
}

/// bore  that held the tool at the beginning of the tick; -1: none
void Boring::report(const BoreOutcome& outcome, std::int32_t bore, StepWriter& out) noexcept {
  if (outcome.began_contact)
    out.say(CutEventKind::PointContact, -1, 0, quantise(tool_.wound_from_tool));
  if (outcome.broke_through)
    out.say(CutEventKind::BoreThrough, bore, millinewton_from_newton(outcome.broke_at_newton));
  if (outcome.metal >= 0 && outcome.metal != metal_)
    out.say(CutEventKind::MetalMet, outcome.metal, 0, quantise(tool_.wound_from_tool));
  metal_ = outcome.metal;
  if (outcome.head_seated && !is_seated_) out.say(CutEventKind::ScrewSeated, bore);
  is_seated_ = outcome.head_seated || (is_seated_ && is_in_bore());
}

template <typename Counts>
std::int32_t Boring::fragment_at_tip(const BoresAtHand& at_hand, const BoreInput& input,
                                     const ToolSite& site, const StepWriter& out,
                                     const Counts& counts) noexcept {
  const std::int32_t fragments = out.record().fragments().count();
  if (fragments != tip_fragments_) tip_ = {};
  tip_fragments_ = fragments;
  const HolesOfFragments holes = at_hand.holes();
  return DrilledWound{site.wound, holes}.fragment_at(
      tip_disc(tool_.wound_from_tool, input.tool.radius_mm), tip_, counts);
}

/// A point that is deep enough begins a bore along its axis; one that found a bore too narrow for
/// it widens that.
void Boring::find_bore(const BoreOutcome& outcome, const BoresAtHand& at_hand,
                       const BoreInput& input, const ToolSite& site, StepWriter& out) noexcept {
  const bool widens = outcome.found_bore >= 0 && input.drive_runs && input.tool.bores;
  if (!outcome.wants_bore && !widens) {
    is_bore_refused_ = false;
    return;
  }
  if (out.record().bores().is_full()) {
    if (!is_bore_refused_) out.say(CutEventKind::BoreRefused);
    is_bore_refused_ = tool_.is_refused = true;
    return;
  }
  if (widens) {
    const auto found = static_cast<std::size_t>(outcome.found_bore);
    const Bore wider = widened(at_hand.bores[found], input.tool.radius_mm);
    begin(out.record().bores().places()[found].fragment, wider.body_from_bore, site, out);
    return;
  }
  const std::int32_t fragment =
      fragment_at_tip(at_hand, input, site, out, [](std::int32_t) { return true; });
  if (fragment < 0) return;
  const Bore bore = begin_bore(tool_.wound_from_tool, tool_.touch_depth_mm, input.tool.radius_mm);
  begin(fragment, bore.body_from_bore, site, out);
}

void Boring::begin(std::int32_t fragment, const RigidTransform& wound_from_bore,
                   const ToolSite& site, StepWriter& out) noexcept {
  const RigidTransform fragment_from_bore =
      site.wound.fragment(fragment)->fragment_from(wound_from_bore);
  const auto place = static_cast<std::int32_t>(out.record().bores().places().size());
  out.say(CutEventKind::BoreBegun, out.record().bores().count(), fragment,
          quantise(fragment_from_bore));
  if (!is_in_bore()) enter_bore(tool_, place);
}

void Boring::enter(std::int32_t place, StepWriter& out) noexcept {
  const BorePlace& entered = out.record().bores().places()[static_cast<std::size_t>(place)];
  out.say(CutEventKind::BoreEntered, entered.number, entered.fragment);
}

/// A tip that stands in a further fragment bores there too, along the same axis.
void Boring::follow_bore(const BoresAtHand& at_hand, const BoreInput& input, const ToolSite& site,
                         StepWriter& out) noexcept {
  const BoreSet& bores = out.record().bores();
  if (out.record().fragments().count() == 1 || bores.is_full()) return;
  const std::int32_t fragment = fragment_at_tip(
      at_hand, input, site, out, [&](std::int32_t number) { return !bores.is_entered_in(number); });
  if (fragment < 0) return;
  begin(fragment, at_hand.bores[static_cast<std::size_t>(tool_.bore)].body_from_bore, site, out);
}

bool Boring::leave_implant(const Tool& held, const ToolSite& site, StepWriter& out) noexcept {
  const ImplantSet& implants = out.record().implants();
  const auto refuse = [&](ImplantRefusal why) {
    out.say(CutEventKind::ImplantRefused, static_cast<std::int32_t>(why), -1);
    return false;
  };
  if (!is_in_bore() || !implant_of(held)) return refuse(ImplantRefusal::NothingToLeave);
  if (implants.is_full()) return refuse(ImplantRefusal::TooMany);
  const std::int32_t fragment = place(out).fragment;
  const RigidTransform fragment_from_tool =
      site.wound.fragment(fragment)->fragment_from(tool_.wound_from_tool);
  out.say(CutEventKind::ImplantLeft, implants.count(), fragment, quantise(fragment_from_tool));
  return true;
}

void Boring::take_implant(std::int32_t implant, const ToolHand& hand, const ToolSite& site,
                          StepWriter& out) noexcept {
  const Implant& taken = out.record().implants()[implant];
  const RigidTransform wound_from_tool = wound_from_implant(taken, site.wound);
  take_up(wound_from_tool);
  handle_from_tool_ = inverse(hand.bone_from_handle) * wound_from_tool;
  out.say(CutEventKind::ImplantTaken, implant);
  const BoresAtHand at_hand = bores_at_hand(out.record(), site.wound);
  // A tip that came out at the far side went on through the air.
  const std::int32_t bore = find_bore_to_join(wound_from_tool, at_hand.all(), taken.size.length_mm);
  if (bore < 0) return;
  enter_bore(tool_, bore);
  tool_.is_threaded = taken.size.is_screw;
  enter(bore, out);
}

}  // namespace hallux::simulator
