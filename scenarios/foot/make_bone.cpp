#include "scenarios/foot/make_bone.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "scenarios/foot/bone_field.h"
#include "scenarios/foot/canal.h"
#include "scenarios/foot/march_tetrahedra.h"
#include "scenarios/foot/remesh.h"
#include "scenarios/foot/topology.h"
#include "simulator/base/progress.h"

namespace hallux::scenarios {
namespace {

/// Raised whenever the same request may give another bone.
constexpr int generator_version = 3;
/// The canal is smoother than the outer surface.
constexpr double canal_edge_share = 1.5;

std::string text_of(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

void check_range(const char* what, double value, double low, double high, const char* also) {
  if (value >= low && value <= high) return;
  throw ScenarioError(std::string(what) + " " + text_of(value) + " is out of range; ask for " +
                      text_of(low) + " to " + text_of(high) + also);
}

void check_eminence(const BoneTable& table, double eminence_mm) {
  if (eminence_mm == 0.0) return;
  if (!table.eminence) {
    throw ScenarioError("eminence_mm " + text_of(eminence_mm) + " is asked of the bone \"" +
                        table.bone + "\", on which none grows; ask for 0");
  }
  check_range("eminence_mm", eminence_mm, 1.0, 8.0, ", or 0 for the table's own bump");
}

void check_request(const BoneTable& table, const BoneRequest& request) {
  if (request.length_mm != 0.0) {
    check_range("length_mm", request.length_mm, 0.75 * table.length_mm, 1.3 * table.length_mm,
                ", or 0 for the table's own length");
  }
  check_eminence(table, request.eminence_mm);
  check_range("edge_mm", request.edge_mm, 0.2, 1.5, "");
}

simulator::IndexedMesh make_outer(const BoneField& bone, double edge_mm, const Progress& progress) {
  const Field field = [&bone](const Vec3& point_mm) { return bone.at(point_mm); };
  SampleBox box;
  box.low_mm = bone.low_mm();
  box.high_mm = bone.high_mm();
  box.spacing_mm = std::clamp(2.0 * edge_mm, 0.4, 1.0);
  const simulator::IndexedMesh raw = march_tetrahedra(sample_field(field, box));
  check_sphere(raw, "outer surface");
  report(progress, 0.1);
  simulator::IndexedMesh outer = remesh(raw, field, edge_mm, part_of(progress, 0.1, 0.6));
  check_sphere(outer, "outer surface");
  return outer;
}

std::string generator_of(const BoneTable& table, const BoneRequest& request, double length_mm) {
  const std::string eminence =
      table.eminence ? " eminence_mm " + text_of(request.eminence_mm) : std::string();
  return table.bone + " " + table.shape + " generator " + std::to_string(generator_version) +
         " length_mm " + text_of(length_mm) + eminence + " edge_mm " + text_of(request.edge_mm) +
         (request.with_canal ? "" : " without canal");
}

RigidTransform placed(const BonePlace& place) {
  const Vec3 along = place.head_in_world_mm - place.base_in_world_mm;
  return {rotation_from_axes(along, {0.0, 1.0, 0.0}), place.base_in_world_mm};
}

}  // namespace

simulator::Bone make_bone(const BoneTable& table, const BoneRequest& request, const BoneKind& kind,
                          const Progress& progress) {
  if (table.bone != kind.name) {
    throw ScenarioError("a table of the bone \"" + table.bone + "\" was given to make a " +
                        std::string(kind.name) + "; give that bone's own table");
  }
  check_request(table, request);
  report(progress, 0.0);
  const double length_mm = request.length_mm == 0.0 ? table.length_mm : request.length_mm;
  const BoneField field(table, length_mm, request.eminence_mm);
  simulator::Bone bone;
  bone.name = table.bone;
  bone.generator = generator_of(table, request, length_mm);
  bone.credit = table.credit;
  bone.outer = make_outer(field, request.edge_mm, progress);
  bone.cortex = simulator::CortexLaw{table.cortex.mid_mm, table.cortex.floor_mm, length_mm};
  if (request.with_canal) {
    bone.canal = make_canal(bone.outer, *bone.cortex, canal_edge_share * request.edge_mm,
                            part_of(progress, 0.6, 0.95));
  }
  bone.landmarks = kind.find_landmarks({table, field, bone.outer, length_mm});
  bone.world_from_bone = placed(table.place);
  report(progress, 1.0);
  return bone;
}

}  // namespace hallux::scenarios
