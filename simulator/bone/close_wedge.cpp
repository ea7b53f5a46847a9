/// The bench knows two kerfs and no plan: the wedge is the body with a wall of each, the hinge's
/// line is where the planes meet, outward leads away from the wedge, and the bridge's thickness is
/// whatever is left there. From then on it is the attempt's own closing. Of several bodies between
/// kerfs that cross the sharpest is the wedge.
#include "simulator/bone/close_wedge.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "simulator/cutting/hinge/hinge_gap.h"
#include "simulator/cutting/slice/plane_slice.h"
#include "simulator/mesh/mesh_error.h"

namespace hallux::simulator {

namespace {

/// Planes nearer to parallel than half a degree meet nowhere near the bone.
constexpr double least_sine = 0.0087;

/// Which walls of one kerf a body has: those it stands above (+1), those it stands below (-1).
struct Walls {
  bool above = false, below = false;

  int only_side() const noexcept { return above == below ? 0 : (above ? 1 : -1); }
  bool has(int side) const noexcept { return side > 0 ? above : below; }
};

Walls walls_of(const CutSolid& body, const OpenedKerf& kerf) noexcept {
  Walls walls;
  for (const FaceSource& source : body.sources) {
    if (source.kerf != kerf.number) continue;
    walls.above = walls.above || source.side > 0;
    walls.below = walls.below || source.side < 0;
  }
  return walls;
}

bool lies_on_side(const CutSolid& body, const KerfPlane& plane, int side) noexcept {
  const KerfAxes axes = axes_of(plane);
  return std::all_of(body.mesh.points_mm.begin(), body.mesh.points_mm.end(),
                     [&](const Vec3& point_mm) { return side * height_mm(axes, point_mm) > 0.0; });
}

struct Wedge {
  std::size_t body = 0;
  Vec3 from_first, from_second;  ///< the kerfs' normals, turned towards the wedge
  int first_side = 1, second_side = 1;
};

/// Of several (kerfs that cross) the one with the sharpest edge.
std::optional<Wedge> find_wedge(const OpenedKerf& first, const OpenedKerf& second,
                                const std::vector<CutSolid>& bodies) {
  std::optional<Wedge> found;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Wedge wedge;
    wedge.body = i;
    wedge.first_side = walls_of(bodies[i], first).only_side();
    wedge.second_side = walls_of(bodies[i], second).only_side();
    if (wedge.first_side == 0 || wedge.second_side == 0) continue;
    if (!lies_on_side(bodies[i], first.plane, wedge.first_side)) continue;
    if (!lies_on_side(bodies[i], second.plane, wedge.second_side)) continue;
    wedge.from_first = static_cast<double>(wedge.first_side) * axes_of(first.plane).z;
    wedge.from_second = static_cast<double>(wedge.second_side) * axes_of(second.plane).z;
    const bool is_sharper =
        !found || glm::dot(wedge.from_first, wedge.from_second) <
                      glm::dot(found->from_first, found->from_second) - least_sine;
    if (is_sharper) found = wedge;
  }
  return found;
}

/// A point of both planes, the nearest to the first kerf's origin.
Vec3 meeting_point_mm(const KerfAxes& first, const KerfAxes& second, const Vec3& axis) noexcept {
  const Vec3 along = glm::cross(axis, first.z);  // in the first plane, square to the line
  return first.origin_mm - height_mm(second, first.origin_mm) / glm::dot(along, second.z) * along;
}

HingeLine hinge_line(const OpenedKerf& first, const OpenedKerf& second, const Wedge& wedge) {
  HingeLine line;
  line.axis = unit(glm::cross(wedge.from_first, wedge.from_second));
  line.point_in_bone_mm = meeting_point_mm(axes_of(first.plane), axes_of(second.plane), line.axis);
  // The two normals that look into the wedge add up to the direction in which it opens.
  line.outward = -unit(wedge.from_first + wedge.from_second);
  return line;
}

HingeGap gap_of(SawnBone& bone, const OpenedKerf& kerf, const HingeLine& line) {
  const std::optional<HingeGap> gap =
      measure_hinge_gap(bone.section_of_whole(kerf.plane), kerf.region, line);
  if (gap) return *gap;
  throw MeshError("the kerfs meet too steeply for a hinge; choose planes of a wedge");
}

HingeRequest request_of(SawnBone& bone, const OpenedKerf& first, const OpenedKerf& second,
                        const Wedge& wedge) {
  HingeRequest request;
  request.first = first.plane;
  request.second = second.plane;
  HingeLine& line = request.bridge.line;
  line = hinge_line(first, second, wedge);
  // The line is planned where the planes meet: that is as far from the far cortex as it happens to
  // be.
  const Vec3 far_mm = gap_of(bone, first, line).far_in_bone_mm;
  line.thickness_mm =
      std::max(hinge_row_step_mm, glm::dot(line.outward, far_mm - line.point_in_bone_mm));
  request.first_gap = gap_of(bone, first, line);
  request.second_gap = gap_of(bone, second, line);
  request.bridge.toward_moved = unit(wedge.from_first - wedge.from_second);
  return request;
}

/// The largest body but the wedge with this wall; bodies come largest first.
std::size_t body_with_wall(const std::vector<CutSolid>& bodies, const OpenedKerf& kerf, int side,
                           std::size_t wedge) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (i != wedge && walls_of(bodies[i], kerf).has(side)) return i;
  }
  throw MeshError("no bone is left beyond group " + std::to_string(kerf.number + 1) +
                  "; there is nothing to close the wedge with");
}

CutSolid turned(CutSolid solid, const RigidTransform& bone_from_moved) {
  for (Vec3& point_mm : solid.mesh.points_mm) {
    point_mm = transform_point(bone_from_moved, point_mm);
  }
  return solid;
}

/// A bridge that is too thin comes apart in the plane of the kerf that left less.
void break_bridge(const HingeRequest& request, WedgeClosure& closure,
                  std::vector<CutSolid>& bodies) {
  const bool is_first = request.first_gap.thickness_mm <= request.second_gap.thickness_mm;
  const KerfPlane& plane = is_first ? request.first : request.second;
  CutSolid& body = bodies[closure.fixed];
  DividedBone halves = divide_at_hinge(body, Bvh(body.mesh), plane);
  if (halves.above.mesh.triangles.empty() || halves.below.mesh.triangles.empty()) return;
  if (glm::dot(axes_of(plane).z, request.bridge.toward_moved) < 0.0)
    std::swap(halves.above, halves.below);
  body = std::move(halves.below);
  bodies.push_back(std::move(halves.above));
  closure.moved = bodies.size() - 1;
}

void close_body(const HingeRequest& request, WedgeClosure& closure, std::vector<CutSolid>& bodies) {
  CutSolid& body = bodies[closure.fixed];
  ClosedHinge hinge = close_hinge(body, Bvh(body.mesh), request);
  closure.outcome = hinge.outcome;
  if (hinge.outcome == HingeOutcome::Broken) break_bridge(request, closure, bodies);
  if (hinge.outcome != HingeOutcome::Closed) return;
  closure.angle_rad = hinge.angle_rad;
  body = std::move(hinge.fixed);
  bodies.push_back(turned(std::move(hinge.moved), hinge.bone_from_moved));
  closure.moved = bodies.size() - 1;
}

}  // namespace

WedgeClosure close_wedge(SawnBone& bone, const OpenedKerf& first, const OpenedKerf& second,
                         std::vector<CutSolid>& bodies) {
  const Vec3 meeting = glm::cross(axes_of(first.plane).z, axes_of(second.plane).z);
  if (glm::dot(meeting, meeting) < least_sine * least_sine) {
    throw MeshError("the two planes are parallel; a wedge needs planes that meet");
  }
  const std::optional<Wedge> wedge = find_wedge(first, second, bodies);
  if (!wedge) {
    throw MeshError(
        "the kerfs leave no wedge of its own; lead both blades until "
        "the kerfs meet, and stop before the far side");
  }
  const HingeRequest request = request_of(bone, first, second, *wedge);
  WedgeClosure closure;
  closure.wedge = wedge->body;
  closure.thickness_mm = std::min(request.first_gap.thickness_mm, request.second_gap.thickness_mm);
  closure.fixed = body_with_wall(bodies, first, -wedge->first_side, closure.wedge);
  closure.moved = body_with_wall(bodies, second, -wedge->second_side, closure.wedge);
  if (closure.fixed != closure.moved) {
    closure.outcome = HingeOutcome::Broken;
    return closure;
  }
  close_body(request, closure, bodies);
  return closure;
}

}  // namespace hallux::simulator
