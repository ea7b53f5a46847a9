#include "tests/simulator/cutting/frames/frame_count.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "simulator/cutting/solid/opened_volume.h"
#include "tests/simulator/cutting/worlds/shown_solid.h"

namespace hallux::tests {

using namespace simulator;

namespace {

/// How far the outline of a grown field may lie behind the one before it (docs/cutting.md 2).
constexpr double outline_slack_mm = 2e-4;

/// Per skin of a contact: whether it runs around a hole on either plane.
std::vector<bool> skins_around_holes(const SlabSlice& contact) {
  std::vector<std::array<double, 2>> area(contact.skin_count, {0.0, 0.0});
  for (const StripEdge& edge : contact.edges) {
    if (edge.level == 0) continue;
    const LatticePoint &a = contact.points[edge.a].place, &b = contact.points[edge.b].place;
    const std::uint32_t skin = contact.touched[edge.touched].skin;
    area[skin][edge.level > 0 ? 1 : 0] += static_cast<double>(a.u) * static_cast<double>(b.v) -
                                          static_cast<double>(a.v) * static_cast<double>(b.u);
  }
  std::vector<bool> is_hole;
  is_hole.reserve(area.size());
  for (const auto& [below, above] : area) is_hole.push_back(below < 0.0 || above > 0.0);
  return is_hole;
}

double border_mm(const RegionOutline& region) {
  double border_mm = 0.0;
  std::size_t first = 0;
  for (const std::size_t last : region.loop_ends) {
    for (std::size_t i = first; i < last; ++i) {
      const Vec2 side_mm = region.corners_mm[i + 1 < last ? i + 1 : first] - region.corners_mm[i];
      border_mm += std::sqrt(glm::dot(side_mm, side_mm));
    }
    first = last;
  }
  return border_mm;
}

bool names_each_point_once(const SolidPatch& patch) {
  return std::none_of(patch.triangles.begin(), patch.triangles.end(), [](const Triangle& corners) {
    return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
  });
}

class FrameChecker {
 public:
  FrameChecker(std::uint64_t seed, FrameCount& count) : seed_(seed), count_(count) {}

  void check(const PlayedFrame& frame) {
    ++count_.frames;
    if (frame.frame == 0) begin_kerf(frame);
    if (!frame.is_built) blame("refused", frame.kerf, frame.frame);
    if (frame.patch.triangles.empty()) return;
    ++count_.intersected;
    if (!names_each_point_once(frame.patch)) {
      blame("names a point twice", frame.kerf, frame.frame);
    }
    const IndexedMesh shown = shown_mesh(frame.solid, frame.patch);
    if (!is_closed_as_chain(shown)) blame("open", frame.kerf, frame.frame);
    const double removed_mm3 = mesh_mm3_ - signed_volume_mm3(shown);
    check_balance(frame, removed_mm3);
    if (removed_mm3 > 0.0 && !frame.builder.takes_section()) ++count_.partial;
    if (body_count(shown) > bodies_) ++count_.severed;
    if (reaches_hole(frame)) ++count_.nested;
  }
  void check_commit(const CutSolid& solid, std::int32_t kerf) {
    ++count_.commits;
    if (!is_strictly_closed(solid.mesh)) blame("not strictly closed after commit", kerf, -1);
  }

 private:
  void begin_kerf(const PlayedFrame& frame) {
    mesh_mm3_ = signed_volume_mm3(frame.solid.mesh);
    bodies_ = body_count(frame.solid.mesh);
    removed_mm3_ = removed_limit_mm3_ = 0.0;
    is_around_hole_ = skins_around_holes(frame.contact);
  }
  void check_balance(const PlayedFrame& frame, double removed_mm3) {
    const double limit_mm3 = balance_limit_mm3(frame.solid, frame.patch);
    const double expected_mm3 = opened_volume_mm3(frame.solid, frame.contact.plane, frame.region);
    if (!(std::abs(removed_mm3 - expected_mm3) <= limit_mm3)) {
      blame("out of balance by " + std::to_string(1e6 * (removed_mm3 - expected_mm3)) +
                " of at most " + std::to_string(1e6 * limit_mm3) + " 1e-6 mm3",
            frame.kerf, frame.frame);
    }
    // Each of the two volumes is known to its own limit, and the outline may fall back by its
    // slack.
    const double fall_mm3 =
        limit_mm3 + removed_limit_mm3_ +
        outline_slack_mm * border_mm(frame.region) * frame.contact.plane.thickness_mm;
    if (removed_mm3 < removed_mm3_ - fall_mm3) blame("grew back", frame.kerf, frame.frame);
    if (removed_mm3 < removed_mm3_) return;
    removed_mm3_ = removed_mm3;
    removed_limit_mm3_ = limit_mm3;
  }
  bool reaches_hole(const PlayedFrame& frame) const {
    std::size_t next = 0;
    for (const TouchedTriangle& touched : frame.contact.touched) {
      if (next == frame.patch.hidden.size()) break;
      if (frame.patch.hidden[next] != touched.base_triangle) continue;
      ++next;
      if (is_around_hole_[touched.skin]) return true;
    }
    return false;
  }
  void blame(const std::string& what, std::int32_t kerf, std::int32_t frame) {
    std::ostringstream text;
    text << what << ": world " << seed_ << ", kerf " << kerf << ", frame " << frame;
    count_.faults.push_back(text.str());
  }

  std::uint64_t seed_;
  FrameCount& count_;
  double mesh_mm3_ = 0.0, removed_mm3_ = 0.0, removed_limit_mm3_ = 0.0;
  std::size_t bodies_ = 0;
  std::vector<bool> is_around_hole_;
};

}  // namespace

void count_world(std::uint64_t seed, FrameCount& count) {
  Random random(seed);
  FrameChecker checker(seed, count);
  const auto visit = [&](const PlayedFrame& frame) { checker.check(frame); };
  const auto visit_commit = [&](const CutSolid& solid, std::int32_t kerf) {
    checker.check_commit(solid, kerf);
  };
  if (random.bits() % 4 == 0) {
    play_lattice(random, visit, visit_commit);
  } else {
    play_bone(random, visit, visit_commit);
  }
}

void count_mesh(const IndexedMesh& mesh, std::uint64_t seed, FrameCount& count) {
  Random random(seed);
  FrameChecker checker(seed, count);
  play_mesh(
      mesh, random, [&](const PlayedFrame& frame) { checker.check(frame); },
      [&](const CutSolid& solid, std::int32_t kerf) { checker.check_commit(solid, kerf); });
}

std::string sentence_of(const FrameCount& count) {
  std::ostringstream text;
  text.precision(1);
  text << std::fixed << count.frames << " frames, " << count.commits << " commits";
  const auto add = [&](const char* what, std::uint64_t some) {
    text << ", " << what << ' '
         << 100.0 * static_cast<double>(some) / static_cast<double>(count.frames) << " %";
  };
  add("intersected", count.intersected);
  add("cut partially", count.partial);
  add("severed", count.severed);
  add("met a nested section", count.nested);
  text << ", faults " << count.faults.size();
  return text.str();
}

std::vector<std::string> complaints(const FrameCount& count) {
  std::vector<std::string> all = count.faults;
  const auto expect_share = [&](const char* what, std::uint64_t some) {
    if (10 * some <= count.frames) all.push_back(std::string("too few frames ") + what);
  };
  expect_share("intersected", count.intersected);
  expect_share("cut partially", count.partial);
  expect_share("severed", count.severed);
  expect_share("met a nested section", count.nested);
  return all;
}

}  // namespace hallux::tests
