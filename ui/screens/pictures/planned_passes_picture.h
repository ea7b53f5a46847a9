/// The passes of a blade that is narrower than the bone, laid out in its section: for a briefing,
/// before anything is sawn.
///
///      [ 1 ]
///         [ 2 ]      the blade of each, its ways sharing a part of the bone
///      :  :  :  :     where their edges run
///     (  section  )
#pragma once

#include <vector>

#include "scenarios/site/planned_passes.h"
#include "ui/screens/pictures/blade_section.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// How one cut is sawn.
struct PassesInView {
  /// With the blade of the first pass before the bone; x is the feed, y lies along its teeth.
  BladeSection section;
  double blade_width_mm = 0.0;
  /// Of the section along the teeth, as far as it is to be sawn.
  double bone_width_mm = 0.0;
  /// Of the blade's middle in each pass, in the plane of `section`, ascending.
  std::vector<double> middles_mm;

  bool is_one() const noexcept { return middles_mm.size() < 2; }
};

/// needs   the plan is the scenario's on the bone of `whole`, uncut, with its tree
/// thread  any; milliseconds
PassesInView passes_in_view(const scenarios::Scenario& scenario, const scenarios::Plan& plan,
                            std::size_t cut, const simulator::CutSolid& whole,
                            const simulator::Bvh& tree);

/// "The blade is 12 mm wide, the bone here 17.3 mm: ..."
/// needs   more than one pass
std::string passes_text(const Texts& texts, const PassesInView& passes);

/// The same as a picture; the saw goes downwards.
void draw_passes(Ui& ui, const Rect& rect, const PassesInView& passes);

}  // namespace hallux::ui
