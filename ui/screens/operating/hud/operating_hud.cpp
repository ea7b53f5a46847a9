// Panels over the picture, each a function of the facts. They lie at the edges and leave the middle
// to the bone; what does not fit goes in an order that keeps force and state to the last. Over a
// panel a free pointer is a pointer, so each panel is an area of its own. Colours have a shape
// beside them.
#include "ui/screens/operating/hud/operating_hud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ui/screens/operating/hud/hud_bar.h"
#include "ui/screens/operating/hud/hud_hints.h"
#include "ui/screens/operating/hud/hud_lesson.h"
#include "ui/screens/operating/hud/hud_readings.h"
#include "ui/screens/operating/hud/hud_tip.h"
#include "ui/screens/pictures/blade_section_view.h"

namespace hallux::ui {

namespace {

/// Down to the panels at the side: of the person's name, or of a lesson with one line of hints.
constexpr float badge_room = 112.0F, lesson_room = 204.0F;
constexpr float health_width = 280.0F, health_row = 24.0F, health_edge = 12.0F;
constexpr float inset_width = 300.0F, inset_height = 236.0F, inset_least_room = 560.0F;

std::string text_of(const char* format, double value) {
  std::array<char, 32> letters{};
  static_cast<void>(std::snprintf(letters.data(), letters.size(), format, value));
  return letters.data();
}

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

/// One column, or as many as the window is too low for.
void draw_health(Hud& in, float y) {
  if (!in.hud.is_health_open) return;
  const std::vector<HealthRow> rows = health_rows(in.ui, in.hud.health);
  const float room = in.room.bottom() - y - 2.0F * health_edge;
  const auto fitting = static_cast<std::size_t>(std::max(1.0F, room / health_row));
  const std::size_t column_count = (rows.size() + fitting - 1) / fitting;
  const std::size_t per_column = (rows.size() + column_count - 1) / column_count;
  const float width = std::min(in.room.w, health_width * static_cast<float>(column_count));
  const Rect rect{in.room.right() - width, y, width,
                  health_row * static_cast<float>(per_column) + 2.0F * health_edge};
  const HudPanel panel(in, "operate.panel.health", rect);
  const std::vector<Rect> places =
      columns(inset(rect, hud_pad, health_edge), static_cast<int>(column_count), 2.0F * hud_pad);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Rect line = places[i / per_column];
    line.y += health_row * static_cast<float>(i % per_column);
    line.h = health_row;
    const float value = in.ui.width_of(Type::SmallMedium, rows[i].value) + 1.0F;
    in.canvas().text_in(take_right(line, value, 8.0F),
                        {Type::SmallMedium, in.theme().text, Align::Right}, rows[i].value);
    in.canvas().text_in(line, {Type::Small, in.theme().text_secondary}, rows[i].name, true);
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
                      {Type::Small, in.theme().text}, in.hud.health.trouble, true);
  return y;
}

/// The section in the blade's plane, beside the picture.
void draw_inset(Hud& in, float y) {
  if (in.hud.inset == nullptr || in.room.w < inset_least_room) return;
  const float height =
      std::min(inset_height, in.room.bottom() - hud_panel_height - 2.0F * hud_gap - y);
  if (height < 0.5F * inset_height) return;
  const Rect rect = in.sided({in.room.right() - inset_width, y, inset_width, height});
  const HudPanel panel(in, "operate.panel.inset", rect);
  const Rect title{rect.x + hud_pad, rect.y + 8.0F, rect.w - 2.0F * hud_pad, 20.0F};
  in.canvas().text_in(title, {Type::Small, in.theme().text_secondary},
                      in.ui.text("operate.panel.inset"), true);
  if (in.hud.inset->way)
    in.ui.tell("operate.inset", words_of(in.ui.texts(), *in.hud.inset->way), rect);
  draw_blade_section(in.ui, {rect.x + 8.0F, rect.y + 30.0F, rect.w - 16.0F, rect.h - 38.0F},
                     *in.hud.inset);
}

}  // namespace

std::string decimal_text(double value) { return text_of("%.1f", value); }

std::string signed_text(double value) {
  const double rounded = std::round(10.0 * value) / 10.0;
  if (rounded == 0.0) return "0.0";
  return (rounded < 0.0 ? "−" : "+") + text_of("%.1f", std::abs(rounded));
}

HudAnswer draw_operating_hud(Ui& ui, const OperatingHud& hud) {
  const Rect display = ui.display();
  Hud in{ui, hud, inset(display, hud_inset_share * display.w, hud_inset_share * display.h), {}};
  draw_tip_force(in);
  const float bar_end = draw_hud_lesson(in, draw_hud_bar(in));
  draw_hud_readings(in);
  const float hints_end = draw_hud_hints(in, bar_end, draw_trouble(in));
  const float below =
      hud.lesson ? std::max(in.room.y + lesson_room, hints_end + 8.0F) : in.room.y + badge_room;
  if (hud.is_health_open) {
    draw_health(in, below);
  } else {
    draw_inset(in, below);
  }
  draw_hud_foot(in);
  draw_tip_label(in);
  return in.answer;
}

}  // namespace hallux::ui
