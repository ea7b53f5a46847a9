// The block in its own frame, cut at x = 0; the piece that comes free is its distal end. It lies so
// that the operator's view shows cut, tooth line and feed all aslant.
//
//        medial
//        |   approach                 The top is crowned: its highest line, y = 0, is the entry.
//     ___|___v_________
//    |       |   end   |  4 mm        Wide enough for two passes of the blade, and low, so that
//    |_______0_________|---> x        a stroke takes seconds. The tooth line lies along y.
//    -19              11
#include "scenarios/practice_block.h"

#include <array>
#include <map>
#include <utility>

namespace hallux::scenarios {

namespace {

constexpr double edge_mm = 1.0, half_width_mm = 9.0, height_mm = 4.0, crown_mm = 0.3;
/// Off the lattice of the edges: no plane of a cut at 0 runs along a row of corners.
constexpr double low_x_mm = -18.65;
constexpr int cells_along = 30, cells_up = 4, cells_across = 18;

using Place = std::array<int, 3>;

/// Of a lattice: along, up to the approach, across.
class BlockMesh {
 public:
  BlockMesh() {
    add_sides({1, 2, 0}, cells_along);
    add_sides({2, 0, 1}, cells_up);
    add_sides({0, 1, 2}, cells_across);
  }
  simulator::IndexedMesh take() { return std::move(mesh_); }

 private:
  /// The two sides square to the last of these axes, at 0 and at that many cells.
  void add_sides(const std::array<std::size_t, 3>& axes, int far) {
    constexpr Place cells{cells_along, cells_up, cells_across};
    for (int i = 0; i < cells[axes[0]]; ++i) {
      for (int j = 0; j < cells[axes[1]]; ++j) {
        add_quad(axes, {i, j, far}, true);
        add_quad(axes, {i, j, 0}, false);
      }
    }
  }

  void add_quad(const std::array<std::size_t, 3>& axes, const Place& at, bool is_far) {
    const auto corner = [&](int more_i, int more_j) {
      Place place{};
      place[axes[0]] = at[0] + more_i;
      place[axes[1]] = at[1] + more_j;
      place[axes[2]] = at[2];
      return point(place);
    };
    const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
    mesh_.triangles.push_back(is_far ? simulator::Triangle{a, b, c} : simulator::Triangle{a, c, b});
    mesh_.triangles.push_back(is_far ? simulator::Triangle{a, c, d} : simulator::Triangle{a, d, c});
  }

  std::uint32_t point(const Place& place) {
    const auto next = static_cast<std::uint32_t>(mesh_.points_mm.size());
    const auto [found, is_new] = points_.emplace(place, next);
    if (is_new) mesh_.points_mm.push_back(place_mm(place));
    return found->second;
  }

  static Vec3 place_mm(const Place& place) {
    const double across_mm = edge_mm * place[2] - half_width_mm;
    const double share = across_mm / half_width_mm;
    const double top_mm = height_mm - crown_mm * share * share;
    return {low_x_mm + edge_mm * place[0], across_mm, -top_mm * place[1] / cells_up};
  }

  simulator::IndexedMesh mesh_;
  std::map<Place, std::uint32_t> points_;
};

simulator::Bone block_bone() {
  simulator::Bone bone;
  bone.name = "practice_block";
  bone.generator = "practice block 1";
  bone.outer = BlockMesh().take();
  bone.landmarks = {{"cut_medial", {0.0, 0.0, -height_mm}}, {"cut_lateral", {0.0, 0.0, 0.0}}};
  return bone;
}

ReferenceCut cut_across() {
  ReferenceCut cut;
  cut.name = "across";
  cut.title = "Across the block";
  cut.face.kind = FaceKind::Transverse;
  cut.face.through = "cut_medial";
  cut.face.axis_from = "cut_medial";
  cut.face.axis_to = "cut_lateral";
  cut.waste_side = "distal";
  cut.approach = "medial";
  return cut;
}

OperationStep step_of(StepKind kind, std::string title, std::string cut) {
  OperationStep step;
  step.kind = kind;
  step.title = std::move(title);
  step.cut = std::move(cut);
  return step;
}

/// Seen as the first shipped operation is: the blade's plane at some 25 degrees, the saw from a
/// lower corner. It begins beside the cut, so that there is a way to go.
StartingPlace start_beside() {
  StartingPlace start;
  start.eye_in_bone = unit(Vec3(0.4, 0.14, -0.91));
  start.up_in_bone = unit(Vec3(0.13, 0.97, 0.21));
  start.radius_mm = 30.0;
  start.tip_from_entry_mm = {4.0, -6.0, -10.0};
  start.feed_in_bone = {0.0, 0.0, 1.0};
  start.normal_in_bone = {1.0, 0.0, 0.0};
  return start;
}

}  // namespace

PracticeBlock make_practice_block() {
  PracticeBlock block;
  block.bone = block_bone();
  Scenario& scenario = block.scenario;
  scenario.name = block.bone.name;
  scenario.title = "Practice block";
  scenario.patient.bone = block.bone.name;
  scenario.patient.edge_mm = edge_mm;
  // As soft as a patient may be: who learns need not wait.
  scenario.patient.bone_quality = 0.5;
  scenario.saw.blade = {.width_mm = 12.0, .depth_mm = 25.0, .kerf_mm = 0.5, .thickness_mm = 0.4};
  scenario.cuts = {cut_across()};
  scenario.steps = {step_of(StepKind::Verify, "Look", {}),
                    step_of(StepKind::Cut, "Saw across", "across"),
                    step_of(StepKind::Remove, "Take the end out", "across"),
                    step_of(StepKind::Finish, "Finish", {})};
  scenario.start = start_beside();
  return block;
}

}  // namespace hallux::scenarios
