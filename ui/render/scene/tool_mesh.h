/// Triangles of tools, with normals and materials, and the forms from which they are put together.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "simulator/base/transform.h"
#include "simulator/mesh/indexed_mesh.h"
#include "ui/render/scene/float_vector.h"

namespace hallux::ui {

enum class ToolMaterial : std::uint8_t {
  /// Brushed steel.
  Blade,
  /// Polished.
  Steel,
  /// Dark, matt.
  Grip,
  /// A grey ring in the grip.
  Band
};

struct ToolVertex {
  Float3 point_in_tool_mm{0.0F};
  Float3 normal{0.0F, 0.0F, 1.0F};
  /// A ToolMaterial.
  float material = 0.0F;
};

struct ToolMesh {
  std::vector<ToolVertex> vertices;
  std::vector<simulator::Triangle> triangles;
};

/// A point of a turned part's outline: along the axis, away from it, and what the part up to the
/// next point is made of.
struct ProfilePoint {
  double along_mm = 0.0, radius_mm = 0.0;
  ToolMaterial material = ToolMaterial::Grip;
};

/// A cut through a part. Seen from where the rings go to, each runs counter-clockwise; all rings of
/// a part have as many points.
struct ToolRing {
  std::vector<Vec3> points_mm;
  /// Of the part up to the next ring.
  ToolMaterial material = ToolMaterial::Steel;
};

class ToolBuilder {
 public:
  void add_triangle(const std::array<Vec3, 3>& corners_mm, ToolMaterial material);
  void add_quad(const std::array<Vec3, 4>& corners_mm, ToolMaterial material);
  /// A part turned about an axis; `tool_from_turned` puts its z axis there. Outlines run so that
  /// outside is on their left when z points right.
  void add_turned(std::span<const ProfilePoint> profile, const RigidTransform& tool_from_turned);
  /// The skin through the rings, closed at both ends by the rings' middles. Where faces meet at
  /// more than the angle there is an edge, elsewhere it is smooth. `surfaces`, one for each point
  /// of a ring, tell the surfaces between which there is an edge at any angle.
  void add_rings(std::span<const ToolRing> rings, double edge_rad = 0.6,
                 std::span<const int> surfaces = {});
  /// A surface that is there as triangles, the same way. Points that coincide are one.
  void add_surface(const simulator::IndexedMesh& surface, ToolMaterial material,
                   double edge_rad = 0.6);

  ToolMesh take() { return std::move(mesh_); }

 private:
  void add_vertex(const Vec3& point_mm, const Vec3& normal, ToolMaterial material);
  /// Of a face before it has normals.
  struct FaceKind {
    ToolMaterial material = ToolMaterial::Steel;
    int surface = 0;
  };
  void add_faces(const simulator::IndexedMesh& faces, std::span<const FaceKind> kinds,
                 double edge_rad);

  ToolMesh mesh_;
};

/// A ring around the x axis at that place, with a radius for each angle, counted from y to z.
ToolRing ring_around_x(double x_mm, std::span<const Vec2> points_yz_mm,
                       ToolMaterial material = ToolMaterial::Steel);
/// A circle of so many points.
ToolRing circle_around_x(double x_mm, double radius_mm, std::uint32_t count,
                         ToolMaterial material = ToolMaterial::Steel);

/// The same seen in a mirror that stands in the plane y = 0.
ToolMesh mirrored_in_y(const ToolMesh& mesh);

}  // namespace hallux::ui
