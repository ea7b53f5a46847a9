#include "assessment/rebuild/cut_of_kerf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "assessment/rebuild/face_samples.h"
#include "scenarios/site/kerf_of_cut.h"
#include "scenarios/site/planned_window.h"

namespace hallux::assessment {

namespace {

using scenarios::misfit;
using scenarios::Plan;
using scenarios::PlannedHinge;
using scenarios::ReferenceFace;
using simulator::KerfPlane;
using CutsAtHand = std::vector<std::optional<std::size_t>>;

/// What is not open is not done, however little is missing.
constexpr double almost_done = 0.999;
/// Less than this of a cut is a false start.
constexpr double least_cut = 0.5;

/// Planes that lie nearer to each other than this, or cross, have no order.
constexpr double least_apart_mm = 0.1;
/// A plane that lies along the bone is nowhere proximal of another: the least x of its normal.
constexpr double least_across = 0.1;

/// Two cuts of a hinge: all kerfs are the one's, and one of them is to be the other's.
struct Sharing {
  std::size_t from = 0, to = 0;
};

ReferenceFace face_of(const RebuiltBone& rebuilt, std::int32_t kerf) noexcept {
  const RigidTransform& bone_from_kerf = rebuilt.fields.plane(kerf).bone_from_kerf;
  const Vec3 normal = axis_z(bone_from_kerf);
  return {normal, glm::dot(normal, bone_from_kerf.translation_mm)};
}

double x_mm_at(const ReferenceFace& face, const Vec3& in_bone_mm) noexcept {
  const Vec3& normal = face.normal;
  return (face.offset_mm - normal.y * in_bone_mm.y - normal.z * in_bone_mm.z) / normal.x;
}

/// 1 where `b` lies distal of `a` at the entries of both cuts, -1 where it lies proximal, 0 where
/// that says nothing.
int order_at_entry(const ReferenceFace& a, const ReferenceFace& b, const Plan& plan,
                   const Sharing& sharing) noexcept {
  if (std::min(std::abs(a.normal.x), std::abs(b.normal.x)) < least_across) return 0;
  double least_mm = std::numeric_limits<double>::infinity(), most_mm = -least_mm;
  for (const std::size_t cut : {sharing.from, sharing.to}) {
    const Vec3& entry_mm = plan.cuts[cut].entry_point_in_bone_mm;
    const double apart_mm = x_mm_at(b, entry_mm) - x_mm_at(a, entry_mm);
    least_mm = std::min(least_mm, apart_mm);
    most_mm = std::max(most_mm, apart_mm);
  }
  if (least_mm >= least_apart_mm) return 1;
  return most_mm <= -least_apart_mm ? -1 : 0;
}

/// The kerf that lies on the side of the cut `to` of all others; nothing where that is not clear.
std::optional<std::int32_t> furthest_at_entry(const std::vector<std::int32_t>& sawn,
                                              const RebuiltBone& rebuilt, const Plan& plan,
                                              const Sharing& sharing) {
  const int planned =
      order_at_entry(plan.cuts[sharing.from].face, plan.cuts[sharing.to].face, plan, sharing);
  if (planned == 0) return std::nullopt;
  const auto is_beyond = [&](std::int32_t kerf, std::int32_t other) {
    return order_at_entry(face_of(rebuilt, other), face_of(rebuilt, kerf), plan, sharing) ==
           planned;
  };
  for (const std::int32_t kerf : sawn) {
    if (std::ranges::all_of(
            sawn, [&](std::int32_t other) { return other == kerf || is_beyond(kerf, other); })) {
      return kerf;
    }
  }
  return std::nullopt;
}

/// The kerf that loses least when it goes over.
std::int32_t nearest_to_other(const std::vector<std::int32_t>& sawn, const RebuiltBone& rebuilt,
                              const Plan& plan, const Sharing& sharing) {
  const auto loss = [&](std::int32_t kerf) {
    const KerfPlane& plane = rebuilt.fields.plane(kerf);
    return misfit(plane, plan.cuts[sharing.to]) - misfit(plane, plan.cuts[sharing.from]);
  };
  return *std::ranges::min_element(sawn, {}, loss);
}

/// The kerfs of a wedge, shared among its two cuts.
class SharedWedge {
 public:
  SharedWedge(const RebuiltBone& rebuilt, const Plan& plan, const PlannedHinge& hinge)
      : rebuilt_(rebuilt),
        plan_(plan),
        first_(index_of_cut(plan, hinge.first_cut)),
        second_(index_of_cut(plan, hinge.second_cut)) {}

  void share(std::vector<std::size_t>& cuts, const CutsAtHand& at_hand) const {
    const std::vector<std::int32_t> sawn = sawn_of(cuts);
    if (sawn.size() < 2) return;
    const std::size_t one = cut_in(cuts, sawn.front());
    const bool is_one_cut =
        std::ranges::all_of(sawn, [&](std::int32_t kerf) { return cut_in(cuts, kerf) == one; });
    const bool is_untold = sawn.size() == 2 && std::ranges::none_of(sawn, [&](std::int32_t kerf) {
                             return at_hand[static_cast<std::size_t>(kerf)].has_value();
                           });
    if (!is_one_cut && !is_untold) return;
    const Sharing sharing{one, one == first_ ? second_ : first_};
    std::optional<std::int32_t> other = furthest_at_entry(sawn, rebuilt_, plan_, sharing);
    if (!other && is_one_cut) other = nearest_to_other(sawn, rebuilt_, plan_, sharing);
    if (!other) return;
    for (const std::int32_t kerf : sawn) {
      cuts[static_cast<std::size_t>(kerf)] = kerf == *other ? sharing.to : sharing.from;
    }
  }

 private:
  static std::size_t cut_in(const std::vector<std::size_t>& cuts, std::int32_t kerf) {
    return cuts[static_cast<std::size_t>(kerf)];
  }

  /// The kerfs of either cut that are no false start.
  std::vector<std::int32_t> sawn_of(const std::vector<std::size_t>& cuts) const {
    std::vector<std::int32_t> sawn;
    for (std::int32_t kerf = 0; kerf < rebuilt_.fields.count(); ++kerf) {
      const std::size_t cut = cut_in(cuts, kerf);
      if (cut != first_ && cut != second_) continue;
      if (done_fraction_of(rebuilt_, kerf, plan_, cut) >= least_cut) sawn.push_back(kerf);
    }
    return sawn;
  }

  const RebuiltBone& rebuilt_;
  const Plan& plan_;
  std::size_t first_, second_;
};

}  // namespace

double done_fraction_of(const RebuiltBone& rebuilt, std::int32_t kerf, const Plan& plan,
                        std::size_t cut) {
  const PlannedHinge* const hinge = find_hinge(plan, plan.cuts[cut].hinge);
  const std::optional<scenarios::FaceWindow>& window = plan.cuts[cut].window;
  if (hinge == nullptr && !window)
    return rebuilt.kerfs[static_cast<std::size_t>(kerf)].done_fraction();
  const double kerf_mm = rebuilt.fields.plane(kerf).thickness_mm;
  const double share = hinge != nullptr
                           ? opened_share(rebuilt, kerf, window_before(*hinge, kerf_mm))
                           : opened_share(rebuilt, kerf, *window);
  return share == 1.0 ? share : std::min(share, almost_done);
}

std::vector<std::size_t> cuts_of_kerfs(const RebuiltBone& rebuilt, const Plan& plan,
                                       const StepEvidence& evidence) {
  const CutsAtHand at_hand = cuts_at_hand(rebuilt, plan, evidence);
  std::vector<std::size_t> cuts;
  cuts.reserve(at_hand.size());
  for (std::int32_t kerf = 0; kerf < rebuilt.fields.count(); ++kerf) {
    const std::optional<std::size_t>& told = at_hand[static_cast<std::size_t>(kerf)];
    const std::size_t bone = bone_of(rebuilt, kerf);
    const bool is_of_it = told && plan.cuts[*told].bone == bone;
    cuts.push_back(is_of_it ? *told
                            : scenarios::nearest_cut(rebuilt.fields.plane(kerf), plan, bone));
  }
  for (const PlannedHinge& hinge : plan.hinges) {
    SharedWedge(rebuilt, plan, hinge).share(cuts, at_hand);
  }
  return cuts;
}

}  // namespace hallux::assessment
