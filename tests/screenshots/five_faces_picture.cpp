// A small slot in solid bone, its patch drawn apart by kind of face: each edge is there twice, once
// with each of its faces.
#include <algorithm>
#include <cmath>
#include <map>

#include "simulator/base/check.h"
#include "simulator/cutting/slice/plane_slice.h"
#include "tests/screenshots/kernel_pictures.h"
#include "tests/screenshots/sawn_bones.h"
#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/simulator/cutting/worlds/shown_solid.h"

namespace hallux::tests {

using namespace simulator;

namespace {

constexpr double kerf_mm = 1.2;
constexpr double apart_mm = 1.5;
/// Where the grid rounds a corner of the blade the front has faces of two cells' width: by
/// themselves they are but lines.
constexpr double least_drawn_mm2 = 0.02;
constexpr double slot_width_mm = 3.2, slot_depth_mm = 2.6;

struct PatchFace {
  Triangle corners{};
  Paint paint = Paint::Strip;
  Vec3 shift_mm{0.0, 0.0, 0.0};  ///< to where it is drawn
};

struct Slot {
  CutSolid solid;
  SawnFrame frame;
  IndexedMesh shown;
  std::vector<PatchFace> faces;  ///< those near the slot
};

/// Into the bone, along the feed or the tooth line: the little faces where the grid rounds a corner
/// go with one of its sides.
Vec3 side_of_front(const KerfAxes& axes, const Vec3& outward) {
  const double along = glm::dot(outward, axes.x), across = glm::dot(outward, axes.y);
  if (std::abs(along) >= std::abs(across)) return along > 0.0 ? -axes.x : axes.x;
  return across > 0.0 ? -axes.y : axes.y;
}

/// Skin outwards, walls away from each other, outer parts twice as far, each side of the front into
/// the bone.
Vec3 shift_of(const Slot& slot, const PatchFace& face) {
  const KerfAxes& axes = slot.frame.contact.axes;
  const Vec3& a = slot.shown.points_mm[face.corners[0]];
  const Vec3 across = glm::cross(slot.shown.points_mm[face.corners[1]] - a,
                                 slot.shown.points_mm[face.corners[2]] - a);
  switch (face.paint) {
    case Paint::UpperWall:
      return apart_mm * axes.z;
    case Paint::LowerWall:
      return -apart_mm * axes.z;
    case Paint::OuterPart:
      return 2.0 * apart_mm * level_of(slot.frame.contact.plane, slot.shown, face.corners) * axes.z;
    case Paint::Strip:
      return -0.9 * apart_mm * axes.x;
    default:
      return 0.9 * apart_mm * side_of_front(axes, across);
  }
}

bool is_near(const Slot& slot, const Triangle& corners) {
  Vec2 middle_mm(0.0);
  for (const std::uint32_t corner : corners) {
    middle_mm += place_mm(slot.frame.contact.axes, slot.shown.points_mm[corner]) / 3.0;
  }
  return std::abs(middle_mm.y) < 2.9 && middle_mm.x < 5.0;
}

Slot make_slot() {
  const PlannedBone bone = akin_phalanx(1.0);
  Slot slot;
  slot.solid = bone.solid;
  const KerfPlane plane =
      plane_through(Vec3(5.2, 0.5, -9.6), Vec3(-1.0, 0.0, 0.0), kerf_mm, Vec3(0.0, 0.0, 1.0));
  KerfField field(wide_grid());
  saw(field, {slot_width_mm, 20.0, kerf_mm},
      {{Vec2(-4.0, 0.0), Vec2(1.0, 0.0)}, {Vec2(slot_depth_mm, 0.0), Vec2(1.0, 0.0)}});
  slot.frame = frame_of(slot.solid, plane, field);
  slot.shown = shown_mesh(slot.solid, slot.frame.patch);
  const std::vector<Paint> paints = paints_of(slot.solid, slot.frame);
  for (std::size_t i = 0; i < paints.size(); ++i) {
    PatchFace face{slot.frame.patch.triangles[i], paints[i], Vec3(0.0)};
    if (!is_near(slot, face.corners)) continue;
    face.shift_mm = shift_of(slot, face);
    slot.faces.push_back(face);
  }
  return slot;
}

/// One of the five kinds of edge, by the kinds of its two faces.
int kind_of(Paint a, Paint b) {
  const auto is_wall = [](Paint paint) {
    return paint == Paint::UpperWall || paint == Paint::LowerWall;
  };
  const auto are = [&](Paint first, Paint second) {
    return (a == first && b == second) || (a == second && b == first);
  };
  if (are(Paint::Strip, Paint::OuterPart)) return 1;
  if ((is_wall(a) && b == Paint::OuterPart) || (is_wall(b) && a == Paint::OuterPart)) return 2;
  if (are(Paint::Strip, Paint::Front)) return 3;
  if ((is_wall(a) && b == Paint::Front) || (is_wall(b) && a == Paint::Front)) return 4;
  return are(Paint::Front, Paint::Front) ? 5 : 0;
}

struct SharedEdge {
  std::uint32_t from = 0, to = 0;
  Vec3 shift_mm{0.0, 0.0, 0.0}, other_shift_mm{0.0, 0.0, 0.0};
};

std::map<int, std::vector<SharedEdge>> shared_edges(const Slot& slot) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, const PatchFace*> sides;
  for (const PatchFace& face : slot.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      sides[{face.corners[k], face.corners[(k + 1) % 3]}] = &face;
    }
  }
  std::map<int, std::vector<SharedEdge>> edges;
  for (const auto& [side, face] : sides) {
    const auto other = sides.find({side.second, side.first});
    if (side.first > side.second || other == sides.end()) continue;
    const Vec3 apart = face->shift_mm - other->second->shift_mm;
    const int kind = kind_of(face->paint, other->second->paint);
    if (kind == 0 || glm::dot(apart, apart) < 1.0e-6) continue;
    edges[kind].push_back({side.first, side.second, face->shift_mm, other->second->shift_mm});
  }
  return edges;
}

/// The one whose middle lies nearest to a place in the kerf frame.
const SharedEdge& nearest(const Slot& slot, const std::vector<SharedEdge>& edges,
                          const Vec3& place_in_kerf_mm) {
  const Vec3 place = transform_point(slot.frame.contact.plane.bone_from_kerf, place_in_kerf_mm);
  const auto distance = [&](const SharedEdge& edge) {
    const Vec3 middle = 0.5 * (slot.shown.points_mm[edge.from] + slot.shown.points_mm[edge.to]);
    return glm::dot(middle - place, middle - place);
  };
  return *std::min_element(
      edges.begin(), edges.end(),
      [&](const SharedEdge& a, const SharedEdge& b) { return distance(a) < distance(b); });
}

/// The edges that hang together with `first` and are drawn apart as it is.
std::vector<SharedEdge> line_through(const SharedEdge& first,
                                     const std::vector<SharedEdge>& edges) {
  std::vector<SharedEdge> line{first};
  std::vector<std::uint32_t> ends{first.from, first.to};
  std::vector<SharedEdge> rest = edges;
  const auto joins = [&](const SharedEdge& edge) {
    const auto has = [&](std::uint32_t point) {
      return std::find(ends.begin(), ends.end(), point) != ends.end();
    };
    return edge.shift_mm == first.shift_mm && edge.other_shift_mm == first.other_shift_mm &&
           has(edge.from) != has(edge.to);
  };
  for (auto next = std::find_if(rest.begin(), rest.end(), joins); next != rest.end();
       next = std::find_if(rest.begin(), rest.end(), joins)) {
    line.push_back(*next);
    ends.push_back(next->from);
    ends.push_back(next->to);
  }
  return line;
}

/// Both copies of a line of edges, joined where the page shows its ends farthest left and right.
void draw_shared(SvgPage& page, const Camera& camera, const Slot& slot,
                 const std::vector<SharedEdge>& line, int kind) {
  const Vec3 shift_mm = line.front().shift_mm, other_mm = line.front().other_shift_mm;
  const auto at = [&](std::uint32_t point, const Vec3& shift) {
    return camera.page(slot.shown.points_mm[point] + shift);
  };
  std::vector<std::uint32_t> points;
  for (const SharedEdge& edge : line) {
    page.line(at(edge.from, shift_mm), at(edge.to, shift_mm), "shared");
    page.line(at(edge.from, other_mm), at(edge.to, other_mm), "shared");
    points.insert(points.end(), {edge.from, edge.to});
  }
  const auto [first, last] =
      std::minmax_element(points.begin(), points.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Vec2 difference = at(a, shift_mm) - at(b, shift_mm);
        return difference.x + 0.1 * difference.y < 0.0;
      });
  for (const std::uint32_t end : {*first, *last}) {
    page.line(at(end, shift_mm), at(end, other_mm), "link");
  }
  page.number(0.25 * (at(*first, shift_mm) + at(*last, shift_mm) + at(*first, other_mm) +
                      at(*last, other_mm)),
              std::to_string(kind));
}

double area_mm2(const IndexedMesh& mesh, const Triangle& corners) {
  const Vec3& a = mesh.points_mm[corners[0]];
  const Vec3 across = glm::cross(mesh.points_mm[corners[1]] - a, mesh.points_mm[corners[2]] - a);
  return 0.5 * std::sqrt(glm::dot(across, across));
}

Scene exploded(const Slot& slot) {
  // Per kind, so that rims are where a kind ends.
  std::map<std::array<double, 3>, std::pair<IndexedMesh, std::vector<Paint>>> groups;
  for (const PatchFace& face : slot.faces) {
    const bool is_front = face.paint == Paint::Front;
    if (is_front && area_mm2(slot.shown, face.corners) < least_drawn_mm2) continue;
    const std::array<double, 3> shift{std::floor(1.0e6 * face.shift_mm.x + 0.5),
                                      std::floor(1.0e6 * face.shift_mm.y + 0.5),
                                      std::floor(1.0e6 * face.shift_mm.z + 0.5)};
    auto& [mesh, paints] = groups[shift];
    mesh.triangles.push_back(face.corners);
    paints.push_back(face.paint);
  }
  Scene scene;
  for (auto& [shift, group] : groups) {
    group.first.points_mm = slot.shown.points_mm;
    scene.add(group.first, group.second, 1.0e-6 * Vec3(shift[0], shift[1], shift[2]));
  }
  return scene;
}

void draw_whole(SvgPage& page, const Slot& slot) {
  Camera camera = camera_from(Vec3(-0.55, 0.4, -0.75), Vec3(-1.0, 0.0, 0.0));
  camera.target_mm = Vec3(5.2, 0.5, -8.5);
  camera.middle_px = Vec2(150.0, 150.0);
  camera.px_per_mm = 17.0;
  camera.low_px = Vec2(15.0, 15.0);
  camera.high_px = Vec2(285.0, 285.0);
  page.begin_window(camera.low_px, camera.high_px - camera.low_px);
  draw(shown_scene(slot.solid, slot.frame), camera, page, Lines::Triangles);
  page.end_window();
  page.polygon(std::vector<Vec2>{camera.low_px, Vec2(camera.high_px.x, camera.low_px.y),
                                 camera.high_px, Vec2(camera.low_px.x, camera.high_px.y)},
               "frame");
}

}  // namespace

std::string draw_five_faces() {
  const Slot slot = make_slot();
  SvgPage page(Vec2(880.0, 560.0), "The five kinds of face of a patch, and the edges they share");
  page.add_style("shared", "fill:none;stroke:#111;stroke-width:2.6");
  page.add_style("link", "fill:none;stroke:#111;stroke-width:.9;stroke-dasharray:3 3");
  draw_whole(page, slot);
  Camera camera = camera_from(Vec3(-0.62, 0.4, -0.68), Vec3(-1.0, 0.0, 0.0));
  camera.target_mm = Vec3(5.2, 0.5, -8.5);
  camera.middle_px = Vec2(580.0, 280.0);
  camera.px_per_mm = 54.0;
  draw(exploded(slot), camera, page, Lines::Triangles, Shows::OpenSurfaces);
  draw_keys(page, Vec2(40.0, 325.0),
            {{Paint::OuterPart, "outer part"},
             {Paint::Strip, "strip"},
             {Paint::UpperWall, "upper wall"},
             {Paint::LowerWall, "lower wall"},
             {Paint::Front, "front"}},
            Vec2(0.0, 22.0));
  double y = 456.0;
  for (const char* words : {"strip and outer part", "outer part and wall", "strip and front",
                            "front and wall", "front and front"}) {
    page.number(Vec2(46.0, y - 4.0), std::to_string(static_cast<int>((y - 434.0) / 22.0)));
    page.text(Vec2(62.0, y), words);
    y += 22.0;
  }
  const std::map<int, std::vector<SharedEdge>> edges = shared_edges(slot);
  CHECK(edges.size() == 5);
  // Where one of each kind is well seen: feed, tooth line, normal.
  constexpr double side_mm = 0.5 * slot_width_mm, half_mm = 0.5 * kerf_mm;
  const std::array<Vec3, 5> seen_in_kerf_mm{
      Vec3(0.0, 2.4, half_mm), Vec3(0.0, 0.0, half_mm), Vec3(0.5, -side_mm, 0.0),
      Vec3(slot_depth_mm, 0.0, -half_mm), Vec3(slot_depth_mm, -side_mm, 0.0)};
  for (const auto& [kind, of_kind] : edges) {
    const Vec3& place = seen_in_kerf_mm[static_cast<std::size_t>(kind - 1)];
    draw_shared(page, camera, slot, line_through(nearest(slot, of_kind, place), of_kind), kind);
  }
  return page.take();
}

}  // namespace hallux::tests
