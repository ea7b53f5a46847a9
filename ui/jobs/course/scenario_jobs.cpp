/// The sheet prints every number of a scenario with its origin, in the order in which it is
/// operated: a surgeon who signs a version reads this and not JSON. Numbers are printed to nine
/// digits: what went through radians reads as it was written.
#include "ui/jobs/course/scenario_jobs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "simulator/base/units.h"

namespace hallux::ui {
namespace {

using namespace scenarios;

/// Landmarks and planes lie where they lie at any edge length; a coarse surface is built in a
/// fraction of the time.
constexpr double check_edge_mm = 1.0;

/// What was read as a decimal reads the same again, and an angle that went through radians has no
/// tail of digits.
std::string number_text(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::general, 9)
                       .ptr;
  return {digits.data(), end};
}

std::string points_text(std::int64_t milli) {
  return number_text(static_cast<double>(milli) / 1000.0);
}

std::string point_text(const Vec3& point_mm) {
  return number_text(point_mm.x) + " " + number_text(point_mm.y) + " " + number_text(point_mm.z);
}

std::string_view step_word(StepKind kind) {
  switch (kind) {
    case StepKind::Verify:
      return "verify";
    case StepKind::Cut:
      return "cut";
    case StepKind::Remove:
      return "remove";
    case StepKind::Close:
      return "close";
    case StepKind::Finish:
      return "finish";
  }
  return "";
}

std::string provisional_text(bool is_provisional) { return is_provisional ? " (provisional)" : ""; }

void write_origin(std::ostream& out, const std::string& origin) {
  out << "      origin: " << origin << "\n";
}

void write_means(std::ostream& out, const Scenario& scenario) {
  const PatientRequest& patient = scenario.patient;
  out << "\nPatient\n  " << patient.bone << ", length " << number_text(patient.length_mm) << " mm";
  if (patient.eminence_mm > 0.0) out << ", eminence " << number_text(patient.eminence_mm) << " mm";
  out << ", edge " << number_text(patient.edge_mm) << " mm";
  if (patient.bone_quality != 1.0) out << ", bone quality " << number_text(patient.bone_quality);
  out << "\n";
  write_origin(out, patient.origin);
  const simulator::Saw& saw = scenario.saw;
  out << "\nBlade\n  " << scenario.blade_name << ": width " << number_text(saw.blade.width_mm)
      << " mm, depth " << number_text(saw.blade.depth_mm) << " mm, thickness "
      << number_text(saw.blade.thickness_mm) << " mm, kerf " << number_text(saw.blade.kerf_mm)
      << " mm, " << number_text(saw.cycles_per_minute) << " cycles/min";
  if (saw.sharpness < 1.0) out << ", sharpness " << number_text(saw.sharpness);
  out << "\n";
  write_origin(out, scenario.blade_origin);
}

std::string degree_text(double angle_rad) {
  return number_text(degree_from_radian(angle_rad)) + " deg";
}

void write_face(std::ostream& out, const Scenario& scenario, const ReferenceCut& cut) {
  const LandmarkPlane& face = cut.face;
  switch (face.kind) {
    case FaceKind::AlongAxis:
      out << "contains the direction " << face.axis_from << " to " << face.axis_to << "; "
          << number_text(face.offset_mm) << " mm from " << face.through
          << " towards the waste; frontal tilt " << degree_text(face.frontal_tilt_rad);
      break;
    case FaceKind::Transverse:
      out << "across the bone, parallel to " << face.axis_from << " to " << face.axis_to << ", "
          << number_text(face.offset_mm) << " mm distal of " << face.through << "; transverse tilt "
          << degree_text(face.transverse_tilt_rad) << ", sagittal tilt "
          << degree_text(face.sagittal_tilt_rad);
      break;
    case FaceKind::ThroughHinge:
      for (const ReferenceHinge& hinge : scenario.hinges) {
        if (hinge.second_cut != cut.name) continue;
        out << "through the line of the hinge " << hinge.name << ", " << degree_text(face.wedge_rad)
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
    out << "\n      waste " << cut.waste_side << "; approach " << cut.approach;
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
        << hinge.second_cut << "\n      " << number_text(hinge.thickness_mm) << " mm inside the "
        << hinge.side << " cortex; target " << number_text(hinge.target_low_mm) << " to "
        << number_text(hinge.target_high_mm) << " mm; breaks below "
        << number_text(hinge.breaks_below_mm) << " mm, bends up to "
        << number_text(hinge.bends_up_to_mm) << " mm" << provisional_text(hinge.is_provisional)
        << "\n";
    write_origin(out, hinge.origin);
  }
}

void write_steps(std::ostream& out, const Scenario& scenario) {
  out << "\nSteps\n";
  int number = 1;
  for (const OperationStep& step : scenario.steps) {
    const std::string& subject = subject_of(step);
    out << "  " << number++ << ". [" << step_word(step.kind)
        << (subject.empty() ? "" : " " + subject) << "] " << step.title << "\n      " << step.text
        << "\n";
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
        << number_text(zone.radius_mm) << (zone.is_checked ? "" : "; position unchecked") << "\n";
    write_origin(out, zone.origin);
  }
}

void write_item(std::ostream& out, const RubricItem& item) {
  out << "    " << item.id << " " << item.title << ": " << points_text(item.weight_milli)
      << " points for " << item.metric
      << (subject_of(item).empty() ? "" : " of " + subject_of(item));
  if (item.is_band) {
    out << "; full from " << number_text(item.full_low) << " to " << number_text(item.full_high)
        << ", none below " << number_text(item.zero_low) << " or above "
        << number_text(item.zero_high);
  } else {
    out << "; full up to " << number_text(item.full) << ", none from " << number_text(item.zero);
  }
  out << " " << item.unit << provisional_text(item.is_provisional) << "\n";
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
        << (subject_of(gate).empty() ? "" : " of " + subject_of(gate)) << " above "
        << number_text(gate.limit) << " " << gate.unit << " caps the score at "
        << points_text(gate.cap_milli) << provisional_text(gate.is_provisional) << "\n";
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
  checked.bone = make_patient(coarse);
  checked.plan = plan_on(coarse, checked.bone);
  return checked;
}

std::string scenario_sheet(const Scenario& scenario) {
  std::ostringstream out;
  out << scenario.title << " (" << scenario.name << "), version " << scenario.version << ", "
      << review_label(scenario) << "\n\nIndication\n  " << scenario.indication << "\n\nSummary\n  "
      << scenario.summary << "\n";
  write_means(out, scenario);
  write_cuts(out, scenario);
  write_hinges(out, scenario);
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
