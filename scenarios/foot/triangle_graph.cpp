#include "scenarios/foot/triangle_graph.h"

#include <algorithm>
#include <utility>

#include "scenarios/scenario_error.h"

namespace hallux::scenarios {

TriangleGraph::TriangleGraph(const simulator::IndexedMesh& mesh)
    : points_mm_(mesh.points_mm),
      leaving_(mesh.points_mm.size(), dead),
      valence_(mesh.points_mm.size(), 0) {
  start_.reserve(mesh.triangles.size() * 3);
  for (const simulator::Triangle& t : mesh.triangles) {
    start_.insert(start_.end(), t.begin(), t.end());
  }
  twin_.assign(start_.size(), dead);
  std::vector<std::pair<std::uint64_t, Side>> edges;
  edges.reserve(start_.size());
  for (Side h = 0; h < side_count(); ++h) {
    leaving_[start_[h]] = h;
    ++valence_[start_[h]];
    const std::uint64_t low = std::min(start(h), end(h));
    edges.emplace_back((low << 32U) | std::max(start(h), end(h)), h);
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
    if (edges[i].first == edges[i + 1].first) pair(edges[i].second, edges[i + 1].second);
  }
  for (Side h = 0; h < side_count(); ++h) {
    if (twin_[h] == dead || start(twin_[h]) != end(h)) {
      throw ScenarioError("the generated surface is open; ask for a finer edge length");
    }
  }
}

void TriangleGraph::pair(Side a, Side b) noexcept {
  twin_[a] = b;
  twin_[b] = a;
}

void TriangleGraph::set_triangle(Side first, PointIndex a, PointIndex b, PointIndex c) noexcept {
  start_[first] = a;
  start_[first + 1] = b;
  start_[first + 2] = c;
}

bool TriangleGraph::are_neighbours(PointIndex a, PointIndex b) const noexcept {
  bool found = false;
  for_each_leaving(a, [&](Side h) { found = found || end(h) == b; });
  return found;
}

Vec3 TriangleGraph::area_vector(Side h) const noexcept {
  const Vec3& a = at(start(h));
  return glm::cross(at(end(h)) - a, at(apex(h)) - a);
}

PointIndex TriangleGraph::split(Side h, const Vec3& point_mm) {
  // a -> b with apexes c (this side) and d: the new point m lies between a and b. The old triangles keep a's half.
  const Side g = twin_[h];
  const PointIndex b = end(h);
  const PointIndex c = apex(h);
  const PointIndex d = apex(g);
  const auto m = static_cast<PointIndex>(points_mm_.size());
  points_mm_.push_back(point_mm);
  const Side bc = next(h);
  const Side db = previous(g);
  const Side bc_twin = twin_[bc];
  const Side db_twin = twin_[db];
  const Side u = side_count();
  start_.insert(start_.end(), {m, b, c, b, m, d});
  twin_.resize(start_.size(), dead);
  start_[bc] = m;        // triangle of h: a m c
  start_[g] = m;         // triangle of g: m a d
  pair(u, u + 3);        // m b | b m
  pair(u + 1, bc_twin);  // b c
  pair(u + 2, bc);       // c m | m c
  pair(u + 5, db_twin);  // d b
  pair(u + 4, db);       // m d | d m
  leaving_.push_back(u);
  leaving_[b] = u + 1;
  valence_.push_back(4);
  ++valence_[c];
  ++valence_[d];
  return m;
}

bool TriangleGraph::can_collapse(Side h) const noexcept {
  const PointIndex a = start(h);
  const PointIndex b = end(h);
  if (valence_[apex(h)] <= 3 || valence_[apex(twin_[h])] <= 3) return false;
  if (valence_[a] + valence_[b] > 16) return false;
  int common = 0;
  for_each_leaving(a, [&](Side ha) {
    const PointIndex neighbour = end(ha);
    if (neighbour != b && are_neighbours(b, neighbour)) ++common;
  });
  return common == 2;
}

void TriangleGraph::collapse(Side h, const Vec3& point_mm) {
  const Side g = twin_[h];
  const PointIndex a = start(h);
  const PointIndex b = end(h);
  const PointIndex c = apex(h);
  const PointIndex d = apex(g);
  const Side bc = twin_[next(h)];      // c b, outside
  const Side ca = twin_[previous(h)];  // a c, outside
  const Side ad = twin_[next(g)];      // d a, outside
  const Side db = twin_[previous(g)];  // b d, outside
  std::vector<Side> leaving_b;
  for_each_leaving(b, [&](Side hb) { leaving_b.push_back(hb); });
  for (const Side hb : leaving_b) start_[hb] = a;
  pair(bc, ca);
  pair(ad, db);
  leaving_[a] = ca;
  leaving_[c] = bc;
  leaving_[d] = ad;
  leaving_[b] = dead;
  for (const Side first : {h - h % 3, g - g % 3}) set_triangle(first, dead, dead, dead);
  valence_[a] += valence_[b] - 4;
  --valence_[c];
  --valence_[d];
  points_mm_[a] = point_mm;
}

bool TriangleGraph::can_flip(Side h) const noexcept {
  return valence_[start(h)] > 3 && valence_[end(h)] > 3 && !are_neighbours(apex(h), apex(twin_[h]));
}

void TriangleGraph::flip(Side h) {
  const Side g = twin_[h];
  const PointIndex a = start(h);
  const PointIndex b = end(h);
  const PointIndex c = apex(h);
  const PointIndex d = apex(g);
  const Side bc = twin_[next(h)];
  const Side ca = twin_[previous(h)];
  const Side ad = twin_[next(g)];
  const Side db = twin_[previous(g)];
  const Side t = h - h % 3;
  const Side s = g - g % 3;
  set_triangle(t, c, d, b);
  set_triangle(s, d, c, a);
  pair(t, s);
  pair(t + 1, db);
  pair(t + 2, bc);
  pair(s + 1, ca);
  pair(s + 2, ad);
  leaving_[a] = s + 2;
  leaving_[b] = t + 2;
  leaving_[c] = t;
  leaving_[d] = s;
  --valence_[a];
  --valence_[b];
  ++valence_[c];
  ++valence_[d];
}

simulator::IndexedMesh TriangleGraph::indexed() const {
  simulator::IndexedMesh mesh;
  std::vector<PointIndex> number(points_mm_.size(), dead);
  for (PointIndex p = 0; p < point_count(); ++p) {
    if (!is_point(p)) continue;
    number[p] = static_cast<PointIndex>(mesh.points_mm.size());
    mesh.points_mm.push_back(points_mm_[p]);
  }
  for (Side first = 0; first < side_count(); first += 3) {
    if (!is_side(first)) continue;
    mesh.triangles.push_back(
        {number[start_[first]], number[start_[first + 1]], number[start_[first + 2]]});
  }
  return mesh;
}

}  // namespace hallux::scenarios
