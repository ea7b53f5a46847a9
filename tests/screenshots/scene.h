/// Surfaces in space and how a camera without perspective paints them: flat shaded, the nearer over
/// the farther.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "simulator/cutting/pieces/cut_solid.h"
#include "tests/screenshots/svg_page.h"

namespace hallux::tests {

/// What a face is; decides its colour.
enum class Paint : std::uint8_t {
  /// Of the bone, as it was.
  Skin,
  /// A patch's skin between the kerf's planes.
  Strip,
  /// A patch's skin beyond a plane.
  OuterPart,
  UpperWall,
  LowerWall,
  /// Of an earlier kerf.
  OtherWall,
  Front,
  /// Of a hinge: no blade made it.
  Division,
  Blade
};

/// Squares of these colours and what they stand for, side by side or one below the other.
struct PaintKey {
  Paint paint = Paint::Skin;
  std::string words;
};
void draw_keys(SvgPage& page, Vec2 place, const std::vector<PaintKey>& keys, const Vec2& step);

struct Camera {
  /// Unit, square.
  Vec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, toward{0.0, 0.0, 1.0};
  Vec3 target_mm{0.0, 0.0, 0.0};
  /// Where the target is seen.
  Vec2 middle_px{0.0, 0.0};
  double px_per_mm = 10.0;
  /// Triangles wholly beyond are left out.
  Vec2 low_px{-1.0e9, -1.0e9}, high_px{1.0e9, 1.0e9};

  Vec2 page(const Vec3& point_mm) const noexcept;
  double depth(const Vec3& point_mm) const noexcept { return glm::dot(toward, point_mm); }
};

/// needs   toward (from the target to the eye) and up_hint are not parallel
Camera camera_from(const Vec3& toward, const Vec3& up_hint);

struct SceneFace {
  std::array<Vec3, 3> points_mm;
  Paint paint = Paint::Skin;
  /// Side k, from point k to k + 1: where another paint or nothing begins.
  std::array<bool, 3> is_rim{};
};

class Scene {
 public:
  /// Adds triangles of one mesh; sides between different paints, and sides that only one triangle
  /// has, become rims.
  /// needs   one paint per triangle
  void add(const simulator::IndexedMesh& mesh, const std::vector<Paint>& paints,
           const Vec3& shift_mm = Vec3(0.0));
  /// Adds a triangle without rims.
  void add(const std::array<Vec3, 3>& points_mm, Paint paint) {
    faces_.push_back({points_mm, paint, {}});
  }
  const std::vector<SceneFace>& faces() const noexcept { return faces_; }
  std::size_t count(Paint paint) const noexcept;

 private:
  std::vector<SceneFace> faces_;
};

enum class Shows {
  /// Closed surfaces: backs are never seen.
  Solids,
  /// Backs are painted too, in a duller colour.
  OpenSurfaces
};
enum class Lines {
  /// Where the paint changes.
  Rims,
  /// Besides, every side, faintly.
  Triangles
};

/// ensures the same bytes for the same scene
void draw(const Scene& scene, const Camera& camera, SvgPage& page, Lines lines = Lines::Rims,
          Shows shows = Shows::Solids);

}  // namespace hallux::tests
