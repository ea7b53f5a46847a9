/// What holds of each planned cut while somebody saws: the kerf that was meant for it, and the part
/// of its section that stands.
///
/// A kerf belongs to the cut of the step at hand when its plane was frozen, of several to the one
/// whose plan it lies nearest to; where no step at hand is sawn, to the nearest of all. Of several
/// kerfs the one that leaves least counts. What a fragment's kerfs left when it was divided stays.
/// For displays: it follows the events and asks the fields, and feeds nothing back.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scenarios/plan.h"
#include "simulator/bone/cut_bone.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/record/record.h"
#include "simulator/sight/held_section.h"

namespace hallux::scenarios {

struct HeldCut {
  /// The kerf that counts; -1: none was begun.
  std::int32_t kerf = -1;
  /// In which it is, and where that lay when this was told.
  std::int32_t fragment = 0;
  RigidTransform bone_from_fragment = {};
  /// Of what the cut is to open: to the far side or to its hinge, within its window. 1 where none
  /// was begun.
  double share = 1.0;
  /// The side of the section on which it holds, "plantar-distal"; empty where it holds all over.
  std::string side = {};
  /// As it lies.
  Vec3 deepest_in_bone_mm{0.0, 0.0, 0.0};
  /// Outlines of the bone that is to be sawn, in the kerf's plane; holes likewise.
  std::vector<simulator::Contour> bone_mm = {};
  /// In the frame of the fragment, which is that of the bone before anything moved.
  RigidTransform bone_from_kerf = {};
  /// Around the section of which the blade touched something, in the kerf's plane.
  Vec2 low_mm{0.0, 0.0}, high_mm{0.0, 0.0};

  bool is_begun() const noexcept { return kerf >= 0; }
  bool is_through() const noexcept { return is_begun() && share == 0.0; }
  /// Of the kerf as it lies.
  RigidTransform bone_from_kerf_now() const noexcept { return bone_from_fragment * bone_from_kerf; }
};

/// Less than this of a section is nothing: a grid's edge, and crumbs.
inline constexpr double held_share_min = 0.004;

/// What is less than that of a section: nothing, or told like all that holds.
enum class Crumbs { Ignored, Told };

class SiteWatch {
 public:
  /// Borrows both.
  SiteWatch(const Scenario& scenario, const Plan& plan);

  /// Steps and frozen planes, in their order.
  /// needs   of each PlaneFrozen, `kerfs` froze it before
  void apply(const simulator::CutEvent& event, const simulator::KerfSet& kerfs);

  /// One entry for each of the plan's cuts.
  /// wholes       of each fragment what it was cut from since it is one
  /// crumbs       whether what is smaller than a display's grid is asked for, too
  /// thread  the one that applies; a millisecond for each kerf that grew
  std::vector<HeldCut> held(const simulator::KerfSet& kerfs,
                            std::span<const simulator::SolidWithTree> wholes,
                            Crumbs crumbs = Crumbs::Ignored);

 private:
  struct KerfOfCut {
    /// The number of cuts: of none, on a bone that is to be left alone.
    std::size_t cut = 0;
    /// What is to be sawn of it, once it was asked for.
    std::optional<simulator::Section> section = {};
    /// As it was told last.
    HeldCut held = {};
  };

  std::vector<std::size_t> cuts_at_hand() const;
  std::size_t cut_of(const simulator::KerfPlane& plane, std::size_t bone) const;
  HeldCut held_of(std::int32_t kerf, const simulator::KerfSet& kerfs,
                  const simulator::SolidWithTree& whole, Crumbs crumbs);

  const Scenario& scenario_;
  const Plan& plan_;
  std::vector<bool> is_done_;
  /// That was said last: taken up again, or in a chain the one after what was done.
  std::optional<std::size_t> told_step_ = 0;
  std::vector<KerfOfCut> kerfs_;
};

}  // namespace hallux::scenarios
