#include "tests/screenshots/scene.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/check.h"
#include "tests/screenshots/painter_order.h"
#include "ui/report/html_text.h"

namespace hallux::tests {

using namespace simulator;

namespace {

constexpr int shades = 14;
using Colour = std::array<int, 3>;

Colour rgb_of(Paint paint) {
  switch (paint) {
    case Paint::Skin:
      return {240, 221, 184};
    case Paint::Strip:
      return {222, 165, 84};
    case Paint::OuterPart:
      return {233, 196, 133};
    case Paint::UpperWall:
      return {0, 103, 168};
    case Paint::LowerWall:
      return {58, 140, 194};
    case Paint::OtherWall:
      return {140, 190, 222};
    case Paint::Front:
      return {213, 94, 0};
    case Paint::Division:
      return {122, 98, 78};
    case Paint::Blade:
      return {190, 196, 202};
  }
  CHECK(false);
}

std::string css_colour(const Colour& colour, double light) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const int channel : colour) {
    const auto value = static_cast<std::size_t>(std::clamp(channel * light, 0.0, 255.0) + 0.5);
    text += digits[value / 16];
    text += digits[value % 16];
  }
  return text;
}

Vec3 unit(const Vec3& direction) { return direction / std::sqrt(glm::dot(direction, direction)); }

/// From a lamp over the viewer's left shoulder.
int shade_of(const Vec3& normal, const Camera& camera) {
  const Vec3 lamp = unit(-0.35 * camera.right + 0.6 * camera.up + camera.toward);
  const double light = std::max(0.0, glm::dot(normal, lamp));
  return static_cast<int>(std::floor(light * (shades - 1) + 0.5));
}

/// A style's number holds all that its colour needs.
struct Style {
  Paint paint = Paint::Skin;
  bool is_back = false;
  int shade = 0;
};

std::uint32_t number_of(const Style& style) {
  return static_cast<std::uint32_t>(
      (static_cast<int>(style.paint) * 2 + (style.is_back ? 1 : 0)) * shades + style.shade);
}

Style style_of(std::uint32_t number) {
  const int side = static_cast<int>(number) / shades;
  return {static_cast<Paint>(side / 2), side % 2 != 0, static_cast<int>(number) % shades};
}

Colour dulled(const Colour& colour) {
  constexpr Colour grey{150, 141, 130};
  Colour mixed{};
  for (std::size_t i = 0; i < 3; ++i) mixed[i] = (2 * colour[i] + 3 * grey[i]) / 5;
  return mixed;
}

std::string style_name(std::uint32_t style) { return "f" + std::to_string(style); }

void add_style(SvgPage& page, std::uint32_t style, Lines lines) {
  const Style said = style_of(style);
  const Colour colour = said.is_back ? dulled(rgb_of(said.paint)) : rgb_of(said.paint);
  const double light = 0.68 + 0.36 * static_cast<double>(said.shade) / (shades - 1);
  const std::string fill = css_colour(colour, light);
  // Its own colour around each triangle hides the seams between them.
  const bool has_lines = lines == Lines::Triangles;
  const std::string stroke = has_lines ? css_colour(colour, 0.8 * light) : fill;
  page.add_style(style_name(style), "fill:" + fill + ";stroke:" + stroke +
                                        ";stroke-width:" + (has_lines ? ".35" : ".5"));
}

/// Corners as steps of a tenth of a pixel, which says nearly everything in three characters.
std::string triangle_path(const PageTriangle& triangle) {
  const auto tenths = [](double px) { return std::floor(10.0 * px + 0.5); };
  std::string d;
  Vec2 last(0.0);
  for (const Vec2& place : triangle.places_px) {
    const Vec2 at(tenths(place.x), tenths(place.y));
    const std::string y = ui::coordinate(0.1 * (at.y - last.y));
    d += (d.empty() ? "M" : "l") + ui::coordinate(0.1 * (at.x - last.x)) +
         (y.front() == '-' ? "" : " ") + y;
    last = at;
  }
  return d + "z";
}

struct Seen {
  PageTriangle triangle;
  const SceneFace* face = nullptr;
};

bool is_in_window(const PageTriangle& triangle, const Camera& camera) {
  const auto& [a, b, c] = triangle.places_px;
  const Vec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
  return low.x <= camera.high_px.x && low.y <= camera.high_px.y && high.x >= camera.low_px.x &&
         high.y >= camera.low_px.y;
}

std::vector<Seen> look_at(const Scene& scene, const Camera& camera, Shows shows) {
  std::vector<Seen> all;
  for (const SceneFace& face : scene.faces()) {
    const auto& [a, b, c] = face.points_mm;
    const Vec3 across = glm::cross(b - a, c - a);
    const double doubled = std::sqrt(glm::dot(across, across));
    if (doubled == 0.0) continue;
    Vec3 normal = across / doubled;
    const bool is_back = glm::dot(normal, camera.toward) <= 0.0;
    if (is_back && shows == Shows::Solids) continue;
    if (is_back) normal = -normal;
    Seen seen;
    seen.face = &face;
    for (std::size_t k = 0; k < 3; ++k) {
      seen.triangle.places_px[k] = camera.page(face.points_mm[k]);
      seen.triangle.depths[k] = camera.depth(face.points_mm[k]);
    }
    if (!is_in_window(seen.triangle, camera)) continue;
    seen.triangle.paint = number_of({face.paint, is_back, shade_of(normal, camera)});
    all.push_back(seen);
  }
  return all;
}

std::string rims_path(const Seen& seen) {
  std::string d;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!seen.face->is_rim[k]) continue;
    const std::array<Vec2, 2> side{seen.triangle.places_px[k],
                                   seen.triangle.places_px[(k + 1) % 3]};
    d += path_through(side, false);
  }
  return d;
}

}  // namespace

void draw_keys(SvgPage& page, Vec2 place, const std::vector<PaintKey>& keys, const Vec2& step) {
  for (const PaintKey& key : keys) {
    const std::string name = "key" + std::to_string(static_cast<int>(key.paint));
    page.add_style(
        name, "fill:" + css_colour(rgb_of(key.paint), 1.0) + ";stroke:#3a3020;stroke-width:.6");
    page.key(place, name, key.words);
    place += step;
  }
}

Vec2 Camera::page(const Vec3& point_mm) const noexcept {
  const Vec3 from_target_mm = point_mm - target_mm;
  return middle_px +
         px_per_mm * Vec2(glm::dot(right, from_target_mm), -glm::dot(up, from_target_mm));
}

Camera camera_from(const Vec3& toward, const Vec3& up_hint) {
  Camera camera;
  camera.toward = unit(toward);
  camera.right = unit(glm::cross(up_hint, camera.toward));
  camera.up = glm::cross(camera.toward, camera.right);
  return camera;
}

void Scene::add(const IndexedMesh& mesh, const std::vector<Paint>& paints, const Vec3& shift_mm) {
  CHECK(paints.size() == mesh.triangles.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, Paint> sides;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& corners = mesh.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) sides[{corners[k], corners[(k + 1) % 3]}] = paints[i];
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& corners = mesh.triangles[i];
    SceneFace face;
    face.paint = paints[i];
    for (std::size_t k = 0; k < 3; ++k) {
      face.points_mm[k] = mesh.points_mm[corners[k]] + shift_mm;
      const auto other = sides.find({corners[(k + 1) % 3], corners[k]});
      face.is_rim[k] = other == sides.end() || other->second != paints[i];
    }
    faces_.push_back(face);
  }
}

std::size_t Scene::count(Paint paint) const noexcept {
  return static_cast<std::size_t>(std::count_if(
      faces_.begin(), faces_.end(), [&](const SceneFace& face) { return face.paint == paint; }));
}

void draw(const Scene& scene, const Camera& camera, SvgPage& page, Lines lines, Shows shows) {
  const std::vector<Seen> all = look_at(scene, camera, shows);
  std::vector<PageTriangle> triangles;
  triangles.reserve(all.size());
  for (const Seen& seen : all) triangles.push_back(seen.triangle);
  std::string run;
  std::uint32_t run_style = 0;
  const auto finish_run = [&] {
    if (!run.empty()) page.path(run, style_name(run_style));
    run.clear();
  };
  for (const std::uint32_t index : painter_order(triangles, seen_triangles(triangles))) {
    const std::uint32_t style = triangles[index].paint;
    if (style != run_style) finish_run();
    run_style = style;
    add_style(page, style, lines);
    run += triangle_path(triangles[index]);
    const std::string rims = rims_path(all[index]);
    if (rims.empty()) continue;
    finish_run();
    page.path(rims, "rim");
  }
  finish_run();
}

}  // namespace hallux::tests
