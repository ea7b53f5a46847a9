/// The sheet prints every number of a scenario with its origin, in the order in which it is
/// operated: a surgeon who signs a version reads this and not JSON. Numbers are printed to nine
/// digits: what went through radians reads as it was written.
#include "ui/jobs/course/scenario_jobs.h"

#include <algorithm>
#include <sstream>

#include "assessment/number_text.h"
#include "scenarios/steps/step_words.h"
#include "ui/jobs/course/operation_sheet.h"
#include "ui/jobs/course/sheet_text.h"

namespace hallux::ui {
namespace {

using namespace scenarios;

/// Landmarks and planes lie where they lie at any edge length; a coarse surface is built in a
/// fraction of the time.
constexpr double check_edge_mm = 1.0;

std::string points_text(std::int64_t milli) {
  return sheet_number(static_cast<double>(milli) / 1000.0);
}

std::string point_text(const Vec3& point_mm) {
  return sheet_number(point_mm.x) + " " + sheet_number(point_mm.y) + " " + sheet_number(point_mm.z);
}

std::string provisional_text(bool is_provisional) { return is_provisional ? " (provisional)" : ""; }

void write_means(std::ostream& out, const Scenario& scenario) {
  const PatientRequest& patient = scenario.patient;
  out << "\nPatient\n  " << patient.bone << ", length " << sheet_number(patient.length_mm) << " mm";
  if (patient.eminence_mm > 0.0) out << ", eminence " << sheet_number(patient.eminence_mm) << " mm";
  out << ", edge " << sheet_number(patient.edge_mm) << " mm";
  if (patient.bone_quality != 1.0) out << ", bone quality " << sheet_number(patient.bone_quality);
  out << "\n";
  write_origin(out, patient.origin);
  const simulator::Saw& saw = scenario.saw;
  out << "\nBlade\n  " << scenario.blade_name << ": width " << sheet_number(saw.blade.width_mm)
      << " mm, depth " << sheet_number(saw.blade.depth_mm) << " mm, thickness "
      << sheet_number(saw.blade.thickness_mm) << " mm, kerf " << sheet_number(saw.blade.kerf_mm)
      << " mm, " << sheet_number(saw.cycles_per_minute) << " cycles/min";
  if (saw.sharpness < 1.0) out << ", sharpness " << sheet_number(saw.sharpness);
  out << "\n";
  write_origin(out, scenario.blade_origin);
  write_further_means(out, scenario);
}

void write_face(std::ostream& out, const Scenario& scenario, const ReferenceCut& cut) {
  const LandmarkPlane& face = cut.face;
  switch (face.kind) {
    case FaceKind::AlongAxis:
      out << "contains the direction " << face.axis_from << " to " << face.axis_to << "; "
          << sheet_number(face.offset_mm) << " mm from " << face.through
          << " towards the waste; frontal tilt " << sheet_angle(face.frontal_tilt_rad);
      break;
    case FaceKind::Transverse:
      out << "across the bone, parallel to " << face.axis_from << " to " << face.axis_to << ", "
          << sheet_number(face.offset_mm) << " mm distal of " << face.through
          << "; transverse tilt " << sheet_angle(face.transverse_tilt_rad) << ", sagittal tilt "
          << sheet_angle(face.sagittal_tilt_rad);
      break;
    case FaceKind::Turned:
      out << "through " << face.through << ", contains " << face.contains << ", turned about it by "
          << sheet_angle(face.angle_rad) << " from " << face.turned_from;
      if (face.roll_rad != 0.0) out << "; rolled by " << sheet_angle(face.roll_rad);
      break;
    case FaceKind::ThroughHinge:
      for (const ReferenceHinge& hinge : scenario.hinges) {
        if (hinge.second_cut != cut.name) continue;
        out << "through the line of the hinge " << hinge.name << ", " << sheet_angle(face.wedge_rad)
            << " from the face of " << hinge.first_cut;
      }
      break;
  }
}

void write_cuts(std::ostream& out, const Scenario& scenario) {
  out << "\nReference cuts (finished bone faces)\n";
  for (const ReferenceCut& cut : scenario.cuts) {
    out << "  " << cut.name << ": " << cut.title << "\n      ";
    write_face(out, scenario, cut);
    if (cut.face.kind != FaceKind::Turned) {
      out << "\n      waste " << cut.waste_side;
    } else {
      out << "\n      " << (cut.keeps_both ? "both sides are kept, measured is " : "kept is ")
          << cut.keep;
    }
    out << "; approach " << cut.approach;
    if (cut.window) out << "; only beyond " << cut.window->beyond << " " << cut.window->along;
    if (!cut.depth_landmark.empty()) out << "; depth at " << cut.depth_landmark;
    if (!cut.exit_landmark.empty()) out << "; flush at " << cut.exit_landmark;
    out << "\n";
    write_origin(out, cut.origin);
  }
}

void write_hinges(std::ostream& out, const Scenario& scenario) {
  if (scenario.hinges.empty()) return;
  out << "\nHinges\n";
  for (const ReferenceHinge& hinge : scenario.hinges) {
    out << "  " << hinge.name << ": " << hinge.title << ", of " << hinge.first_cut << " and "
        << hinge.second_cut << "\n      " << sheet_number(hinge.thickness_mm) << " mm inside the "
        << hinge.side << " cortex; target " << sheet_number(hinge.target_low_mm) << " to "
        << sheet_number(hinge.target_high_mm) << " mm; breaks below "
        << sheet_number(hinge.breaks_below_mm) << " mm, bends up to "
        << sheet_number(hinge.bends_up_to_mm) << " mm" << provisional_text(hinge.is_provisional)
        << "\n";
    write_origin(out, hinge.origin);
  }
}

/// What it is about; empty where it is about nothing.
std::string step_subject_text(const OperationStep& step) {
  std::string text = subject_of(step) + step.point + step.shift;
  for (const std::string& implant : step.implants) text += (text.empty() ? "" : " ") + implant;
  return text;
}

void write_steps(std::ostream& out, const Scenario& scenario) {
  out << "\nSteps\n";
  int number = 1;
  for (const OperationStep& step : scenario.steps) {
    const std::string subject = step_subject_text(step);
    out << "  " << number++ << ". [" << step_word(step.kind)
        << (subject.empty() ? "" : " " + subject) << order_text(step) << "] " << step.title
        << "\n      " << step.text << "\n";
  }
}

std::string landmark_text(const std::string& landmark) {
  return landmark.empty() ? "" : " from " + landmark;
}

void write_danger_zones(std::ostream& out, const Scenario& scenario) {
  out << "\nDanger zones (capsules in the bone frame, mm)\n";
  for (const DangerZone& zone : scenario.danger_zones) {
    out << "  " << zone.name << ": " << zone.title << ", " << zone.severity << ", from "
        << point_text(zone.from_in_bone_mm) << landmark_text(zone.from_landmark) << " to "
        << point_text(zone.to_in_bone_mm) << landmark_text(zone.to_landmark) << ", radius "
        << sheet_number(zone.radius_mm) << (zone.is_checked ? "" : "; position unchecked") << "\n";
    write_origin(out, zone.origin);
  }
}

/// What stands behind a number; a count and a share have nothing.
std::string unit_behind(const std::string& unit) {
  return unit.empty() ? "" : " " + assessment::unit_text(unit);
}

void write_item(std::ostream& out, const RubricItem& item) {
  out << "    " << item.id << " " << item.title << ": " << points_text(item.weight_milli)
      << " points for " << item.metric
      << (subject_of(item).empty() ? "" : " of " + subject_of(item));
  if (item.is_band) {
    out << "; full from " << sheet_number(item.full_low) << " to " << sheet_number(item.full_high)
        << ", none below " << sheet_number(item.zero_low) << " or above "
        << sheet_number(item.zero_high);
  } else {
    out << "; full up to " << sheet_number(item.full) << ", none from " << sheet_number(item.zero);
  }
  out << unit_behind(item.unit) << provisional_text(item.is_provisional) << "\n";
  write_origin(out, item.origin);
}

void write_rubric(std::ostream& out, const Rubric& rubric) {
  out << "\nRubric, version " << rubric.version << "\n";
  for (const RubricGroup& group : rubric.groups) {
    const bool is_measured =
        std::any_of(rubric.items.begin(), rubric.items.end(),
                    [&](const RubricItem& item) { return item.group == group.name; });
    out << "  " << group.title << ": " << points_text(group.weight_milli) << " points"
        << (is_measured ? "" : ", not measured yet");
    if (group.not_measured_milli > 0) {
      out << ", " << points_text(group.not_measured_milli) << " of them not measured yet";
    }
    out << "\n";
    write_origin(out, group.origin);
    for (const RubricItem& item : rubric.items) {
      if (item.group == group.name) write_item(out, item);
    }
  }
  out << "\nGates\n";
  for (const Gate& gate : rubric.gates) {
    out << "  " << gate.title << ": " << gate.metric
        << (subject_of(gate).empty() ? "" : " of " + subject_of(gate))
        << (gate.is_at_least ? " below " : " above ") << sheet_number(gate.limit)
        << unit_behind(gate.unit) << " caps the score at " << points_text(gate.cap_milli)
        << provisional_text(gate.is_provisional) << "\n";
    write_origin(out, gate.origin);
  }
}

}  // namespace

std::vector<Scenario> list_scenarios() {
  std::vector<Scenario> shipped;
  for (const EmbeddedText& file : shipped_scenarios()) {
    shipped.push_back(parse_scenario(file.text, file.name));
  }
  std::sort(shipped.begin(), shipped.end(),
            [](const Scenario& a, const Scenario& b) { return a.name < b.name; });
  return shipped;
}

Scenario load_scenario(const std::string& name_or_file) {
  const bool is_file = std::filesystem::is_regular_file(name_or_file);
  return is_file ? read_scenario(name_or_file) : load_shipped_scenario(name_or_file);
}

CheckedScenario check_scenario_file(const std::filesystem::path& file) {
  CheckedScenario checked;
  checked.scenario = read_scenario(file);
  Scenario coarse = checked.scenario;
  coarse.patient.edge_mm = std::max(coarse.patient.edge_mm, check_edge_mm);
  for (PatientRequest& bone : coarse.further_bones)
    bone.edge_mm = std::max(bone.edge_mm, check_edge_mm);
  checked.bones = make_patient_bones(coarse);
  checked.plan = plan_on(coarse, checked.bones);
  return checked;
}

std::string scenario_sheet(const Scenario& scenario) {
  std::ostringstream out;
  out << scenario.title << " (" << scenario.name << "), version " << scenario.version << ", "
      << review_label(scenario) << "\n\nIndication\n  " << scenario.indication << "\n\nSummary\n  "
      << scenario.summary << "\n";
  write_means(out, scenario);
  write_places(out, scenario);
  write_cuts(out, scenario);
  write_hinges(out, scenario);
  write_fixation(out, scenario);
  write_steps(out, scenario);
  write_danger_zones(out, scenario);
  write_rubric(out, scenario.rubric);
  out << "\nSources named by the origins\n";
  for (const SourceNote& source : scenario.sources) {
    out << "  " << source.key << ": " << source.text << "\n";
  }
  return out.str();
}

}  // namespace hallux::ui
