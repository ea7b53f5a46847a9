#include "ui/jobs/left_behind_json.h"

#include <numeric>

#include "simulator/base/units.h"
#include "ui/jobs/geometry_json.h"

namespace hallux::ui {

namespace {

using assessment::Body;
using assessment::BodyPlacement;
using nlohmann::ordered_json;

ordered_json number_or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

/// The names of a bone from elsewhere may be no UTF-8.
std::string text_of(const ordered_json& json) {
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

/// From where it was cut to where it lies, all in the frame of the first bone.
RigidTransform way_in_first(const Body& body, const simulator::Bones& bones) {
  const RigidTransform& way = body.bone_from_piece;
  const bool is_moved =
      way.rotation != RigidTransform{}.rotation || way.translation_mm != Vec3{0.0};
  if (body.bone == 0 || !is_moved) return way;
  return body.first_from_piece * inverse(first_from(bones, body.bone));
}

}  // namespace

std::string piece_file_name(std::size_t piece) {
  return "piece-" + std::to_string(piece + 1) + ".ply";
}

std::string body_file_name(std::size_t piece) {
  return "body-" + std::to_string(piece + 1) + ".ply";
}

ordered_json fragments_json(const LeftBehind& left) {
  ordered_json all = ordered_json::array();
  for (std::size_t i = 0; i < left.bodies.size(); ++i) {
    const Body& body = left.bodies[i];
    const BodyPlacement& placement = left.placements[i];
    all.push_back({{"name", body.name},
                   {"taken_out", body.fragment < 0},
                   {"volume_mm3", body.volume_mm3},
                   {"moved_mm", placement.moved_mm},
                   {"turned_deg", placement.turned_deg},
                   {"error_mm", number_or_null(placement.error_mm)},
                   {"error_deg", number_or_null(placement.error_deg)},
                   {"contact_share", number_or_null(placement.contact_share)},
                   {"gap_max_mm", number_or_null(placement.gap_max_mm)},
                   {"overlap_max_mm", placement.overlap_max_mm},
                   {"held", static_cast<bool>(left.is_held[i])}});
  }
  return all;
}

ordered_json implants_json(const LeftBehind& left) {
  ordered_json all = ordered_json::array();
  for (const assessment::PlacedImplant& implant : left.fixation.implants) {
    all.push_back({{"kind", implant.is_screw ? "screw" : "wire"},
                   {"entry_in_bone_mm", vector_json(implant.entry_in_bone_mm)},
                   {"tip_in_bone_mm", vector_json(implant.tip_in_bone_mm)},
                   {"diameter_mm", implant.diameter_mm},
                   {"length_mm", implant.length_mm},
                   {"engages", implant.engages},
                   {"cortices", implant.cortices},
                   {"tip_to_joint_mm", number_or_null(implant.tip_to_joint_mm)},
                   {"insertions", implant.insertions}});
  }
  return all;
}

ordered_json balance_json(const LeftBehind& left) {
  const assessment::RebuiltBone& rebuilt = left.rebuilt;
  const double pieces_mm3 =
      std::accumulate(rebuilt.piece_volumes_mm3.begin(), rebuilt.piece_volumes_mm3.end(), 0.0);
  return {
      {"input_mm3", rebuilt.input_mm3()},
      {"pieces_mm3", pieces_mm3},
      {"removed_mm3", rebuilt.removed_mm3},
      {"debris_mm3", rebuilt.debris_mm3},
      {"error_mm3", rebuilt.input_mm3() - pieces_mm3 - rebuilt.removed_mm3 - rebuilt.debris_mm3},
      {"holes_mm3", left.fixation.holes_mm3},
      {"holes_bound_mm3", left.fixation.holes_bound_mm3}};
}

ordered_json steps_json(const LeftBehind& left, const scenarios::Scenario& scenario) {
  ordered_json all = ordered_json::array();
  for (std::size_t i = 0; i < left.done_ticks.size(); ++i) {
    const scenarios::OperationStep& step = scenario.steps[i];
    const std::optional<std::int64_t>& tick = left.done_ticks[i];
    all.push_back({{"step", i + 1},
                   {"id", step.id.empty() ? ordered_json() : ordered_json(step.id)},
                   {"title", step.title},
                   {"done", tick.has_value()},
                   {"done_s", tick ? ordered_json(second_from_tick(*tick)) : ordered_json()}});
  }
  return all;
}

std::string fragments_file(const LeftBehind& left, const simulator::Bones& bones,
                           std::string (*name_of)(std::size_t)) {
  ordered_json all = ordered_json::array();
  for (const Body& body : left.bodies) {
    all.push_back({{"name", body.name},
                   {"files", {name_of(body.piece)}},
                   {"pose", matrix_json(way_in_first(body, bones))},
                   {"taken_out", body.fragment < 0}});
  }
  return text_of(all);
}

std::string implants_file(const LeftBehind& left) { return text_of(implants_json(left)); }

}  // namespace hallux::ui
