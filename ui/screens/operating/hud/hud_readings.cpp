// Tool, plan and force at the foot of the picture. The bands are the rubric's: the track of a value
// ends where no points are left, green is where all of them are, and the sign beside the number has
// a shape for each of the three.
#include "ui/screens/operating/hud/hud_readings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "simulator/base/units.h"
#include "simulator/contact/heat_law.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/marks.h"

namespace hallux::ui {

namespace {

/// Bands that colour the force; source  docs/haptics.md (usual pushes are 8 to 20 N), not
/// surgeon-reviewed
constexpr double high_force_newton = 15.0, force_scale_newton = 30.0;
/// Of a track without a band.
constexpr double angle_scale_deg = 8.0, distance_scale_mm = 4.0, along_scale_mm = 8.0;
constexpr float side_panel_width = 284.0F;

std::string text_of(const char* format, double value) {
  std::array<char, 32> letters{};
  static_cast<void>(std::snprintf(letters.data(), letters.size(), format, value));
  return letters.data();
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
  in.ui.tell("operate.heat", words, line);
  if (!is_hot) return words_w + 12.0F;
  draw_meaning(in.canvas(), in.theme(), Meaning::Warn,
               {line.right() - words_w - 12.0F, line.mid_y()}, 5.5F);
  return words_w + 30.0F;
}

/// A switch of the saw: a small button at the right end of a line, with its key. Returns the width.
float draw_switch(Hud& in, const char* id, Point right_middle, const char* label, const char* key,
                  bool& is_pressed) {
  const std::string_view chip = in.ui.text(key);
  const ButtonSpec spec{in.ui.text(label), ButtonLook::Ghost};
  const float chip_w = key_chip_width(in.ui, chip);
  const float width = in.ui.width_of(Type::BodyMedium, spec.label) + 20.0F;
  key_chip(in.ui, {right_middle.x - chip_w, right_middle.y}, chip);
  const Rect place{right_middle.x - chip_w - width - 2.0F, right_middle.y - 14.0F, width, 28.0F};
  is_pressed = button(in.ui, id, place, spec);
  return chip_w + width + 8.0F;
}

void draw_tool(Hud& in, const Rect& rect) {
  const HudPanel panel(in, "operate.panel.tool", rect);
  Canvas& canvas = in.canvas();
  const Rect inner = inset(rect, hud_pad, 0.0F);
  const float saw_w = draw_switch(in, "operate.saw", {inner.right(), rect.y + 23.0F},
                                  in.hud.is_saw_on ? "operate.saw.stop" : "operate.saw.start",
                                  "key.space", in.answer.saw);
  canvas.text_in({inner.x, rect.y + 12.0F, inner.w - saw_w, 22.0F},
                 {Type::BodyStrong, in.theme().text}, in.ui.text("operate.saw"), true);
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
          : in.text("operate.saw.still");
  const float water_w =
      draw_switch(in, "operate.irrigation", {inner.right(), y},
                  in.hud.is_irrigated ? "operate.irrigation.on" : "operate.irrigation.off", "key.i",
                  in.answer.irrigation);
  canvas.text_in({inner.x + 18.0F, y - 10.0F, inner.w - 18.0F - water_w, 20.0F},
                 {Type::Small, in.theme().text}, runs, true);
  in.ui.tell("operate.saw.state", runs, rect);
}

/// A value on a track that ends where no points are left.
struct Level {
  const char* id = "";
  std::string_view name;
  std::string value;
  /// Of the track, -1 to 1.
  double share = 0.0;
  /// Of the track: within it all points are there; 0: no band.
  double full_share = 0.0;
  std::optional<BandState> state;
  std::string caption;
};

Meaning meaning_of(BandState state) {
  return state == BandState::Full      ? Meaning::Good
         : state == BandState::Partial ? Meaning::Warn
                                       : Meaning::Bad;
}

void draw_track(Hud& in, const Rect& track, const Level& level) {
  Canvas& canvas = in.canvas();
  const float half = 0.5F * track.w;
  const bool has_band = level.full_share > 0.0;
  canvas.fill(track, has_band ? faded(in.theme().warn, 0.35F) : in.theme().chip, 4.0F);
  const float band = half * static_cast<float>(level.full_share);
  if (has_band)
    canvas.fill({track.mid_x() - band, track.y, 2.0F * band, track.h}, in.theme().good, 2.0F);
  const float at = half * static_cast<float>(std::clamp(level.share, -1.0, 1.0));
  canvas.fill({track.mid_x() + at - 2.0F, track.y - 5.0F, 4.0F, track.h + 10.0F}, in.theme().text,
              2.0F);
}

void draw_level(Hud& in, const Rect& rect, const Level& level) {
  Canvas& canvas = in.canvas();
  const float value_w = in.ui.width_of(Type::BodyStrong, level.value);
  const float mark_w = level.state ? 18.0F : 0.0F;
  canvas.text_in({rect.x, rect.y, rect.w - value_w - mark_w - 6.0F, 22.0F},
                 {Type::Small, in.theme().text_secondary}, level.name, true);
  if (level.state) {
    draw_meaning(canvas, in.theme(), meaning_of(*level.state),
                 {rect.right() - value_w - 12.0F, rect.y + 11.0F}, 5.5F);
  }
  canvas.text_in({rect.right() - value_w, rect.y, value_w + 1.0F, 22.0F},
                 {Type::BodyStrong, in.theme().text}, level.value);
  draw_track(in, {rect.x, rect.y + 30.0F, rect.w, 8.0F}, level);
  canvas.text_in({rect.x, rect.y + 44.0F, rect.w, 18.0F}, {Type::Caption, in.theme().text_caption},
                 level.caption, true);
  std::string told = std::string(level.name) + " " + level.value;
  if (!level.caption.empty()) told += " (" + level.caption + ")";
  in.ui.tell(std::string("operate.") + level.id, told, rect);
}

std::string band_text(const Hud& in, const std::optional<LiveBand>& band, const char* unit) {
  if (!band) return {};
  return in.ui.texts().say("operate.band", {{"full", text_of("%.3g", band->full)},
                                            {"zero", text_of("%.3g", band->zero) + unit}});
}

/// Both tilts are green where the angle of the two together is.
Level angle_level(const Hud& in, const char* id, const char* name, double rad) {
  const HudPlan& plan = *in.hud.plan;
  const double degree = degree_from_radian(rad), all = degree_from_radian(plan.blade.angle_rad);
  Level level{id, in.ui.text(name), signed_text(degree) + "°", degree / angle_scale_deg, 0.0, {},
              {}};
  if (const auto& band = plan.bands.angle_deg) {
    level.share = degree / band->zero;
    level.full_share = band->full / band->zero;
    level.state = state_in(*band, all);
  }
  return level;
}

std::vector<Level> levels_of(const Hud& in) {
  const HudPlan& plan = *in.hud.plan;
  std::vector<Level> levels{
      angle_level(in, "plan.pitch", "operate.plan.pitch", plan.blade.pitch_rad),
      angle_level(in, "plan.roll", "operate.plan.roll", plan.blade.roll_rad)};
  levels[0].caption = band_text(in, plan.bands.angle_deg, "°");
  levels[1].caption =
      in.ui.texts().say("operate.plan.angle",
                        {{"angle", decimal_text(degree_from_radian(plan.blade.angle_rad)) + "°"}});
  Level distance{"plan.distance",
                 in.ui.text("operate.plan.distance"),
                 signed_text(plan.blade.distance_mm) + " mm",
                 plan.blade.distance_mm / distance_scale_mm,
                 0.0,
                 {},
                 band_text(in, plan.bands.location_mm, " mm")};
  if (const auto& band = plan.bands.location_mm) {
    distance.share = plan.blade.distance_mm / band->zero;
    distance.full_share = band->full / band->zero;
    distance.state = state_in(*band, plan.blade.distance_mm);
  }
  levels.push_back(distance);
  levels.push_back(
      {"plan.along",
       in.ui.text("operate.plan.along"),
       signed_text(plan.pass.along_mm) + " mm",
       plan.pass.along_mm / along_scale_mm,
       0.0,
       {},
       in.ui.texts().say("operate.plan.pass", {{"pass", std::to_string(plan.pass.pass + 1)},
                                               {"count", std::to_string(plan.pass.count)}})});
  return levels;
}

void draw_plan(Hud& in, const Rect& rect) {
  const HudPanel panel(in, "operate.panel.plan", rect);
  const std::vector<Level> levels = levels_of(in);
  const std::vector<Rect> places =
      columns(inset(rect, hud_pad, 12.0F), static_cast<int>(levels.size()), 18.0F);
  for (std::size_t i = 0; i < levels.size(); ++i) draw_level(in, places[i], levels[i]);
}

void draw_force(Hud& in, const Rect& rect) {
  const HudPanel panel(in, "operate.panel.force", rect);
  Canvas& canvas = in.canvas();
  const Rect inner = inset(rect, hud_pad, 0.0F);
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
  in.ui.tell("operate.force", in.text("operate.force") + " " + value + " N", rect);
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

}  // namespace

void draw_hud_readings(Hud& in) {
  const float y = in.room.bottom() - hud_panel_height;
  const float force_w = std::min(side_panel_width, in.room.w);
  draw_force(in, in.sided({in.room.right() - force_w, y, force_w, hud_panel_height}));
  float left = in.room.w - force_w - hud_gap;
  if (left < 300.0F) return;
  const float tool_w = std::min(side_panel_width, left);
  draw_tool(in, in.sided({in.room.x, y, tool_w, hud_panel_height}));
  left -= tool_w + hud_gap;
  if (!in.hud.plan || left < 400.0F) return;
  const float plan_w = std::min(700.0F, left);
  const float middle = 0.5F * (in.room.x + tool_w + in.room.right() - force_w);
  draw_plan(in, in.sided({middle - 0.5F * plan_w, y, plan_w, hud_panel_height}));
}

}  // namespace hallux::ui
