#include "ui/jobs/cut_mesh.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <system_error>

#include "database/database_error.h"
#include "simulator/cutting/cut.h"
#include "simulator/mesh/read_mesh.h"
#include "simulator/mesh/write_ply.h"

namespace hallux::ui {

namespace {

using namespace simulator;
namespace fs = std::filesystem;

constexpr double field_spacing_mm = 0.05;
constexpr double section_limit_mm = 200.0;

/// The kerf frame of a plane: its origin near the mesh, its axes along the mesh's where the normal is one of them.
KerfPlane plane_of(const CutGroup& group, const IndexedMesh& mesh) {
  Vec3 min_mm = mesh.points_mm.front(), max_mm = min_mm;
  for (const Vec3& point_mm : mesh.points_mm) {
    min_mm = glm::min(min_mm, point_mm);
    max_mm = glm::max(max_mm, point_mm);
  }
  const double length = std::sqrt(glm::dot(group.normal, group.normal));
  const Vec3 z = group.normal / length;
  const Vec3 middle_mm = 0.5 * (min_mm + max_mm);
  const Vec3 origin_mm = middle_mm + (group.offset / length - glm::dot(z, middle_mm)) * z;
  const Vec3 size(std::abs(z.x), std::abs(z.y), std::abs(z.z));
  const Vec3 y_hint = size.x >= size.y && size.x >= size.z ? Vec3(0.0, 0.0, 1.0)
                      : size.y >= size.z                   ? Vec3(1.0, 0.0, 0.0)
                                                           : Vec3(0.0, 1.0, 0.0);
  const Vec3 x = glm::cross(y_hint, z);
  return {{rotation_from_axes(x / std::sqrt(glm::dot(x, x)), glm::cross(z, x)), origin_mm},
          group.kerf_mm};
}

FieldGrid grid_around(const Section& section, const std::string& name) {
  Vec2 min_mm = section.regions.front().min_mm, max_mm = section.regions.front().max_mm;
  for (const SectionRegion& region : section.regions) {
    min_mm = glm::min(min_mm, region.min_mm);
    max_mm = glm::max(max_mm, region.max_mm);
  }
  const Vec2 size_mm = max_mm - min_mm;
  if (std::max(size_mm.x, size_mm.y) > section_limit_mm) {
    throw CutInputError(name + ": the plane's section of the mesh is wider than 200 mm; a sweep " +
                        "cuts smaller sections only, check that the mesh is in millimetres");
  }
  const auto nodes = [](double length_mm) {
    return static_cast<std::int32_t>(std::ceil(length_mm / field_spacing_mm)) + 9;
  };
  return {min_mm - Vec2(4.0 * field_spacing_mm), field_spacing_mm, nodes(size_mm.x),
          nodes(size_mm.y)};
}

/// Which regions the sweep goes through.
std::vector<std::uint8_t> swept_regions(const CutSolid& solid, const Bvh& bvh,
                                        const Section& section, const fs::path& sweep_file) {
  const Sweep sweep = read_sweep(sweep_file);
  const std::string name = sweep_file.filename().string();
  KerfField field(section.regions.empty() ? FieldGrid{.u_count = 1, .v_count = 1}
                                          : grid_around(section, name));
  stamp_sweep(field, section.plane, sweep, name);
  if (section.regions.empty()) return {};
  const SectionMask mask = mask_section(section, solid, bvh, field.grid());
  const std::vector<std::uint8_t> covered = covered_regions(mask, field);
  if (covered != touched_regions(mask, field)) {
    throw CutInputError(name +
                        ": the sweep stops inside the bone; a cut that stops inside the bone is " +
                        "not supported by this cutting method yet, lead the blade all the way "
                        "through");
  }
  return covered;
}

struct GroupCut {
  CutSolid solid;
  GroupOutcome outcome;
};

GroupCut cut_group(const CutSolid& solid, const CutGroup& group, std::int32_t kerf) {
  using Clock = std::chrono::steady_clock;
  using Milliseconds = std::chrono::duration<double, std::milli>;
  const Bvh bvh(solid.mesh);
  const auto slice_start = Clock::now();
  const Section section = slice_section(solid, bvh, plane_of(group, solid.mesh));
  const Milliseconds slicing = Clock::now() - slice_start;
  const std::vector<std::uint8_t> is_removed =
      group.sweep_file ? swept_regions(solid, bvh, section, *group.sweep_file)
                       : std::vector<std::uint8_t>(section.regions.size(), 1);
  const auto clip_start = Clock::now();
  GroupCut cut{remove_slab(solid, bvh, section, kerf, is_removed), {}};
  const Milliseconds clipping = Clock::now() - clip_start;
  cut.outcome.contact_ms = (slicing + clipping).count();
  cut.outcome.removed_mm3 = slab_volume_mm3(solid, section, is_removed);
  return cut;
}

bool is_closed_solid(const IndexedMesh& mesh, const std::string& name) {
  try {
    check_closed_solid(mesh, name);
    return true;
  } catch (const MeshError&) {
    return false;
  }
}

std::vector<IndexedMesh> sort_out_pieces(const CutSolid& solid, CutReport& report) {
  std::vector<IndexedMesh> meshes;
  for (CutSolid& piece : split_pieces(solid)) {
    const double volume_mm3 = signed_volume_mm3(piece.mesh);
    if (volume_mm3 < debris_limit_mm3) {
      report.debris_mm3 += volume_mm3;
      ++report.debris_pieces;
      continue;
    }
    const std::string file = "piece-" + std::to_string(meshes.size() + 1) + ".ply";
    report.pieces.push_back(
        {file, piece.mesh.triangles.size(), volume_mm3, is_closed_solid(piece.mesh, file)});
    meshes.push_back(std::move(piece.mesh));
  }
  return meshes;
}

[[noreturn]] void refuse_output(const std::string& sentence) {
  throw database::DatabaseError(database::DatabaseErrorKind::InputOutput, sentence);
}

/// Files under other names; those still there at the end are removed again.
class PendingFiles {
 public:
  PendingFiles() = default;
  PendingFiles(const PendingFiles&) = delete;
  PendingFiles& operator=(const PendingFiles&) = delete;
  ~PendingFiles() {
    std::error_code ignored;
    for (const fs::path& file : files_) fs::remove(pending(file), ignored);
  }
  void write(const IndexedMesh& mesh, const fs::path& file) {
    files_.push_back(file);
    write_ply(mesh, pending(file));
  }
  /// Either all files get their names or none.
  void publish() {
    for (const fs::path& file : files_) {
      if (fs::is_directory(file)) {
        throw fs::filesystem_error("rename", file, std::make_error_code(std::errc::is_a_directory));
      }
    }
    for (const fs::path& file : files_) fs::rename(pending(file), file);
    files_.clear();
  }

 private:
  static fs::path pending(const fs::path& file) { return file.string() + ".new"; }
  std::vector<fs::path> files_;
};

void write_pieces(const std::vector<IndexedMesh>& meshes, const CutReport& report,
                  const fs::path& folder) {
  try {
    fs::create_directories(folder);
    PendingFiles files;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      files.write(meshes[i], folder / report.pieces[i].file);
    }
    files.publish();
  } catch (const MeshError& error) {
    refuse_output(error.what());
  } catch (const fs::filesystem_error& error) {
    refuse_output(folder.string() + ": cannot be written (" + error.code().message() +
                  "); choose a folder with room and permission");
  }
}

}  // namespace

CutReport cut_mesh(const CutRequest& request, const assessment::Progress& progress) {
  assessment::report(progress, 0.0);
  CutSolid solid = uncut_solid(read_mesh(request.mesh_file));
  CutReport report;
  report.input_mm3 = signed_volume_mm3(solid.mesh);
  report.triangles_max = solid.mesh.triangles.size();
  const double stages = static_cast<double>(request.groups.size()) + 2.0;
  for (std::size_t i = 0; i < request.groups.size(); ++i) {
    assessment::report(progress, (static_cast<double>(i) + 1.0) / stages);
    if (solid.mesh.triangles.empty()) {
      report.cuts.emplace_back();
      continue;
    }
    GroupCut cut = cut_group(solid, request.groups[i], static_cast<std::int32_t>(i));
    solid = std::move(cut.solid);
    report.removed_mm3 += cut.outcome.removed_mm3;
    report.triangles_max = std::max(report.triangles_max, solid.mesh.triangles.size());
    report.cuts.push_back(cut.outcome);
  }
  const std::vector<IndexedMesh> meshes = sort_out_pieces(solid, report);
  assessment::report(progress, (stages - 1.0) / stages);
  write_pieces(meshes, report, request.output_folder);
  if (progress) progress(1.0);
  return report;
}

}  // namespace hallux::ui
