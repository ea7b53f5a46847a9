/// Triangles that lie together stand together, so that a part of a picture is drawn without those
/// that cannot be seen in it. Inside this corner only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ui/render/scene/box.h"
#include "ui/render/scene/float_vector.h"

namespace hallux::ui {

/// A run of an index buffer's triangles.
struct TriangleRun {
  std::uint32_t first = 0, count = 0;

  friend bool operator==(const TriangleRun&, const TriangleRun&) = default;
};

/// All directions within an angle of an axis, below a right angle.
struct NormalCone {
  /// Unit.
  Vec3 axis{0.0, 0.0, 1.0};
  /// Of the angle; 1: anything may be in it.
  double sine = 1.0;
};
/// shape   unit normals, or zero for triangles without area
NormalCone cone_around(std::span<const Vec3> normals) noexcept;

struct TriangleCluster {
  TriangleRun run;
  Box box;
  NormalCone normals;
};
inline constexpr std::uint32_t cluster_triangles = 128;

/// The numbers of the places in an order in which neighbours mostly follow each other: along
/// Morton's curve.
/// source  Morton 1966, A computer oriented geodetic data base
std::vector<std::uint32_t> order_by_place(std::span<const Vec3> places_mm);

/// What is seen through a part of the picture, as the planes around it in some frame: inside where
/// all are not negative.
struct Frustum {
  std::array<glm::dvec4, 4> planes{};
  /// Which sees no triangle from behind; none: backs are seen, too.
  std::optional<Vec3> eye_mm;
};
/// `low` and `high` are the part's corners in shares of the picture from the lower left.
Frustum frustum_through(const DoubleMatrix4& clip_from_frame, const Vec2& low,
                        const Vec2& high) noexcept;
/// False only where nothing of the box can be seen.
bool may_be_seen(const Frustum& frustum, const Box& box) noexcept;
/// True only where all triangles of the cluster are seen from behind.
bool faces_away(const TriangleCluster& cluster, const Vec3& eye_mm) noexcept;

/// The runs of all clusters that may be seen, those that follow each other joined. Replaces `runs`.
void find_seen(std::span<const TriangleCluster> clusters, const Frustum& frustum,
               std::vector<TriangleRun>& runs);

}  // namespace hallux::ui
