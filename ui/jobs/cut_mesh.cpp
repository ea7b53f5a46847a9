#include "ui/jobs/cut_mesh.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "database/files.h"
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

/// A folder of its own within the output folder, so that no file there is in the way; gone at the end.
class PendingFolder {
 public:
  explicit PendingFolder(const fs::path& folder) {
    std::string name = (folder / ".pieces-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw database::output_error(folder, errno);
    folder_ = name;
  }
  ~PendingFolder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  PendingFolder(const PendingFolder&) = delete;
  PendingFolder& operator=(const PendingFolder&) = delete;
  const fs::path& path() const noexcept { return folder_; }

 private:
  fs::path folder_;
};

/// N of "piece-N.ply" as this program writes it, else 0.
std::size_t piece_number(const std::string& name) {
  constexpr std::string_view start = "piece-", end = ".ply";
  std::size_t number = 0;
  if (name.size() > start.size() + end.size()) {
    std::from_chars(name.data() + start.size(), name.data() + name.size() - end.size(), number);
  }
  return name == std::string(start) + std::to_string(number) + std::string(end) ? number : 0;
}

/// Pieces of an earlier cut that this one has no pieces for would be taken for its own.
void remove_stale_pieces(const fs::path& folder, std::size_t piece_count) {
  std::vector<fs::path> stale;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const bool is_stale = piece_number(entry.path().filename().string()) > piece_count;
    if (is_stale && entry.is_regular_file()) stale.push_back(entry.path());
  }
  for (const fs::path& file : stale) fs::remove(file);
}

/// Writes all pieces before the first one gets its name.
void write_pieces(const std::vector<IndexedMesh>& meshes, const CutReport& report,
                  const fs::path& folder) {
  try {
    fs::create_directories(folder);
    const PendingFolder pending(folder);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      write_ply(meshes[i], pending.path() / report.pieces[i].file);
    }
    for (const WrittenPiece& piece : report.pieces) {
      if (fs::is_directory(folder / piece.file)) {
        throw database::output_error(folder / piece.file, EISDIR);
      }
    }
    for (const WrittenPiece& piece : report.pieces) {
      fs::rename(pending.path() / piece.file, folder / piece.file);
    }
    remove_stale_pieces(folder, report.pieces.size());
  } catch (const MeshError& error) {
    throw database::DatabaseError(database::DatabaseErrorKind::InputOutput, error.what());
  } catch (const fs::filesystem_error& error) {
    throw database::output_error(folder, error.code().value());
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
