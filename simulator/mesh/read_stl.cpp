#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>

#include "simulator/mesh/mesh_text.h"
#include "simulator/mesh/parse_mesh.h"

/// STL. Binary: 80 bytes of anything, a count, 50 bytes a triangle (normal, three corners, an
/// attribute; all little endian). Text: `solid`, facets, `endsolid`. A binary header may begin with
/// "solid" too, so the size decides first.
namespace hallux::simulator {

namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t record_bytes = 50;

std::uint32_t uint32_at(std::span<const std::byte> bytes, std::size_t at) noexcept {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;)
    value = (value << 8U) | static_cast<std::uint32_t>(bytes[at + i]);
  return value;
}

double float_at(std::span<const std::byte> bytes, std::size_t at) noexcept {
  return static_cast<double>(std::bit_cast<float>(uint32_at(bytes, at)));
}

bool begins_with_solid(std::string_view text) noexcept {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  return start != std::string_view::npos && is_keyword(text.substr(start, 5), "solid");
}

/// Text has no zero bytes; a binary header that begins with "solid" nearly always is filled up with
/// them.
bool looks_like_text(std::string_view text) noexcept {
  return text.substr(0, 1024).find('\0') == std::string_view::npos;
}

IndexedMesh parse_binary(const MeshSource& source, std::size_t count) {
  check_triangle_count(source, count);
  std::vector<Vec3> corners_mm;
  corners_mm.reserve(3 * count);
  for (std::size_t triangle = 0; triangle < count; ++triangle) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t at = header_bytes + triangle * record_bytes + 12 + corner * 12;
      const Vec3 point{float_at(source.bytes, at), float_at(source.bytes, at + 4),
                       float_at(source.bytes, at + 8)};
      if (!is_finite(point)) {
        refuse_not_finite(source.name, "triangle " + std::to_string(triangle + 1));
      }
      corners_mm.push_back(point);
    }
  }
  return weld_corners(corners_mm);
}

void parse_facet(TextCursor& cursor, std::vector<Vec3>& corners_mm) {
  // The normal is computed from the corners; what stands here may well be nan.
  cursor.expect("normal");
  for (int i = 0; i < 3; ++i) cursor.word();
  cursor.expect("outer");
  cursor.expect("loop");
  for (int i = 0; i < 3; ++i) {
    cursor.expect("vertex");
    const double x = cursor.number();
    const double y = cursor.number();
    const double z = cursor.number();
    corners_mm.emplace_back(x, y, z);
  }
  cursor.expect("endloop");
  cursor.expect("endfacet");
}

IndexedMesh parse_text(const MeshSource& source) {
  TextCursor cursor{source.text(), source.name};
  std::vector<Vec3> corners_mm;
  cursor.expect("solid");
  cursor.skip_line();
  bool is_in_solid = true;
  for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word()) {
    if (is_in_solid && is_keyword(word, "facet")) {
      parse_facet(cursor, corners_mm);
      check_triangle_count(source, corners_mm.size() / 3);
    } else if (is_keyword(word, is_in_solid ? "endsolid" : "solid")) {
      is_in_solid = !is_in_solid;
      cursor.skip_line();
    } else {
      cursor.refuse(quoted(word) + " stands where a facet should; export the file again");
    }
  }
  if (is_in_solid)
    cursor.refuse("the file ends without 'endsolid'; it is cut short, export it again");
  return weld_corners(corners_mm);
}

struct Corner {
  Vec3 point_mm{0.0, 0.0, 0.0};
  std::uint32_t index = 0;
};

bool is_before(const Corner& a, const Corner& b) noexcept {
  if (a.point_mm.x != b.point_mm.x) return a.point_mm.x < b.point_mm.x;
  if (a.point_mm.y != b.point_mm.y) return a.point_mm.y < b.point_mm.y;
  if (a.point_mm.z != b.point_mm.z) return a.point_mm.z < b.point_mm.z;
  return a.index < b.index;
}

/// For each corner the first corner with the same coordinates. By sorting, because a hash table can
/// be made slow by a file that was written to do so.
std::vector<std::uint32_t> first_equal_corner(const std::vector<Vec3>& corners_mm) {
  std::vector<Corner> sorted(corners_mm.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    sorted[i] = {corners_mm[i], static_cast<std::uint32_t>(i)};
  }
  std::sort(sorted.begin(), sorted.end(), is_before);
  std::vector<std::uint32_t> first(sorted.size());
  std::size_t group = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (sorted[i].point_mm != sorted[group].point_mm) group = i;
    first[sorted[i].index] = sorted[group].index;
  }
  return first;
}

}  // namespace

IndexedMesh weld_corners(const std::vector<Vec3>& corners_mm) {
  const std::vector<std::uint32_t> first = first_equal_corner(corners_mm);
  std::vector<std::uint32_t> point_of(corners_mm.size());
  IndexedMesh mesh;
  for (std::size_t i = 0; i < corners_mm.size(); ++i) {
    if (first[i] == i) {
      point_of[i] = static_cast<std::uint32_t>(mesh.points_mm.size());
      mesh.points_mm.push_back(corners_mm[i]);
    } else {
      point_of[i] = point_of[first[i]];
    }
  }
  mesh.triangles.reserve(corners_mm.size() / 3);
  for (std::size_t i = 0; i + 2 < corners_mm.size(); i += 3) {
    const Triangle triangle{point_of[i], point_of[i + 1], point_of[i + 2]};
    const bool is_flat =
        triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
    if (!is_flat) mesh.triangles.push_back(triangle);
  }
  return mesh;
}

IndexedMesh parse_stl(const MeshSource& source) {
  const std::size_t size = source.bytes.size();
  const std::uint64_t count = size >= header_bytes ? uint32_at(source.bytes, 80) : 0;
  const std::uint64_t wanted = header_bytes + record_bytes * count;
  if (size >= header_bytes && wanted == size) {
    if (count == 0) refuse_mesh(source.name, "has no triangles; export the bone's surface again");
    return parse_binary(source, static_cast<std::size_t>(count));
  }
  const bool is_text = looks_like_text(source.text());
  if (is_text && begins_with_solid(source.text())) return parse_text(source);
  if (is_text) {
    refuse_mesh(source.name,
                "is text but not STL (line 1 does not begin with 'solid'); export the mesh as STL");
  }
  if (size < header_bytes) {
    refuse_mesh(source.name, "has " + std::to_string(size) +
                                 " bytes, and the header of an STL alone has 84; export it again");
  }
  refuse_mesh(source.name, "says " + std::to_string(count) + " triangles (byte 80), which take " +
                               std::to_string(wanted) + " bytes, but has " + std::to_string(size) +
                               "; it is cut short or damaged, export it again");
}

}  // namespace hallux::simulator
