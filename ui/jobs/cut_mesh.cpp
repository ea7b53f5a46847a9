#include "ui/jobs/cut_mesh.h"

#include <algorithm>
#include <utility>

#include "database/store/output_place.h"
#include "simulator/base/progress.h"
#include "simulator/bone/close_wedge.h"
#include "simulator/mesh/read_mesh.h"
#include "ui/jobs/cut_sweep.h"
#include "ui/jobs/write_pieces.h"

namespace hallux::ui {

namespace {

using namespace simulator;

bool is_closed_solid(const IndexedMesh& mesh, const std::string& name) {
  try {
    check_closed_solid(mesh, name);
    return true;
  } catch (const MeshError&) {
    return false;
  }
}

/// The pieces that count, largest first; the debris goes into the report.
std::vector<CutSolid> bodies_of(const CutSolid& solid, CutReport& report) {
  SortedBodies sorted = sort_bodies(split_pieces(solid));
  report.debris_mm3 = sorted.debris_mm3;
  report.debris_pieces = sorted.crumbs.size();
  return std::move(sorted.bodies);
}

const OpenedKerf& kerf_of_group(const SawnBone& bone, const CutReport& report, std::size_t group) {
  const std::optional<std::size_t> number = report.cuts[group].kerf;
  const OpenedKerf* const kerf = number ? bone.find_number(*number) : nullptr;
  if (kerf != nullptr) return *kerf;
  throw CutInputError("--close: the plane of group " + std::to_string(group + 1) +
                      " misses the bone; give two groups that cut it");
}

std::optional<WedgeClosure> close_if_asked(const CutRequest& request, SawnBone& bone,
                                           const CutReport& report, std::vector<CutSolid>& bodies) {
  if (!request.close) return std::nullopt;
  const OpenedKerf& first = kerf_of_group(bone, report, request.close->first);
  const OpenedKerf& second = kerf_of_group(bone, report, request.close->second);
  try {
    return close_wedge(bone, first, second, bodies);
  } catch (const MeshError& error) {
    throw CutInputError("--close " + std::to_string(first.number + 1) + "," +
                        std::to_string(second.number + 1) + ": " + error.what());
  }
}

/// Places of the bodies, the largest first.
std::vector<std::size_t> by_volume(const std::vector<CutSolid>& bodies) {
  std::vector<double> volumes_mm3;
  std::vector<std::size_t> order;
  for (const CutSolid& body : bodies) {
    order.push_back(order.size());
    volumes_mm3.push_back(signed_volume_mm3(body.mesh));
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return volumes_mm3[a] > volumes_mm3[b]; });
  return order;
}

HingeReport hinge_report(const WedgeClosure& closure, const std::vector<std::size_t>& order) {
  const auto file_of = [&](std::size_t body) {
    const auto found = std::find(order.begin(), order.end(), body);
    return piece_file(static_cast<std::size_t>(found - order.begin()));
  };
  return {closure.outcome,        closure.thickness_mm,   closure.angle_rad,
          file_of(closure.wedge), file_of(closure.fixed), file_of(closure.moved)};
}

std::vector<IndexedMesh> name_pieces(std::vector<CutSolid> bodies,
                                     const std::vector<std::size_t>& order, CutReport& report) {
  std::vector<IndexedMesh> meshes;
  for (const std::size_t body : order) {
    IndexedMesh& mesh = bodies[body].mesh;
    const std::string file = piece_file(meshes.size());
    report.pieces.push_back(
        {file, mesh.triangles.size(), signed_volume_mm3(mesh), is_closed_solid(mesh, file)});
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

}  // namespace

double CutReport::missing_mm3() const noexcept {
  double missing_mm3 = input_mm3 - removed_mm3 - debris_mm3;
  for (const WrittenPiece& piece : pieces) missing_mm3 -= piece.volume_mm3;
  return missing_mm3;
}

CutReport cut_mesh(const CutRequest& request, const Progress& progress) {
  report(progress, 0.0);
  database::check_outside(request.output_folder, request.data_directory);
  SawnBone bone(read_mesh(request.mesh_file));
  CutReport report;
  report.input_mm3 = signed_volume_mm3(bone.whole().mesh);
  const double stages = static_cast<double>(request.groups.size()) + 2.0;
  for (const CutGroup& group : request.groups) {
    const double stage = static_cast<double>(report.cuts.size()) + 1.0;
    hallux::report(progress, stage / stages);
    report.cuts.push_back(
        saw(bone, group, part_of(progress, stage / stages, (stage + 1.0) / stages)));
  }
  report.removed_mm3 = bone.removed_mm3();
  hallux::report(progress, (stages - 1.0) / stages);
  std::vector<CutSolid> bodies = bodies_of(bone.solid(), report);
  const std::optional<WedgeClosure> closure = close_if_asked(request, bone, report, bodies);
  const std::vector<std::size_t> order = by_volume(bodies);
  if (closure) report.hinge = hinge_report(*closure, order);
  const std::vector<IndexedMesh> meshes = name_pieces(std::move(bodies), order, report);
  hallux::report(progress, (stages - 0.5) / stages);
  write_pieces(meshes, request.output_folder, request.data_directory);
  if (progress) progress(1.0);
  return report;
}

}  // namespace hallux::ui
