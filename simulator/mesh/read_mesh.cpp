#include "simulator/mesh/read_mesh.h"

#include <fstream>
#include <optional>
#include <string>
#include <system_error>

#include "simulator/mesh/mesh_text.h"
#include "simulator/mesh/parse_mesh.h"

namespace hallux::simulator {

namespace {

namespace fs = std::filesystem;

std::optional<MeshFormat> format_of(const fs::path& file) {
  const std::string ending = file.extension().string();
  if (is_keyword(ending, ".stl")) return MeshFormat::Stl;
  if (is_keyword(ending, ".obj")) return MeshFormat::Obj;
  if (is_keyword(ending, ".ply")) return MeshFormat::Ply;
  return std::nullopt;
}

/// The size of the file, once it is sure that it is one and that reading it will end.
std::size_t checked_size(const fs::path& file, const std::string& name, const MeshLimits& limits) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) {
    refuse_mesh(name, "there is no such file; check the path");
  }
  if (error) refuse_mesh(name, "cannot be looked at (" + error.message() + ")");
  if (status.type() == fs::file_type::directory) {
    refuse_mesh(name, "is a folder; name a .stl, .obj or .ply file in it");
  }
  if (status.type() != fs::file_type::regular) {
    refuse_mesh(name, "is not an ordinary file; copy the mesh into one");
  }
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) refuse_mesh(name, "cannot be measured (" + error.message() + ")");
  if (size == 0) refuse_mesh(name, "is empty; export the mesh again");
  if (size > limits.bytes) {
    refuse_mesh(name, "has " + std::to_string(size) + " bytes; at most " +
                          std::to_string(limits.bytes) +
                          " are read; reduce the mesh and export it again");
  }
  return static_cast<std::size_t>(size);
}

std::vector<std::byte> bytes_of(const fs::path& file, const std::string& name, std::size_t size) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_mesh(name, "cannot be opened; check the permission to read it");
  std::vector<std::byte> bytes(size);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (static_cast<std::size_t>(stream.gcount()) != size) {
    refuse_mesh(name, "could not be read to its end; check the disk and try again");
  }
  return bytes;
}

/// Points that no triangle uses say nothing about the solid.
void drop_unused_points(IndexedMesh& mesh) {
  constexpr std::uint32_t unused = 0xFFFFFFFFU;
  std::vector<std::uint32_t> place(mesh.points_mm.size(), unused);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) place[index] = 0;
  }
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == unused) continue;
    mesh.points_mm[count] = mesh.points_mm[i];
    place[i] = count++;
  }
  mesh.points_mm.resize(count);
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& index : triangle) index = place[index];
  }
}

}  // namespace

IndexedMesh read_mesh(const fs::path& file, const MeshLimits& limits) {
  const std::string name = file.filename().empty() ? file.string() : file.filename().string();
  const std::size_t size = checked_size(file, name, limits);
  const std::optional<MeshFormat> format = format_of(file);
  if (!format) refuse_mesh(name, "is of an unknown kind; meshes are read from .stl, .obj and .ply");
  IndexedMesh mesh = parse_mesh(bytes_of(file, name, size), *format, name, limits);
  check_closed_solid(mesh, name);
  check_shells(mesh, name);
  return mesh;
}

IndexedMesh parse_mesh(std::span<const std::byte> bytes, MeshFormat format, std::string_view name,
                       const MeshLimits& limits) {
  if (bytes.empty()) refuse_mesh(name, "is empty; export the mesh again");
  const MeshSource source{bytes, name, limits};
  IndexedMesh mesh;
  switch (format) {
    case MeshFormat::Stl:
      mesh = parse_stl(source);
      break;
    case MeshFormat::Obj:
      mesh = parse_obj(source);
      break;
    case MeshFormat::Ply:
      mesh = parse_ply(source);
      break;
  }
  if (mesh.triangles.empty()) {
    refuse_mesh(name, "has no triangles; export the bone's surface as triangles");
  }
  drop_unused_points(mesh);
  return mesh;
}

void check_triangle_count(const MeshSource& source, std::size_t count) {
  if (count <= source.limits.triangles) return;
  refuse_mesh(source.name, "has " + std::to_string(count) + " triangles or more; at most " +
                               std::to_string(source.limits.triangles) +
                               " can be used; reduce the mesh and export it again");
}

void check_point_count(const MeshSource& source, std::size_t count) {
  if (count <= source.limits.points) return;
  refuse_mesh(source.name, "has " + std::to_string(count) + " points or more; at most " +
                               std::to_string(source.limits.points) +
                               " can be used; reduce the mesh and export it again");
}

}  // namespace hallux::simulator
