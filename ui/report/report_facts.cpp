#include "ui/report/report_facts.h"

#include <array>
#include <string_view>

#include "assessment/number_text.h"
#include "simulator/base/units.h"
#include "ui/times/local_time.h"

namespace hallux::ui {

namespace {

using database::AttemptHeader;
using database::AttemptState;

/// Enough of a digest to tell two apart by eye.
constexpr std::size_t digest_letters = 16;

std::string operator_text(const AttemptHeader& header) {
  if (!header.login.empty()) return header.login;
  if (header.begun.person) return "erased person";
  return "robot, " + header.begun.hand + " hand, seed " + std::to_string(header.begun.seed);
}

std::string purpose_text(const AttemptHeader& header) {
  std::string kind(database::name_of(header.begun.kind));
  switch (header.begun.guidance) {
    case simulator::Guidance::None:
      return kind;
    case simulator::Guidance::Soft:
      return kind + ", guided softly by the planned plane";
    case simulator::Guidance::Slot:
      return kind + ", guided by the planned plane like a slot";
  }
  return kind;
}

std::string quality_text(const AttemptHeader& header) {
  switch (header.state) {
    case AttemptState::Closed:
      return header.seal ? "The recording is whole: closed and sealed."
                         : "The recording is closed but has no seal.";
    case AttemptState::Recording:
      return "The recording is still going on; this is what was stored so far.";
    case AttemptState::Interrupted:
      return "The recording was interrupted; it is valid up to its last stored stretch.";
    case AttemptState::Void:
      return "This attempt was set aside by an instructor.";
  }
  return "";
}

constexpr std::array<std::string_view, database::stored_names<database::Invalidity>.size()> reasons{
    "samples were lost",
    "the tape leaves ticks out",
    "the tape has ticks twice",
    "the machine slept, or its clock jumped",
    "the machine paused it for too much of the time",
    "too many ticks were missed",
    "the device did not answer for too much of the time",
    "the mouse took over from its device"};

std::string validity_text(const AttemptHeader& header, const database::Verdict& verdict) {
  if (header.is_valid.value_or(true)) return "";
  std::string text = " It is not valid for grading";
  for (const database::Invalidity reason : verdict.reasons) {
    text += (reason == verdict.reasons.front() ? ": " : "; ");
    text += reasons.at(static_cast<std::size_t>(reason));
  }
  return text + ".";
}

}  // namespace

std::string signature_text(const AttemptHeader& header) {
  if (!header.decision) return std::string(unsigned_score);
  if (*header.decision == database::DecisionKind::Voided) return "set aside by an instructor";
  const std::string points = assessment::points_text(header.decided_milli.value_or(0));
  if (!header.decision_is_of_score_in_force)
    return "signed for an earlier score, as " + points + "; no grade until it is signed anew";
  return *header.decision == database::DecisionKind::Overridden
             ? "set to " + points + " by an instructor"
             : "confirmed by an instructor";
}

void add_titles(ReportMaterial& material, const scenarios::Scenario& scenario) {
  material.title = scenario.title;
  for (const scenarios::RubricGroup& group : scenario.rubric.groups) {
    material.group_titles.push_back(group.title);
  }
  for (const scenarios::Gate& gate : scenario.rubric.gates) {
    material.gate_titles.push_back(gate.title);
  }
}

void add_attempt_facts(ReportMaterial& material, const AttemptHeader& header,
                       const database::Verdict& verdict) {
  material.signature = signature_text(header);
  material.facts.push_back({"Operator", operator_text(header)});
  material.facts.push_back({"For", purpose_text(header)});
  material.facts.push_back({"Attempt", std::to_string(header.number)});
  material.facts.push_back({"Started", full_moment_text(header.started_utc)});
  if (header.duration_ticks) {
    const std::int64_t duration_us = time_us_from_tick(*header.duration_ticks);
    material.facts.push_back({"Duration", assessment::moment_text(duration_us)});
  }
  material.facts.push_back({"Device", header.begun.device_class});
  material.facts.push_back({"Stereo", header.begun.stereo_mode});
  material.versions.push_back({"Attempt", header.id.text});
  material.versions.push_back(
      {"Bone", hex_from_digest(header.begun.bone).substr(0, digest_letters)});
  material.quality = quality_text(header) + validity_text(header, verdict);
}

}  // namespace hallux::ui
