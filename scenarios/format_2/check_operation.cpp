// Points, directions, hinges and cuts name each other, so their names are one list without a name
// twice: whoever reads a name in a file finds it in one place. Each refers to what can be placed
// before it; so no check here needs a bone, and planning always comes to an end.
#include "scenarios/format_2/check_operation.h"

#include <map>

#include "scenarios/check_names.h"
#include "scenarios/format_2/check_ordered_steps.h"
#include "scenarios/geometry/geometry_order.h"

namespace hallux::scenarios {
namespace {

class OperationCheck {
 public:
  OperationCheck(const Scenario& scenario, std::string_view file)
      : scenario_(scenario), file_(file) {}

  void run() {
    check_bones();
    check_own_names();
    check_shared_names();
    geometry_order({scenario_.points, scenario_.directions}, file_);
    for (std::size_t i = 0; i < scenario_.cuts.size(); ++i) check_cut(i);
    for (std::size_t i = 0; i < scenario_.hinges.size(); ++i) check_hinge(i);
    for (std::size_t i = 0; i < scenario_.shifts.size(); ++i) check_shift(i);
    check_implants();
  }

 private:
  bool is_bone(std::string_view name) const {
    return name == scenario_.patient.bone ||
           std::ranges::any_of(scenario_.further_bones,
                               [&](const PatientRequest& bone) { return bone.bone == name; });
  }

  std::string bone_names() const {
    std::string names = scenario_.patient.bone;
    for (const PatientRequest& bone : scenario_.further_bones) names += ", " + bone.bone;
    return names;
  }

  template <typename Part>
  void check_bones_of(const std::vector<Part>& parts, std::string_view list) const {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].bone.empty() || is_bone(parts[i].bone)) continue;
      refuse(file_, path_of(list, i, "bone"),
             is_text(parts[i].bone) + ", which is no bone of the patient",
             "name one of: " + bone_names());
    }
  }

  void check_bones() const {
    std::set<std::string_view> seen{scenario_.patient.bone};
    for (std::size_t i = 0; i < scenario_.further_bones.size(); ++i) {
      if (seen.insert(scenario_.further_bones[i].bone).second) continue;
      refuse(file_, path_of("patient.bones", i + 1, "bone"),
             is_text(scenario_.further_bones[i].bone) + ", which is already there",
             "ask for each bone once");
    }
    for (std::size_t i = 0; i < scenario_.further_bones.size(); ++i) {
      if (scenario_.further_bones[i].bone_quality == scenario_.patient.bone_quality) continue;
      refuse(file_, path_of("patient.bones", i + 1, "bone_quality"),
             "is another than that of the first bone", "give all bones of a patient the same");
    }
    check_bones_of(scenario_.points, "points");
    check_bones_of(scenario_.directions, "directions");
    check_bones_of(scenario_.cuts, "cuts");
    check_bones_of(scenario_.fragments, "fragments");
    check_bones_of(scenario_.danger_zones, "danger_zones");
    check_bones_of(scenario_.joint_surfaces, "joint_surfaces");
    for (std::size_t i = 0; i < scenario_.implants.size(); ++i) {
      const std::string& bone = scenario_.implants[i].bone;
      if (!bone.empty() && !is_bone(bone))
        refuse(file_, implant_path(i, "bone"), is_text(bone) + ", which is no bone of the patient",
               "name one of: " + bone_names());
    }
  }

  void check_own_names() const {
    check_names(scenario_.blades, &BladeOffer::name, "blades", "name", file_);
    check_names(scenario_.fragments, &Fragment::name, "fragments", "name", file_);
    check_names(scenario_.shifts, &FragmentShift::name, "shifts", "name", file_);
    std::set<std::string_view> implants;
    for (std::size_t i = 0; i < scenario_.implants.size(); ++i) {
      if (implants.insert(scenario_.implants[i].name).second) continue;
      refuse(file_, implant_path(i, "name"),
             is_text(scenario_.implants[i].name) + ", which is already taken",
             "give each wire and screw its own");
    }
    for (std::size_t i = 0; i < scenario_.fragments.size(); ++i) {
      if (is_bone(scenario_.fragments[i].name))
        refuse(file_, path_of("fragments", i, "name"),
               is_text(scenario_.fragments[i].name) + ", which is a bone", "choose another name");
    }
  }

  template <typename Part>
  void add_names(const std::vector<Part>& parts, std::string_view list,
                 std::set<std::string_view>& taken) const {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (taken.insert(parts[i].name).second && !is_axis_name(parts[i].name)) continue;
      refuse(file_, path_of(list, i, "name"), is_text(parts[i].name) + ", which is already taken",
             "choose a name that no axis, point, direction, cut or hinge has");
    }
  }

  void check_shared_names() const {
    std::set<std::string_view> taken;
    add_names(scenario_.points, "points", taken);
    add_names(scenario_.directions, "directions", taken);
    add_names(scenario_.cuts, "cuts", taken);
    add_names(scenario_.hinges, "hinges", taken);
  }

  void check_direction(const std::string& name, const std::string& path,
                       bool may_be_hinge = false) const {
    if (is_axis_name(name) || has_name(scenario_.directions, name)) return;
    if (may_be_hinge && has_name(scenario_.hinges, name)) return;
    std::string known;
    for (const std::string_view axis : axis_names())
      known.append(known.empty() ? "" : ", ").append(axis);
    for (const NamedDirection& direction : scenario_.directions) known += ", " + direction.name;
    refuse(file_, path, is_text(name) + ", which is no direction", "use one of: " + known);
  }

  /// A face through a hinge is the hinge's second cut, and stands after the first.
  void check_through_hinge(std::size_t index) const {
    const ReferenceCut& cut = scenario_.cuts[index];
    for (const ReferenceHinge& hinge : scenario_.hinges) {
      const bool is_through = cut.face.through == hinge.name;
      const bool is_second = cut.name == hinge.second_cut;
      if (is_through == is_second && (cut.face.contains == hinge.name) == is_second) continue;
      refuse(file_, path_of("cuts", index, "face"),
             is_second ? "does not contain the hinge \"" + hinge.name + "\", whose second cut it is"
                       : "contains the hinge \"" + hinge.name + "\", whose second cut is another",
             "name the hinge in \"through\" and in \"contains\" of its second cut, and only there");
    }
  }

  void check_cut(std::size_t index) const {
    const ReferenceCut& cut = scenario_.cuts[index];
    const auto path = [&](std::string_view key) { return path_of("cuts", index, key); };
    check_through_hinge(index);
    check_direction(cut.face.contains, path("face.contains"), true);
    if (has_name(scenario_.cuts, cut.face.turned_from)) {
      const auto before =
          std::ranges::find(scenario_.cuts, cut.face.turned_from, &ReferenceCut::name) -
          scenario_.cuts.begin();
      const bool is_earlier = before < static_cast<std::ptrdiff_t>(index);
      if (!is_earlier || scenario_.cuts[static_cast<std::size_t>(before)].bone != cut.bone)
        refuse(file_, path("face.from"),
               is_text(cut.face.turned_from) + ", which is no earlier cut of this bone",
               "name a direction, or a cut that stands before it");
    } else {
      check_direction(cut.face.turned_from, path("face.from"));
    }
    check_direction(cut.keep, path(cut.keeps_both ? "measured" : "keep"));
    check_direction(cut.approach, path("approach"));
    if (cut.window) {
      check_direction(cut.window->along, path("window.along"));
      if (cut.window->limits) check_direction(cut.window->across, path("window.across"));
    }
    if (!cut.blade.empty()) check_named(scenario_.blades, cut.blade, "blade", path("blade"), file_);
  }

  void check_hinge(std::size_t index) const {
    const ReferenceHinge& hinge = scenario_.hinges[index];
    const auto path = [&](std::string_view key) { return path_of("hinges", index, key); };
    check_named(scenario_.cuts, hinge.first_cut, "cut", path("first_cut"), file_);
    check_named(scenario_.cuts, hinge.second_cut, "cut", path("second_cut"), file_);
    const auto first = std::ranges::find(scenario_.cuts, hinge.first_cut, &ReferenceCut::name);
    const auto second = std::ranges::find(scenario_.cuts, hinge.second_cut, &ReferenceCut::name);
    if (first >= second || first->bone != second->bone)
      refuse(file_, path("second_cut"),
             is_text(hinge.second_cut) + ", which does not stand after the first on the same bone",
             "name a cut of that bone that stands after \"" + hinge.first_cut + "\"");
    check_direction(hinge.side, path("side"));
    check_direction(hinge.along, path("along"));
    if (!hinge.moves.empty()) check_direction(hinge.moves, path("moves"));
  }

  void check_shift(std::size_t index) const {
    const FragmentShift& shift = scenario_.shifts[index];
    check_named(scenario_.fragments, shift.fragment, "fragment",
                path_of("shifts", index, "fragment"), file_);
    for (std::size_t i = 0; i < shift.moves.size(); ++i) {
      const FragmentMove& move = shift.moves[i];
      const std::string key =
          "moves[" + std::to_string(i) + "]." + (move.is_turn ? "turn" : "slide");
      check_direction(move.direction, path_of("shifts", index, key), true);
    }
  }

  /// Wires and screws are lists of their own in the file.
  std::string implant_path(std::size_t index, std::string_view key) const {
    const ImplantKind kind = scenario_.implants[index].kind;
    std::size_t before = 0;
    for (std::size_t i = 0; i < index; ++i) before += scenario_.implants[i].kind == kind ? 1 : 0;
    return path_of(kind == ImplantKind::Wire ? "wires" : "screws", before, key);
  }

  void check_implants() const {
    for (std::size_t i = 0; i < scenario_.implants.size(); ++i) {
      const Implant& implant = scenario_.implants[i];
      check_direction(implant.direction, implant_path(i, "direction"), true);
      for (std::size_t j = 0; j < implant.engages.size(); ++j) {
        const std::string& body = implant.engages[j];
        if (has_name(scenario_.fragments, body) || is_bone(body)) continue;
        std::string known = bone_names();
        for (const Fragment& fragment : scenario_.fragments) known += ", " + fragment.name;
        refuse(file_, implant_path(i, "engages[" + std::to_string(j) + "]"),
               is_text(body) + ", which is no fragment and no bone", "name one of: " + known);
      }
      for (std::size_t j = 0; j < implant.clear_of.size(); ++j)
        check_named(scenario_.joint_surfaces, implant.clear_of[j].joint_surface, "joint surface",
                    implant_path(i, "clear_of[" + std::to_string(j) + "].joint_surface"), file_);
    }
  }

  const Scenario& scenario_;
  std::string_view file_;
};

}  // namespace

void check_operation(const Scenario& scenario, std::string_view file) {
  OperationCheck(scenario, file).run();
  check_ordered_steps(scenario, file);
}

}  // namespace hallux::scenarios
