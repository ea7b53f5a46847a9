#include "assessment/rebuild/planned_implants.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace hallux::assessment {

namespace {

using scenarios::ImplantKind;
using scenarios::PlannedFixation;
using scenarios::PlannedImplant;

/// A try began within this of where the implant came to lie.
constexpr double same_entry_mm = 10.0;

bool is_of_kind(const PlacedImplant& placed, const PlannedImplant& planned) noexcept {
  return placed.is_screw == (planned.kind == ImplantKind::Screw);
}

/// How far both ends lie from the planned ones.
double ends_off_mm(const PlacedImplant& placed, const PlannedImplant& planned) {
  return length_of(placed.entry_in_bone_mm - planned.entry_in_bone_mm) +
         length_of(placed.tip_in_bone_mm - planned.tip_in_bone_mm);
}

struct Pair {
  /// What should have stayed and was taken out comes last.
  bool is_gone = false;
  double off_mm = 0.0;
  std::size_t planned = 0;
  PlacedImplant* placed = nullptr;
};

std::vector<PlacedImplant*> all_of(Fixation& fixation) {
  std::vector<PlacedImplant*> all;
  for (std::vector<PlacedImplant>* list : {&fixation.implants, &fixation.taken}) {
    for (PlacedImplant& placed : *list) all.push_back(&placed);
  }
  return all;
}

/// The best pairs first.
std::vector<Pair> pairs_of(const std::vector<PlacedImplant*>& all, const PlannedFixation& plan) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < plan.implants.size(); ++i) {
    const PlannedImplant& planned = plan.implants[i];
    for (PlacedImplant* placed : all) {
      if (!is_of_kind(*placed, planned)) continue;
      const bool is_gone = placed->is_taken && !planned.is_temporary;
      pairs.push_back({is_gone, ends_off_mm(*placed, planned), i, placed});
    }
  }
  std::ranges::stable_sort(pairs, [](const Pair& a, const Pair& b) {
    return std::tie(a.is_gone, a.off_mm) < std::tie(b.is_gone, b.off_mm);
  });
  return pairs;
}

/// The implant that one which was taken out was a try for: of its kind, set later, nearest.
PlacedImplant* tried_for(const PlacedImplant& taken, const std::vector<PlacedImplant*>& all) {
  PlacedImplant* nearest = nullptr;
  double nearest_mm = same_entry_mm;
  for (PlacedImplant* other : all) {
    const bool is_later = other->is_screw == taken.is_screw && other->left_tick > taken.left_tick;
    const double off_mm = length_of(other->entry_in_bone_mm - taken.entry_in_bone_mm);
    if (!is_later || off_mm > nearest_mm) continue;
    nearest = other;
    nearest_mm = off_mm;
  }
  return nearest;
}

}  // namespace

void assign_planned(Fixation& fixation, const PlannedFixation& plan) {
  const std::vector<PlacedImplant*> all = all_of(fixation);
  std::vector<bool> has_one(plan.implants.size(), false);
  for (const Pair& pair : pairs_of(all, plan)) {
    if (has_one[pair.planned] || pair.placed->planned) continue;
    has_one[pair.planned] = true;
    pair.placed->planned = pair.planned;
  }
  // Of several tries the last one counts.
  for (PlacedImplant& taken : fixation.taken) {
    PlacedImplant* const later = taken.planned ? tried_for(taken, all) : nullptr;
    if (later == nullptr || later->planned) continue;
    later->planned = std::exchange(taken.planned, std::nullopt);
  }
  // In their order, so that the tries before a try go on with it.
  for (PlacedImplant& taken : fixation.taken) {
    if (taken.planned) continue;
    if (PlacedImplant* later = tried_for(taken, all)) later->insertions += taken.insertions;
  }
}

}  // namespace hallux::assessment
