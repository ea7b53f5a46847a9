// Panels over the picture, each a function of the facts. They lie at the edges and leave the middle
// to the bone; what does not fit goes in an order that keeps force and state to the last. Over a
// panel a free pointer is a pointer, so each panel is an area of its own. Colours have a shape
// beside them.
#include "ui/screens/operating/hud/operating_hud.h"

#include <algorithm>
#include <cmath>

#include "ui/screens/operating/hud/hud_bar.h"
#include "ui/screens/operating/hud/hud_foot.h"
#include "ui/screens/operating/hud/hud_hints.h"
#include "ui/screens/operating/hud/hud_lesson.h"
#include "ui/screens/operating/hud/hud_readings.h"
#include "ui/screens/operating/hud/hud_tip.h"
#include "ui/screens/pictures/blade_section_view.h"
#include "ui/widgets/texts/number_text.h"

namespace hallux::ui {

namespace {

/// Down to the panels at the side: of the person's name, or of a lesson with one line of hints.
constexpr float badge_room = 112.0F, lesson_room = 204.0F;
constexpr float health_width = 280.0F;
constexpr float inset_width = 300.0F, inset_height = 236.0F, inset_least_height = 100.0F,
                inset_least_room = 560.0F;

constexpr double bytes_per_megabyte = 1e6;

struct HealthRow {
  std::string_view name;
  std::string value;
};

/// What the arm is given, one line for each thing that held it back.
void add_arm_rows(std::vector<HealthRow>& rows, const Ui& ui, const ArmHealth& arm) {
  rows.push_back({ui.text("operate.health.arm"), decimal_text(arm.force_newton) + " N"});
  rows.push_back(
      {ui.text("operate.health.scale"), grouped(std::lround(100.0 * arm.force_scale)) + " %"});
  std::string_view name = ui.text("operate.health.limits");
  for (const std::string_view id : limit_text_ids(arm.limits)) {
    rows.push_back({name, std::string(ui.text(id))});
    name = {};
  }
  if (!name.empty()) rows.push_back({name, std::string(ui.text("limit.none"))});
}

std::vector<HealthRow> health_rows(const Ui& ui, const OperatingHealth& health) {
  const auto granted = [&](bool is_granted) {
    return std::string(ui.text(is_granted ? "operate.yes" : "operate.no"));
  };
  std::vector<HealthRow> rows{
      {ui.text("operate.health.frame"), decimal_text(health.frame_ms) + " ms"},
      {ui.text("operate.health.late"), grouped(std::lround(health.late_us)) + " µs"},
      {ui.text("operate.health.missed"), grouped(health.missed_ticks)},
      {ui.text("operate.health.pauses"), grouped(health.pauses)},
      {ui.text("operate.health.rings"), grouped(std::lround(100.0 * health.ring_share)) + " %"},
      {ui.text("operate.health.log"),
       decimal_text(static_cast<double>(health.log_bytes) / bytes_per_megabyte) + " MB"},
      {ui.text("operate.health.triangles"), grouped(health.triangles)},
      {ui.text("operate.health.priority"), granted(health.has_priority)},
      {ui.text("operate.health.memory"), granted(health.has_locked_memory)}};
  if (health.arm) add_arm_rows(rows, ui, *health.arm);
  return rows;
}

/// How the rows of health lie: in low windows smaller, in as many columns as it takes.
struct HealthLook {
  Type name_type = Type::Small, value_type = Type::SmallMedium;
  float row = 24.0F, edge_x = hud_pad, edge_y = 12.0F, gap = 2.0F * hud_pad;
};
constexpr HealthLook low_health{Type::Caption, Type::CaptionMedium, 17.0F, 12.0F, 8.0F, 16.0F};

struct HealthColumns {
  std::size_t rows_each = 1, count = 1;
  /// Of a column: its widest name and value.
  float width = 0.0F;
};

HealthColumns columns_of(const Ui& ui, const std::vector<HealthRow>& rows, const HealthLook& look,
                         float height) {
  HealthColumns made;
  const float room = (height - 2.0F * look.edge_y) / look.row;
  const auto fitting = static_cast<std::size_t>(std::max(1.0F, room));
  made.count = (rows.size() + fitting - 1) / fitting;
  made.rows_each = (rows.size() + made.count - 1) / made.count;
  for (const HealthRow& row : rows) {
    made.width = std::max(made.width, ui.width_of(look.name_type, row.name) + 12.0F +
                                          ui.width_of(look.value_type, row.value));
  }
  return made;
}

float width_of(const HealthColumns& columns, const HealthLook& look) {
  const auto count = static_cast<float>(columns.count);
  return count * columns.width + (count - 1.0F) * look.gap + 2.0F * look.edge_x;
}

void draw_health_row(Hud& in, Rect line, const HealthRow& row, const HealthLook& look) {
  const float value = in.ui.width_of(look.value_type, row.value) + 1.0F;
  in.canvas().text_in(take_right(line, value, 8.0F),
                      {look.value_type, in.theme().text, Align::Right}, row.value);
  in.canvas().text_in(line, {look.name_type, in.theme().text_secondary}, row.name);
}

void draw_health(Hud& in, float y) {
  if (!in.hud.is_health_open) return;
  const std::vector<HealthRow> rows = health_rows(in.ui, in.hud.health);
  const float room = in.room.bottom() - y;
  HealthLook look;
  HealthColumns made = columns_of(in.ui, rows, look, room);
  if (width_of(made, look) > in.room.w) {
    look = low_health;
    made = columns_of(in.ui, rows, look, room);
  }
  const float width =
      std::clamp(width_of(made, look), std::min(health_width, in.room.w), in.room.w);
  const float height = look.row * static_cast<float>(made.rows_each) + 2.0F * look.edge_y;
  const Rect rect = in.sided({in.room.right() - width, y, width, height});
  const HudPanel panel(in, "operate.panel.health", rect);
  const std::vector<Rect> places =
      columns(inset(rect, look.edge_x, look.edge_y), static_cast<int>(made.count), look.gap);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Rect line = places[i / made.rows_each];
    line.y += look.row * static_cast<float>(i % made.rows_each);
    line.h = look.row;
    draw_health_row(in, line, rows[i], look);
  }
}

/// One line with what to do, only where something is wrong, above the lower panels; returns where
/// it begins.
float draw_trouble(Hud& in) {
  const float end = in.room.bottom() - hud_panel_height - 8.0F;
  if (in.hud.health.trouble.empty()) return end;
  const float width =
      std::min(in.room.w, in.ui.width_of(Type::Small, in.hud.health.trouble) + 56.0F);
  const float y = end - 36.0F;
  const Rect line{in.ui.display().mid_x() - 0.5F * width, y, width, 36.0F};
  const HudPanel panel(in, "operate.panel.trouble", line, 18.0F);
  draw_meaning(in.canvas(), in.theme(), Meaning::Warn, {line.x + 20.0F, line.mid_y()}, 6.0F);
  in.canvas().text_in({line.x + 36.0F, line.y, line.w - 52.0F, line.h},
                      {Type::Small, in.theme().text}, in.hud.health.trouble);
  return y;
}

/// The hints, in the middle and as wide as they may be, reach below the panels at the side.
bool is_hint_at_side(const Hud& in) {
  return 0.5F * (1.0F - widest_hint_share) * in.room.w < inset_width + 8.0F;
}

/// The section in the blade's plane, beside the picture and above low hints.
void draw_inset(Hud& in, float y, const std::vector<Rect>& low_hints) {
  if (in.hud.inset == nullptr || in.room.w < inset_least_room) return;
  const float height =
      std::min(inset_height, in.room.bottom() - hud_panel_height - 2.0F * hud_gap - y);
  Rect rect = in.sided({in.room.right() - inset_width, y, inset_width, height});
  for (const Rect& hint : low_hints) {
    if (!intersection(rect, hint).is_empty()) rect.h = hint.y - hud_gap - y;
  }
  if (rect.h < inset_least_height) return;
  const HudPanel panel(in, "operate.panel.inset", rect);
  const Rect title{rect.x + hud_pad, rect.y + 8.0F, rect.w - 2.0F * hud_pad, 20.0F};
  in.canvas().text_in(title, {Type::Small, in.theme().text_secondary},
                      in.ui.text("operate.panel.inset"));
  if (in.hud.inset->way)
    in.ui.tell("operate.inset", words_of(in.ui.texts(), *in.hud.inset->way), rect);
  draw_blade_section(in.ui, {rect.x + 8.0F, rect.y + 30.0F, rect.w - 16.0F, rect.h - 38.0F},
                     *in.hud.inset);
}

}  // namespace

std::string decimal_text(double value) { return fixed_text(value, 1); }

std::string signed_text(double value) {
  const double rounded = std::round(10.0 * value) / 10.0;
  if (rounded == 0.0) return "0.0";
  return (rounded < 0.0 ? "−" : "+") + fixed_text(std::abs(rounded), 1);
}

HudAnswer draw_operating_hud(Ui& ui, const OperatingHud& hud) {
  const Rect display = ui.display();
  const Rect room = inset(display, hud_inset_share * display.w, hud_inset_share * display.h);
  const HudFoot foot = lay_out_foot(ui, hud, room.w);
  Hud in{ui, hud, above_foot(room, display, foot), {}, ui.messages_at()};
  if (!hud.badge.is_empty()) in.panels.push_back(hud.badge);
  draw_tip_force(in);
  const float bar_end = draw_hud_lesson(in, draw_hud_bar(in));
  draw_hud_readings(in, std::max(bar_end + 8.0F, in.room.y + badge_room));
  const HintsPlace hints = draw_hud_hints(in, bar_end, draw_trouble(in));
  const float below = std::max(in.room.y + (hud.lesson ? lesson_room : badge_room),
                               hud.lesson || is_hint_at_side(in) ? hints.high_bottom + 8.0F : 0.0F);
  if (hud.is_health_open) {
    draw_health(in, below);
  } else {
    draw_inset(in, below, hints.low);
  }
  draw_hud_foot(in, foot);
  draw_tip_label(in);
  return in.answer;
}

}  // namespace hallux::ui
