#include "simulator/mesh/write_ply.h"

#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <system_error>

#include "simulator/mesh/mesh_text.h"

namespace hallux::simulator {

namespace {

namespace fs = std::filesystem;

template <typename Unsigned>
void append_little_endian(std::string& bytes, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    bytes.push_back(static_cast<char>((value >> (8U * i)) & 0xFFU));
  }
}

/// Writes the whole of `bytes`; 0, or the system's error number.
int write_whole(const fs::path& file, const std::string& bytes) {
  std::FILE* const stream = std::fopen(file.c_str(), "wb");
  if (stream == nullptr) return errno;
  const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size() &&
                          std::fflush(stream) == 0;
  const int error = is_written ? 0 : errno;
  // Some file systems find out only here that there is no room.
  if (std::fclose(stream) != 0 && error == 0) return errno;
  return error;
}

}  // namespace

std::string ply_bytes(const IndexedMesh& mesh) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment millimetres\nelement vertex " +
                      std::to_string(mesh.points_mm.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar uint vertex_indices\nend_header\n";
  bytes.reserve(bytes.size() + 24 * mesh.points_mm.size() + 13 * mesh.triangles.size());
  for (const Vec3& point : mesh.points_mm) {
    for (const double part : {point.x, point.y, point.z}) {
      append_little_endian(bytes, std::bit_cast<std::uint64_t>(part));
    }
  }
  for (const Triangle& triangle : mesh.triangles) {
    bytes.push_back(3);
    for (const std::uint32_t index : triangle) append_little_endian(bytes, index);
  }
  return bytes;
}

void write_ply(const IndexedMesh& mesh, const fs::path& file) {
  const std::string name = file.filename().string();
  fs::path part = file;
  part += ".part";
  std::error_code ignored;
  if (const int error = write_whole(part, ply_bytes(mesh)); error != 0) {
    fs::remove(part, ignored);
    refuse_mesh(name, "cannot be written in " + file.parent_path().string() + " (" +
                          std::generic_category().message(error) +
                          "); check the room and the permission there");
  }
  std::error_code error;
  fs::rename(part, file, error);
  if (error) {
    fs::remove(part, ignored);
    refuse_mesh(name, "cannot be put in its place (" + error.message() + "); choose another name");
  }
}

}  // namespace hallux::simulator
