// Panels over the picture, each a function of the facts. They lie at the edges and leave the middle
// to the bone; what does not fit goes in an order that keeps force and state to the last. Over a
// panel the pointer is a pointer, so each panel is an area of its own. Colours have a shape beside
// them.
#include "ui/screens/operating/operating_hud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "simulator/base/units.h"
#include "simulator/contact/heat_law.h"
#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

constexpr float bar_height = 44.0F, panel_height = 92.0F, gap = 16.0F;
constexpr float pad = 20.0F, badge_room = 112.0F;
constexpr float health_width = 280.0F, health_row = 24.0F, health_edge = 12.0F;
/// Bands that colour the force; source  docs/haptics.md (usual pushes are 8 to 20 N), not
/// surgeon-reviewed
constexpr double high_force_newton = 15.0, force_scale_newton = 30.0;
constexpr double reading_scale_degree = 8.0, reading_band_degree = 2.0;
constexpr double distance_scale_mm = 4.0, distance_band_mm = 0.5;

std::string text_of(const char* format, double value) {
  std::array<char, 32> letters{};
  static_cast<void>(std::snprintf(letters.data(), letters.size(), format, value));
  return letters.data();
}

struct Hud {
  Ui& ui;
  const OperatingHud& hud;
  Rect room;  ///< inside the inset
  HudAnswer answer;

  const Theme& theme() const { return ui.theme(); }
  Canvas& canvas() const { return ui.canvas(); }
  /// Over it the pointer is a pointer: the saw stays where it is. `name` is a text of the
  /// catalogue.
  void panel(const char* name, const Rect& rect, float corner = radius::picture) const {
    ui.area(name, ui.text(name), rect);
    draw_hud_panel(canvas(), theme(), rect, corner);
  }
};

/// Mode and time, upper left.
float draw_mode(Hud& in) {
  const std::string_view mode =
      in.ui.text(in.hud.is_practice ? "operate.practice" : "operate.assessment");
  const std::string time = clock_text(static_cast<double>(in.hud.tick) / 1000.0);
  const float mode_width = in.ui.width_of(Type::SmallMedium, mode) + 32.0F;
  const float time_width = in.ui.width_of(Type::BodyStrong, "00:00");
  const Rect bar{in.room.x, in.room.y, 6.0F + mode_width + 40.0F + time_width + pad, bar_height};
  in.panel("operate.panel.mode", bar, bar_height / 2.0F);
  const Rect chip{bar.x + 6.0F, bar.y + 6.0F, mode_width, bar_height - 12.0F};
  in.canvas().fill(chip, in.theme().chip, chip.h / 2.0F);
  in.canvas().text_in(chip, {Type::SmallMedium, in.theme().text, Align::Centre}, mode);
  in.canvas().icon({chip.right() + 20.0F, bar.mid_y()}, Icon::Clock, IconSize::Inline,
                   in.theme().text_caption);
  in.canvas().text({chip.right() + 38.0F, bar.mid_y()}, {Type::BodyStrong, in.theme().text}, time);
  return bar.w;
}

/// Health, finish, abandon and pause, upper right.
float draw_state(Hud& in) {
  const bool is_well = in.hud.health.trouble.empty();
  const std::string_view rate = in.ui.text("operate.health.rate");
  const std::string_view recording = in.ui.text("operate.recording");
  const float rate_width = in.ui.width_of(Type::Small, rate);
  const float recording_width = in.ui.width_of(Type::Small, recording);
  const float width = 40.0F + rate_width + 34.0F + recording_width + 16.0F + 4.0F * 38.0F + 8.0F;
  const Rect bar{in.room.right() - width, in.room.y, width, bar_height};
  in.panel("operate.panel.state", bar, bar_height / 2.0F);
  draw_meaning(in.canvas(), in.theme(), is_well ? Meaning::Good : Meaning::Warn,
               {bar.x + 24.0F, bar.mid_y()}, 6.0F);
  in.canvas().text({bar.x + 38.0F, bar.mid_y()}, {Type::Small, in.theme().text}, rate);
  const float next = bar.x + 38.0F + rate_width + 24.0F;
  in.canvas().disc({next, bar.mid_y()}, 5.0F,
                   in.hud.is_paused ? in.theme().text_caption : in.theme().bad);
  in.canvas().text({next + 12.0F, bar.mid_y()}, {Type::Small, in.theme().text}, recording);
  float x = bar.right() - 4.0F * 38.0F - 8.0F;
  const auto press = [&](const char* id, const char* label, Icon icon, bool is_on = false) {
    const Rect place{x, bar.y + 4.0F, 36.0F, 36.0F};
    x += 38.0F;
    return icon_button(in.ui, id, place, {in.ui.text(label), icon, is_on});
  };
  in.answer.health = press("operate.health", "operate.health", Icon::Live, in.hud.is_health_open);
  in.answer.pause = press("operate.pause", in.hud.is_paused ? "operate.resume" : "operate.pause",
                          in.hud.is_paused ? Icon::Play : Icon::Pause);
  in.answer.finish = press("operate.finish", "operate.finish", Icon::Check);
  in.answer.abandon = press("operate.abandon", "operate.abandon", Icon::Close);
  return bar.w;
}

/// A step as disc and number, the one at hand with its title. Returns the width.
float draw_step(Hud& in, Point at, std::size_t step, bool has_title) {
  const bool is_done = step < in.hud.step, is_now = step == in.hud.step;
  Canvas& canvas = in.canvas();
  const std::string number = std::to_string(step + 1);
  const Point centre{at.x + 16.0F, at.y};
  float width = 32.0F;
  if (is_now && has_title) {
    const float title = in.ui.width_of(Type::BodyStrong, in.hud.steps[step]);
    width = 32.0F + title + 18.0F;
    canvas.fill({at.x, at.y - 16.0F, width, 32.0F}, in.theme().accent, 16.0F);
    canvas.text({at.x + 32.0F, at.y}, {Type::BodyStrong, in.theme().on_accent}, in.hud.steps[step]);
  }
  if (is_done) {
    draw_meaning(canvas, in.theme(), Meaning::Good, centre, 8.0F);
    return width;
  }
  if (is_now) {
    canvas.disc(centre, 9.0F, has_title ? in.theme().on_accent : in.theme().accent);
  } else {
    canvas.ring(centre, 9.0F, in.theme().text_caption);
  }
  const Color ink = !is_now     ? in.theme().text_secondary
                    : has_title ? in.theme().accent
                                : in.theme().on_accent;
  canvas.text_in({centre.x - 10.0F, centre.y - 9.0F, 20.0F, 18.0F},
                 {Type::CaptionMedium, ink, Align::Centre}, number);
  return width;
}

/// The steps between mode and state, or below them where there is no room; with the button of the
/// step at hand.
void draw_steps(Hud& in, float left_used, float right_used) {
  if (in.hud.steps.empty()) return;
  ButtonSpec done{in.hud.step_action, ButtonLook::Primary, Icon::None, in.hud.is_step_ready};
  done.is_busy = in.hud.is_step_busy;
  const std::string_view chip = in.ui.text("key.enter");
  const float button_w = done.label.empty() ? 0.0F : button_width(in.ui, done) + 12.0F;
  const float chip_w = done.label.empty() ? 0.0F : key_chip_width(in.ui, chip) + 12.0F;
  const std::string& title = in.hud.steps[std::min(in.hud.step, in.hud.steps.size() - 1)];
  const float discs = 32.0F * static_cast<float>(in.hud.steps.size());
  float width = 16.0F + discs + in.ui.width_of(Type::BodyStrong, title) + 18.0F + button_w + chip_w;
  bool has_title = true;
  const float between = in.room.w - left_used - right_used - 2.0F * gap;
  const bool is_below = width > between;
  if (width > in.room.w) {
    has_title = false;
    width = 16.0F + discs + button_w + chip_w;
  }
  const float y = is_below ? in.room.y + bar_height + 8.0F : in.room.y;
  const float middle =
      is_below ? in.ui.display().mid_x() : in.room.x + left_used + gap + 0.5F * between;
  const float wished = in.ui.display().mid_x() - 0.5F * width;
  float x = middle - 0.5F * width;
  if (!is_below && wished >= in.room.x + left_used + gap &&
      wished + width <= in.room.right() - right_used - gap) {
    x = wished;
  }
  const Rect bar{x, y, width, bar_height};
  in.panel("operate.panel.steps", bar, bar_height / 2.0F);
  float at = bar.x + 8.0F;
  for (std::size_t step = 0; step < in.hud.steps.size(); ++step) {
    at += draw_step(in, {at, bar.mid_y()}, step, has_title);
  }
  if (done.label.empty()) return;
  at += 8.0F;
  key_chip(in.ui, {at, bar.mid_y()}, chip);
  const Rect place{at + chip_w - 4.0F, bar.y + 5.0F, button_w - 12.0F, bar_height - 10.0F};
  in.answer.step = button(in.ui, "operate.step", place, done);
}

/// The hottest bone at the right of the line, with a sign from where bone suffers. Returns the
/// width that it takes.
float draw_heat(Hud& in, const Rect& line) {
  if (!in.hud.bone_celsius) return 0.0F;
  const bool is_hot = *in.hud.bone_celsius > simulator::hot_celsius;
  const std::string words =
      in.ui.texts().say("operate.bone_heat", {{"celsius", text_of("%.0f", *in.hud.bone_celsius)}});
  const float words_w = in.ui.width_of(Type::Small, words);
  in.canvas().text({line.right() - words_w, line.mid_y()},
                   {Type::Small, is_hot ? in.theme().warn_text : in.theme().text_secondary}, words);
  if (!is_hot) return words_w + 12.0F;
  draw_meaning(in.canvas(), in.theme(), Meaning::Warn,
               {line.right() - words_w - 12.0F, line.mid_y()}, 5.5F);
  return words_w + 30.0F;
}

void draw_tool(Hud& in, const Rect& rect) {
  in.panel("operate.panel.tool", rect);
  Canvas& canvas = in.canvas();
  const Rect inner = inset(rect, pad, 0.0F);
  const std::string_view key = in.ui.text("key.space");
  const std::string_view act =
      in.ui.text(in.hud.is_saw_on ? "operate.saw.stop" : "operate.saw.start");
  const float chip = key_chip_width(in.ui, key);
  canvas.text_in({inner.x, rect.y + 12.0F, inner.w - chip - 60.0F, 22.0F},
                 {Type::BodyStrong, in.theme().text}, in.ui.text("operate.saw"), true);
  key_chip(in.ui, {inner.right() - chip, rect.y + 23.0F}, key);
  canvas.text_in({inner.right() - chip - 70.0F, rect.y + 13.0F, 62.0F, 20.0F},
                 {Type::Small, in.theme().text_caption, Align::Right}, act);
  const std::string blade = in.ui.texts().say(
      "operate.blade", {{"width", text_of("%.4g", in.hud.saw.blade.width_mm)},
                        {"thickness", text_of("%.2f", in.hud.saw.blade.thickness_mm)}});
  const float heat_w = draw_heat(in, {inner.x, rect.y + 35.0F, inner.w, 20.0F});
  canvas.text_in({inner.x, rect.y + 35.0F, inner.w - heat_w, 20.0F},
                 {Type::Small, in.theme().text_secondary}, blade, true);
  const float y = rect.bottom() - 20.0F;
  canvas.disc({inner.x + 5.0F, y}, 5.0F,
              in.hud.is_saw_on ? in.theme().good : in.theme().text_caption);
  const std::string runs =
      in.hud.is_saw_on
          ? in.ui.texts().say("operate.saw.runs",
                              {{"rate", grouped(std::lround(in.hud.saw.cycles_per_minute))}})
          : std::string(in.ui.text("operate.saw.still"));
  canvas.text({inner.x + 18.0F, y}, {Type::Small, in.theme().text}, runs);
  const std::string_view water = in.ui.text("operate.irrigation");
  const float water_w = in.ui.width_of(Type::Small, water);
  canvas.icon({inner.right() - water_w - 14.0F, y}, Icon::Irrigation, IconSize::Inline,
              in.hud.is_irrigated ? in.theme().accent : in.theme().text_caption);
  canvas.text({inner.right() - water_w, y},
              {Type::Small, in.hud.is_irrigated ? in.theme().text : in.theme().text_caption},
              water);
}

struct Level {
  std::string_view name;
  std::string value;
  double share = 0.0;  ///< of the scale, -1 to 1
  double band = 0.0;   ///< of the scale: within it all is well
};

void draw_level(Hud& in, const Rect& rect, const Level& level) {
  Canvas& canvas = in.canvas();
  const bool is_well = std::abs(level.share) <= level.band;
  const float value_w = in.ui.width_of(Type::BodyStrong, level.value);
  canvas.text_in({rect.x, rect.y, rect.w - value_w - 24.0F, 22.0F},
                 {Type::Small, in.theme().text_secondary}, level.name, true);
  draw_meaning(canvas, in.theme(), is_well ? Meaning::Good : Meaning::Warn,
               {rect.right() - value_w - 12.0F, rect.y + 11.0F}, 5.5F);
  canvas.text_in({rect.right() - value_w, rect.y, value_w + 1.0F, 22.0F},
                 {Type::BodyStrong, in.theme().text}, level.value);
  const Rect track{rect.x, rect.y + 36.0F, rect.w, 8.0F};
  canvas.fill(track, in.theme().chip, 4.0F);
  const float half = 0.5F * track.w;
  const float band = half * static_cast<float>(level.band);
  canvas.fill({track.mid_x() - band, track.y, 2.0F * band, track.h}, in.theme().good, 2.0F);
  const float at = half * static_cast<float>(std::clamp(level.share, -1.0, 1.0));
  canvas.fill({track.mid_x() + at - 2.0F, track.y - 5.0F, 4.0F, track.h + 10.0F}, in.theme().text,
              2.0F);
}

void draw_reading(Hud& in, const Rect& rect) {
  in.panel("operate.panel.plan", rect);
  const PlanReading& reading = *in.hud.reading;
  const auto angle = [&](const char* id, double rad) {
    const double degree = degree_from_radian(rad);
    return Level{in.ui.text(id), signed_text(degree) + "°", degree / reading_scale_degree,
                 reading_band_degree / reading_scale_degree};
  };
  const std::array<Level, 3> levels{
      angle("operate.plan.pitch", reading.pitch_rad), angle("operate.plan.roll", reading.roll_rad),
      Level{in.ui.text("operate.plan.distance"), signed_text(reading.distance_mm) + " mm",
            reading.distance_mm / distance_scale_mm, distance_band_mm / distance_scale_mm}};
  const std::vector<Rect> places = columns(inset(rect, pad, 16.0F), 3, 20.0F);
  for (std::size_t i = 0; i < levels.size(); ++i) draw_level(in, places[i], levels[i]);
}

void draw_force(Hud& in, const Rect& rect) {
  in.panel("operate.panel.force", rect);
  Canvas& canvas = in.canvas();
  const Rect inner = inset(rect, pad, 0.0F);
  const bool is_high = in.hud.force_newton > high_force_newton;
  canvas.text_in({inner.x, rect.y + 12.0F, inner.w - 130.0F, 22.0F},
                 {Type::Small, in.theme().text_secondary}, in.ui.text("operate.force"), true);
  const std::string limit = in.ui.texts().say("operate.force.keep", {{"limit", "15"}});
  canvas.text_in({inner.right() - 130.0F, rect.y + 12.0F, 130.0F, 22.0F},
                 {Type::Small, is_high ? in.theme().warn_text : in.theme().text, Align::Right},
                 limit);
  const std::string value = decimal_text(in.hud.force_newton);
  const float y = rect.bottom() - 32.0F;
  canvas.text({inner.x, y}, {Type::Number, in.theme().text}, value);
  canvas.text({inner.x + in.ui.width_of(Type::Number, value) + 6.0F, y + 5.0F},
              {Type::Small, in.theme().text_caption}, "N");
  const Rect track{inner.x + 96.0F, rect.bottom() - 40.0F, inner.w - 96.0F, 8.0F};
  const auto place = [&](double newton) {
    return track.w * static_cast<float>(std::clamp(newton / force_scale_newton, 0.0, 1.0));
  };
  bar(in.ui, track, place(in.hud.force_newton) / track.w,
      is_high ? in.theme().warn : in.theme().accent);
  canvas.fill({track.x + place(high_force_newton) - 1.0F, track.y - 5.0F, 2.0F, 18.0F},
              in.theme().text);
  const float scale_y = rect.bottom() - 16.0F;
  const TextStyle caption{Type::Caption, in.theme().text_caption};
  canvas.text({track.x, scale_y}, caption, "0");
  canvas.text_in({track.x + place(high_force_newton) - 20.0F, scale_y - 9.0F, 40.0F, 18.0F},
                 {Type::Caption, in.theme().text_caption, Align::Centre}, "15");
  canvas.text_in({track.right() - 60.0F, scale_y - 9.0F, 60.0F, 18.0F},
                 {Type::Caption, in.theme().text_caption, Align::Right}, "30 N");
}

/// The push as a bar beside the teeth, where the eyes are.
void draw_force_at_blade(Hud& in) {
  if (!in.hud.tip || in.hud.force_newton < 0.2) return;
  const Rect track{in.hud.tip->x - 76.0F, in.hud.tip->y - 40.0F, 8.0F, 80.0F};
  if (!in.room.encloses(track)) return;
  Canvas& canvas = in.canvas();
  canvas.line({track.right() + 4.0F, track.mid_y()}, {in.hud.tip->x - 14.0F, in.hud.tip->y},
              faded(in.theme().text, 0.5F), 1.5F);
  canvas.fill(inset(track, -3.0F, -3.0F), in.theme().hud, 7.0F);
  canvas.fill(track, in.theme().chip, 4.0F);
  const double share = std::clamp(in.hud.force_newton / force_scale_newton, 0.0, 1.0);
  const float height = std::max(4.0F, track.h * static_cast<float>(share));
  const bool is_high = in.hud.force_newton > high_force_newton;
  canvas.fill({track.x, track.bottom() - height, track.w, height},
              is_high ? in.theme().warn : in.theme().accent, 4.0F);
  const float mark =
      track.bottom() - track.h * static_cast<float>(high_force_newton / force_scale_newton);
  canvas.fill({track.x - 4.0F, mark - 1.0F, 16.0F, 2.0F}, in.theme().text);
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
  in.panel("operate.panel.health", rect);
  const std::vector<Rect> places =
      columns(inset(rect, pad, health_edge), static_cast<int>(column_count), 2.0F * pad);
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

/// One line with what to do, only where something is wrong.
void draw_trouble(Hud& in) {
  if (in.hud.health.trouble.empty()) return;
  const float width =
      std::min(in.room.w, in.ui.width_of(Type::Small, in.hud.health.trouble) + 56.0F);
  const float y = in.room.bottom() - panel_height - 8.0F - 36.0F;
  const Rect line{in.ui.display().mid_x() - 0.5F * width, y, width, 36.0F};
  in.panel("operate.panel.trouble", line, 18.0F);
  draw_meaning(in.canvas(), in.theme(), Meaning::Warn, {line.x + 20.0F, line.mid_y()}, 6.0F);
  in.canvas().text_in({line.x + 36.0F, line.y, line.w - 52.0F, line.h},
                      {Type::Small, in.theme().text}, in.hud.health.trouble, true);
}

/// What the version is worth, where everybody sees it.
void draw_standing(Hud& in) {
  const char* id = in.hud.is_simulated  ? "operate.simulated"
                   : in.hud.is_reviewed ? nullptr
                                        : "operate.not_reviewed";
  if (id == nullptr) return;
  const std::string_view words = in.ui.text(id);
  in.canvas().text_in({in.room.x, in.room.bottom() + 6.0F, in.room.w, 20.0F},
                      {Type::Caption, in.theme().text_caption, Align::Centre}, words);
}

void draw_panels(Hud& in) {
  const float y = in.room.bottom() - panel_height;
  const float force_w = std::min(316.0F, in.room.w);
  draw_force(in, {in.room.right() - force_w, y, force_w, panel_height});
  float left = in.room.w - force_w - gap;
  if (left < 300.0F) return;
  const float tool_w = std::min(316.0F, left);
  draw_tool(in, {in.room.x, y, tool_w, panel_height});
  left -= tool_w + gap;
  if (!in.hud.reading || left < 400.0F) return;
  const float reading_w = std::min(520.0F, left);
  const float middle = 0.5F * (in.room.x + tool_w + in.room.right() - force_w);
  draw_reading(in, {middle - 0.5F * reading_w, y, reading_w, panel_height});
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
  draw_force_at_blade(in);
  const float left = draw_mode(in), right = draw_state(in);
  draw_steps(in, left, right);
  draw_panels(in);
  draw_health(in, in.room.y + badge_room);
  draw_trouble(in);
  draw_standing(in);
  return in.answer;
}

}  // namespace hallux::ui
