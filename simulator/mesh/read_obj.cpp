#include <cstdint>
#include <limits>
#include <string>

#include "simulator/mesh/mesh_text.h"
#include "simulator/mesh/parse_mesh.h"

/// Wavefront OBJ: `v x y z` and `f a b c ...` with a corner as 7, 7/1, 7//2 or 7/1/2; counted from
/// 1, or from the end when negative. A polygon becomes a fan. All other lines speak of looks, not
/// of shape.
namespace hallux::simulator {

namespace {

constexpr auto index_limit = static_cast<std::int64_t>(std::numeric_limits<std::uint32_t>::max());

Vec3 parse_point(TextCursor& cursor) {
  const double x = cursor.number(cursor.word_in_line());
  const double y = cursor.number(cursor.word_in_line());
  const double z = cursor.number(cursor.word_in_line());
  return {x, y, z};
}

std::uint32_t parse_corner(const TextCursor& cursor, std::string_view word,
                           std::size_t point_count) {
  const std::int64_t number = cursor.whole_number(word.substr(0, word.find('/')));
  const auto count = static_cast<std::int64_t>(point_count);
  if (number == 0 || number > index_limit || number < -count) {
    cursor.refuse("a face names point " + std::to_string(number) + ", but there are " +
                  std::to_string(point_count) + " so far, counted from 1; export the file again");
  }
  return static_cast<std::uint32_t>(number > 0 ? number - 1 : count + number);
}

void parse_face(const MeshSource& source, TextCursor& cursor, IndexedMesh& mesh) {
  Triangle fan{};
  std::size_t corners = 0;
  for (std::string_view word = cursor.word_in_line(); !word.empty(); word = cursor.word_in_line()) {
    if (word.front() == '#') break;
    const std::uint32_t index = parse_corner(cursor, word, mesh.points_mm.size());
    if (corners == 0) fan[0] = index;
    fan[1] = fan[2];
    fan[2] = index;
    if (++corners < 3) continue;
    mesh.triangles.push_back(fan);
    check_triangle_count(source, mesh.triangles.size());
  }
  if (corners < 3) cursor.refuse("a face has fewer than 3 corners; export the file again");
}

/// Faces may stand before their points, so indices are checked when all points are known.
void check_indices(const MeshSource& source, const IndexedMesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t index : mesh.triangles[i]) {
      if (index < mesh.points_mm.size()) continue;
      refuse_mesh(source.name, "triangle " + std::to_string(i + 1) + " names point " +
                                   std::to_string(std::uint64_t{index} + 1) + ", but there are " +
                                   std::to_string(mesh.points_mm.size()) +
                                   "; the file is cut short or damaged, export it again");
    }
  }
}

}  // namespace

IndexedMesh parse_obj(const MeshSource& source) {
  TextCursor cursor{source.text(), source.name};
  IndexedMesh mesh;
  while (!cursor.at_end()) {
    const std::string_view keyword = cursor.word_in_line();
    if (keyword == "v") {
      mesh.points_mm.push_back(parse_point(cursor));
      check_point_count(source, mesh.points_mm.size());
    } else if (keyword == "f") {
      parse_face(source, cursor, mesh);
    }
    cursor.skip_line();
  }
  check_indices(source, mesh);
  return mesh;
}

}  // namespace hallux::simulator
