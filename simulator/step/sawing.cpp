#include "simulator/step/sawing.h"

#include <array>

#include "simulator/base/units.h"
#include "simulator/contact/blade_probe.h"
#include "simulator/contact/metal.h"
#include "simulator/step/recorded_tool.h"

namespace hallux::simulator {

namespace {

/// -1 where there is no kerf left.
std::int32_t freeze_in(std::int32_t fragment, const RigidTransform& fragment_from_tool,
                       StepWriter& out) noexcept {
  const std::int32_t kerf = out.record().kerfs().count();
  if (kerf == kerf_limit) return -1;
  out.say(CutEventKind::PlaneFrozen, kerf, fragment, quantise(fragment_from_tool));
  out.ask(JobKind::Section, kerf);
  return kerf;
}

/// The implant that a tooth stands on, or -1.
std::int32_t metal_at_teeth(const RigidTransform& bone_from_tool, const ToolSite& site) noexcept {
  if (site.metal.empty()) return -1;
  const Blade& blade = site.wound.blade();
  for (const double side : {0.0, -tooth_layer_share, tooth_layer_share}) {
    const auto teeth = tooth_points(bone_from_tool, blade, probe_ahead_mm, side * blade.kerf_mm);
    const std::int32_t implant = metal_at(teeth, site.metal);
    if (implant >= 0) return implant;
  }
  return -1;
}

}  // namespace

SawPassage Sawing::move(const Saw& saw, const ToolHand& hand, const ToolSite& site,
                        StepWriter& out) noexcept {
  const bool is_on_metal = watch_metal(hand, site, out) >= 0;
  const ToolInput input{saw,        hand.bone_from_handle, hand.runs(), hand.duration_s, hand.guide,
                        is_on_metal};
  const std::int32_t kerf_before = kerf();
  const ToolOutcome outcome = move_tool(tool_, input, site.wound, site.settings);
  report(outcome, out);
  const bool has_begun_kerf = outcome.wants_freeze && freeze(site, out);
  if (input.saw_runs && kerf_before >= 0 && kerf_before == kerf()) follow_cut(site, out);

  ToolSample sample = sample_of({out.tick(), site.world_from_bone}, tool_, input, outcome, kerf());
  mark(sample, ToolStatus::Irrigated, has(hand.switches, Switch::Irrigates));
  out.output().engaged = outcome.engaged;
  out.output().torque_in_world_newton_mm =
      transform_direction(site.world_from_bone, outcome.torque_in_bone_newton_mm);
  // What is recorded is what cuts: the field follows the rounded pose. The tool itself goes on
  // unrounded, else a feed below half a micrometre a tick would stand still.
  KerfNumbers opened;
  for (const RisenKerf& risen : out.put(sample)) opened.add(risen.kerf);
  return {{kerf_before, kerf(), opened, outcome.broke_through}, has_begun_kerf};
}

void Sawing::report(const ToolOutcome& outcome, StepWriter& out) const noexcept {
  if (outcome.began_contact) out.say(CutEventKind::Contact, tool_.kerf, 0, pose());
  if (outcome.kicked != KickCause::None) {
    out.say(CutEventKind::Kick, static_cast<std::int32_t>(outcome.kicked),
            thousandths(kick_impulse_newton_s), pose());
  }
  if (outcome.scratch_mm > 0.0)
    out.say(CutEventKind::Scratch, -1, um_from_mm(outcome.scratch_mm), pose());
  if (outcome.broke_through) out.say(CutEventKind::Breakthrough, tool_.kerf, 0, pose());
}

void Sawing::end(StepWriter& out) const noexcept {
  if (tool_.stage == ToolStage::Touching && tool_.scratch_mm > 0.0)
    out.say(CutEventKind::Scratch, -1, um_from_mm(tool_.scratch_mm), pose());
}

/// A touch is deep enough: the blade goes on in a kerf that is already there, or in a new one in
/// its own plane, in the fragment in which most of its teeth stand; true where it is a new one.
bool Sawing::freeze(const ToolSite& site, StepWriter& out) noexcept {
  std::int32_t kerf = find_kerf_to_join(tool_.bone_from_tool, site.wound, site.settings);
  const bool is_new = kerf < 0;
  if (is_new) {
    const std::int32_t fragment = fragment_at_teeth(tool_.bone_from_tool, site.wound, tool_.teeth);
    const WoundFragment& standing = *site.wound.fragment(fragment);
    kerf = freeze_in(fragment, standing.fragment_from(tool_.bone_from_tool), out);
    if (kerf < 0) {
      out.say(CutEventKind::KerfRefused);
      tool_.is_refused = true;
      return false;
    }
  }
  is_cut_refused_ = false;
  enter_kerf(tool_, kerf);
  return is_new;
}

/// Teeth of a blade in its kerf that stand in another fragment cut there too, in the same plane.
void Sawing::follow_cut(const ToolSite& site, StepWriter& out) noexcept {
  const KerfSet& kerfs = out.record().kerfs();
  if (kerfs.fragments().count() == 1 || is_cut_refused_ || !out.may_ask()) return;
  const KerfNumbers cut = kerfs.one_cut_with(tool_.kerf);
  const auto is_uncut = [&](std::int32_t fragment) {
    for (const std::int32_t kerf : cut) {
      if (kerfs.fragment_of(kerf) == fragment) return false;
    }
    return true;
  };
  const std::int32_t fragment =
      fragment_at_teeth(tool_.bone_from_tool, site.wound, tool_.teeth, is_uncut);
  if (fragment < 0) return;
  const RigidTransform fragment_from_kerf =
      site.wound.fragment(fragment)->fragment_from(site.wound.plane(tool_.kerf).bone_from_kerf);
  if (freeze_in(fragment, fragment_from_kerf, out) >= 0) return;
  out.say(CutEventKind::KerfRefused);
  is_cut_refused_ = true;
}

/// Said once while the teeth stand on it.
std::int32_t Sawing::watch_metal(const ToolHand& hand, const ToolSite& site,
                                 StepWriter& out) noexcept {
  const std::int32_t metal = hand.runs() ? metal_at_teeth(tool_.bone_from_tool, site) : -1;
  if (metal >= 0 && metal != metal_) out.say(CutEventKind::MetalMet, metal, 0, pose());
  metal_ = metal;
  return metal;
}

}  // namespace hallux::simulator
