/// The panels over the picture of an operation: mode and time, steps, tool, force, how the blade
/// stands to the plan, what to do next, health.
///
/// All but the foot lies within an inset of 6 %, and the middle stays free. What does not fit a
/// small window goes in this order: the tracks of the plan, its values, the tool, the titles of
/// steps. A panel that
/// the tool passes behind fades while it does. Each value is told to who reads the screen's map.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/screens/operating/hud/cut_bands.h"
#include "ui/screens/operating/hud/operating_health.h"
#include "ui/screens/operating/hud/plan_reading.h"
#include "ui/screens/operating/hud/push_range.h"
#include "ui/screens/pictures/blade_section.h"
#include "ui/screens/pictures/way_ahead.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Of the window, around everything that lies over the picture.
inline constexpr float hud_inset_share = 0.06F;

struct HudStep {
  std::string title;
  /// A done one may be taken up again; another may be done next instead of the one at hand.
  bool is_done = false, can_reopen = false, can_choose = false;
};

/// The blade against the plan, as practice shows it.
struct HudPlan {
  PlanReading blade;
  PassReading pass;
  CutBands bands;
};

/// A value of the tool's axis or of a fragment against the plan, as practice shows it.
struct HudAim {
  /// "aim.entry"; and what it is called, as the id of a text.
  const char* id = "";
  std::string_view name_id;
  std::string value;
};

/// The tool in the hand, where there is a tray.
struct HudTool {
  std::string title, size;
  /// A saw or a drill, which are cooled.
  bool is_irrigated_kind = true;
  /// It may stay in the bone, and stands in it.
  bool is_implant = false, stands_in_bone = false;
  /// Where it left others, the driver takes hold of one.
  bool can_take = false;
  /// Forceps hold a piece, or lie open.
  bool is_gripping = false;
  double rate_per_minute = 0.0;
};

/// A place of the saw on the window, and how far around it the saw reaches there.
struct ToolPlace {
  Point at;
  float radius = 0.0F;
  /// A panel over it fades: the end that works, and to two eyes all that stands before a panel.
  bool fades_panels = true;
};

/// How the hand is on the saw.
enum class HandState { Led, LedFree, OnDevice, Lifted, Off };

/// What is to be learned now, in place of an attempt.
struct HudLesson {
  std::string task, goal;
};

struct OperatingHud {
  bool is_practice = true, is_paused = false, is_reviewed = false, is_simulated = false;
  bool is_left_handed = false;
  /// Of the person's name, which stands over the picture; empty: nobody's does.
  Rect badge;
  std::int64_t tick = 0;
  std::vector<HudStep> steps;
  /// At which one is.
  std::size_t step = 0;
  /// What its button says; "" for none.
  std::string_view step_action;
  /// It was pressed, and its work is under way.
  bool is_step_busy = false;
  /// Why it does nothing yet; empty: it does.
  std::string why_step_off;
  /// What to do next; empty: nothing to tell.
  std::string hint;
  simulator::Saw saw;
  bool is_saw_on = false, is_irrigated = false;
  double force_newton = 0.0;
  /// What the hints ask for now, else what is usual.
  PushRange push = usual_push;
  /// Of the hottest bone, where it is told while operating.
  std::optional<double> bone_celsius;
  /// Of the blade, on the window; and all of the saw.
  std::optional<Point> tip;
  std::vector<ToolPlace> tool;
  /// What lies ahead of the teeth, where people are to know it.
  std::optional<WayAhead> way;
  /// Beside the tip: what lies ahead, and how far off the plan.
  std::vector<std::string> tip_lines;
  std::optional<HudPlan> plan;
  /// In place of that.
  std::vector<HudAim> aims;
  /// Nothing where a saw is all there is.
  std::optional<HudTool> held;
  /// In the blade's plane; null: it is not shown.
  const BladeSection* inset = nullptr;
  HandState hand = HandState::Off;
  OperatingHealth health;
  bool is_health_open = false;
  /// In the frame before the hints stood above the lower panels.
  bool are_hints_low = false;
  /// Nothing in an attempt.
  std::optional<HudLesson> lesson;
};

/// What was pressed, and where hints stand.
struct HudAnswer {
  bool step = false, pause = false, health = false, finish = false, abandon = false;
  bool saw = false, irrigation = false;
  bool tray = false, forceps = false, drive_home = false, leave_or_take = false;
  /// For the next frame.
  bool are_hints_low = false;
  /// Of a lesson: it is left out, or all of it is done anew.
  bool skip = false, again = false;
  /// A step that is to be taken up: again, or instead of the one at hand.
  std::optional<std::size_t> take_up;
};

HudAnswer draw_operating_hud(Ui& ui, const OperatingHud& hud);

/// One decimal with the true minus: "−2.4".
std::string signed_text(double value);
/// One decimal.
std::string decimal_text(double value);

}  // namespace hallux::ui
