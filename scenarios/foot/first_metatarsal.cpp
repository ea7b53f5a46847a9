#include "scenarios/foot/first_metatarsal.h"

#include <array>
#include <utility>

#include "simulator/base/progress.h"

namespace hallux::scenarios {
namespace {

/// Solves m x = b for four unknowns by elimination with row exchange.
std::array<double, 4> solve(std::array<std::array<double, 5>, 4> m) {
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t best = c;
    for (std::size_t r = c + 1; r < 4; ++r) {
      if (std::abs(m[r][c]) > std::abs(m[best][c])) best = r;
    }
    std::swap(m[c], m[best]);
    for (std::size_t r = 0; r < 4; ++r) {
      if (r == c) continue;
      const double share = m[r][c] / m[c][c];
      for (std::size_t k = c; k < 5; ++k) m[r][k] -= share * m[c][k];
    }
  }
  return {m[0][4] / m[0][0], m[1][4] / m[1][1], m[2][4] / m[2][2], m[3][4] / m[3][3]};
}

/// Centre of the sphere nearest to the head's cartilage: |p|^2 = 2 p . c + k in least squares. The
/// points tagged as cartilage are laid on the head as it is without a grown eminence, which would
/// draw the centre after it.
Vec3 head_centre(const LandmarkSources& sources) {
  const BoneField plain(sources.table, sources.length_mm, 0.0);
  const Vec3 about = sources.field.stretched(sources.table.cartilage.centre_mm);
  std::array<std::array<double, 5>, 4> m{};
  for (const Vec3& point : sources.outer.points_mm) {
    if (!sources.field.is_head_cartilage(point)) continue;
    const Vec3 p = plain.onto_surface(point) - about;
    const std::array<double, 5> row{2.0 * p.x, 2.0 * p.y, 2.0 * p.z, 1.0, glm::dot(p, p)};
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c < 5; ++c) m[r][c] += row[r] * row[c];
    }
  }
  const auto x = solve(m);
  return about + Vec3{x[0], x[1], x[2]};
}

const Feature& feature_named(const BoneTable& table, std::string_view name) {
  for (const Feature& feature : table.features) {
    if (feature.name == name) return feature;
  }
  throw ScenarioError("the table of " + table.bone + " has no feature '" + std::string(name) +
                      "', after which a landmark is named; add it");
}

/// The bottom of a groove: its line lies outside the bone, one radius from it, away from the head's
/// centre.
Vec3 groove_bottom(const LandmarkSources& sources, const Vec3& on_line_mm, double radius_mm) {
  const Vec3 inward = sources.table.cartilage.centre_mm - on_line_mm;
  const double share = radius_mm / length_of(inward);
  return on_surface(sources, on_line_mm + inward * share);
}

Vec3 feature_point(const LandmarkSources& sources, std::string_view name) {
  const Feature& feature = feature_named(sources.table, name);
  if (feature.kind == FeatureKind::Bump) {
    return on_surface(sources, feature.centre_mm);
  }
  return groove_bottom(sources, 0.5 * (feature.centre_mm + feature.end_mm), feature.radius_mm);
}

/// Half way along the groove beside a grown eminence; without one the table's own sulcus.
Vec3 medial_sulcus(const LandmarkSources& sources) {
  const std::vector<Vec3>& bottom = sources.field.sulcus_bottom_mm();
  if (bottom.empty()) return feature_point(sources, "sag_sulcus");
  return on_surface(sources, bottom[bottom.size() / 2]);
}

/// Where the cartilage ends in the sagittal plane through the head's centre.
Vec3 cartilage_edge(const LandmarkSources& sources, double angle_rad) {
  const HeadCartilage& c = sources.table.cartilage;
  const Vec3 direction{elementary::cos(angle_rad), elementary::sin(angle_rad), 0.0};
  return on_surface(sources, c.centre_mm + c.radius_mm * direction);
}

}  // namespace

std::vector<simulator::Landmark> first_metatarsal_landmarks(const LandmarkSources& sources) {
  const simulator::IndexedMesh& mesh = sources.outer;
  const double length = sources.length_mm;
  const Vec3 medial{0.0, 0.0, -1.0};
  return {
      {"head_centre", head_centre(sources)},
      {"head_apex", extreme_point(mesh, {1.0, 0.0, 0.0}, 0.5 * length, 2.0 * length)},
      {"med_sulcus", medial_sulcus(sources)},
      {"dorsal_cart_edge", cartilage_edge(sources, sources.table.cartilage.dorsal_rad)},
      {"plantar_cart_edge", cartilage_edge(sources, -sources.table.cartilage.plantar_rad)},
      {"sesamoid_groove_med", feature_point(sources, "ses_groove_m")},
      {"sesamoid_groove_lat", feature_point(sources, "ses_groove_l")},
      {"crista", feature_point(sources, "crista")},
      {"tmt_centre", cap_centre(sources, sources.table.base)},
      {"shaft_proximal", slice_centroid(mesh, length / 3.0)},
      {"shaft_distal", slice_centroid(mesh, length * 2.0 / 3.0)},
      {"shaft_medial", extreme_point(mesh, medial, 0.62 * length, 0.66 * length)},
      {"eminence_apex", extreme_point(mesh, medial, 0.75 * length, 2.0 * length)},
  };
}

simulator::Bone make_first_metatarsal(const BoneTable& table, const BoneRequest& request,
                                      const Progress& progress) {
  return make_bone(table, request, {"first_metatarsal", first_metatarsal_landmarks}, progress);
}

BoneTable first_metatarsal_table() { return shipped_bone_table("first_metatarsal.txt"); }

}  // namespace hallux::scenarios
