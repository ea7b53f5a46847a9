#include "ui/jobs/course/operation_sheet.h"

#include "ui/jobs/course/sheet_text.h"

namespace hallux::ui {
namespace {

using namespace scenarios;

std::string words_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string of_bone(const std::string& bone) { return bone.empty() ? "" : " of " + bone; }

std::string range_text(const Range& range) {
  return sheet_number(range.low_mm) + " to " + sheet_number(range.high_mm) + " mm";
}

std::string place_text(const NamedPoint& point) {
  if (point.kind == PointKind::Between) {
    return "from " + point.from + " to " + point.to + ", a share of " + sheet_number(point.share);
  }
  if (point.kind == PointKind::OnSurface)
    return "on the bone's surface from " + point.from + " along " + point.along;
  std::string text = "at " + point.from;
  for (const MoveAlong& move : point.moves)
    text += ", " + sheet_number(move.mm) + " mm " + move.along;
  return text;
}

std::string direction_words(const NamedDirection& direction) {
  switch (direction.kind) {
    case DirectionKind::Between:
      return "from " + direction.first + " to " + direction.second;
    case DirectionKind::SquareToBoth:
      return "square to " + direction.first + " and " + direction.second;
    case DirectionKind::Turned:
      return direction.first + " turned by " + sheet_angle(direction.turn_rad) + " about " +
             direction.second;
    case DirectionKind::LaidSquare:
      return direction.first + " laid square to " + direction.second;
  }
  return "";
}

std::string move_text(const FragmentMove& move) {
  if (move.is_turn)
    return "turned by " + sheet_angle(move.turn_rad) + " about " + move.direction + " through " +
           move.through;
  return sheet_number(move.slide_mm) + " mm along " + move.direction;
}

void write_implant(std::ostream& out, const Implant& implant) {
  out << "  " << implant.name << ": " << implant.title << of_bone(implant.bone) << ", "
      << (implant.kind == ImplantKind::Wire ? "wire" : "screw") << " of "
      << range_text(implant.diameter) << " from " << implant.entry << " along " << implant.direction
      << "\n      " << range_text(implant.length) << " deep, through " << implant.cortices
      << " cortices, holds " << words_of(implant.engages);
  for (const ImplantClearance& clear : implant.clear_of)
    out << "; " << sheet_number(clear.least_mm) << " mm clear of " << clear.joint_surface;
  out << (implant.is_temporary ? "; comes out again" : "") << "\n";
  write_origin(out, implant.origin);
}

}  // namespace

void write_further_means(std::ostream& out, const Scenario& scenario) {
  for (const PatientRequest& bone : scenario.further_bones) {
    out << "  " << bone.bone << ", length " << sheet_number(bone.length_mm) << " mm, eminence "
        << sheet_number(bone.eminence_mm) << " mm, edge " << sheet_number(bone.edge_mm)
        << " mm, bone quality " << sheet_number(bone.bone_quality) << "\n";
    write_origin(out, bone.origin);
  }
  for (std::size_t i = 1; i < scenario.blades.size(); ++i) {
    const BladeOffer& offer = scenario.blades[i];
    out << "  " << offer.title << " (" << offer.name << "): width "
        << sheet_number(offer.saw.blade.width_mm) << " mm, depth "
        << sheet_number(offer.saw.blade.depth_mm) << " mm, thickness "
        << sheet_number(offer.saw.blade.thickness_mm) << " mm, kerf "
        << sheet_number(offer.saw.blade.kerf_mm) << " mm, "
        << sheet_number(offer.saw.cycles_per_minute) << " cycles/min, sharpness "
        << sheet_number(offer.saw.sharpness) << "\n";
    write_origin(out, offer.origin);
  }
}

void write_places(std::ostream& out, const Scenario& scenario) {
  if (!scenario.points.empty()) out << "\nPoints\n";
  for (const NamedPoint& point : scenario.points) {
    out << "  " << point.name << of_bone(point.bone) << ": " << place_text(point) << "\n";
    write_origin(out, point.origin);
  }
  if (!scenario.directions.empty()) out << "\nDirections\n";
  for (const NamedDirection& direction : scenario.directions) {
    out << "  " << direction.name << of_bone(direction.bone) << ": " << direction_words(direction)
        << "\n";
    write_origin(out, direction.origin);
  }
}

void write_fixation(std::ostream& out, const Scenario& scenario) {
  if (!scenario.fragments.empty()) out << "\nFragments and how they are shifted\n";
  for (const Fragment& fragment : scenario.fragments) {
    out << "  " << fragment.name << of_bone(fragment.bone) << ": " << fragment.title << ", holds "
        << fragment.holds << "\n";
    write_origin(out, fragment.origin);
  }
  for (const FragmentShift& shift : scenario.shifts) {
    out << "  " << shift.name << ": " << shift.title << ", of " << shift.fragment;
    for (const FragmentMove& move : shift.moves) out << "; " << move_text(move);
    out << (shift.is_closed ? "; closed until the faces touch" : "") << "\n";
    write_origin(out, shift.origin);
  }
  if (!scenario.implants.empty()) out << "\nWires and screws\n";
  for (const Implant& implant : scenario.implants) write_implant(out, implant);
}

std::string order_text(const OperationStep& step) {
  std::string text;
  if (!step.after.empty()) text += ", after " + words_of(step.after);
  if (!step.one_of.empty()) text += ", one of " + step.one_of;
  if (step.is_optional) text += ", optional";
  return text;
}

}  // namespace hallux::ui
