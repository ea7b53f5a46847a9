// The blade against the plan. A value that the rubric scores has a sign: a shape for full points,
// for some and for none; its track ends where none are left, and the green part, the sign and the
// marker on it say the same. Of the angle the rubric scores the whole, so its two parts are numbers
// to turn by and have no sign of their own.
#include "ui/screens/operating/hud/hud_plan.h"

#include <array>
#include <cmath>
#include <optional>

#include "simulator/base/units.h"
#include "ui/widgets/texts/number_text.h"

namespace hallux::ui {

namespace {

/// Of a track without a band.
constexpr double angle_scale_deg = 8.0, distance_scale_mm = 4.0, along_scale_mm = 8.0;
constexpr float column_gap = 16.0F, sign_width = 18.0F, name_gap = 8.0F;
constexpr float row_height = 22.0F, compact_row = 20.0F, compact_edge_x = 14.0F,
                compact_edge_y = 7.0F;
/// Digits are all as wide: no value is wider.
constexpr std::string_view widest_deg = "−88.8°", widest_mm = "−88.8 mm";

/// A value, as wide as it ever is.
struct Value {
  const char* id = "";
  std::string_view name;
  std::string text;
  std::string_view widest;
  std::optional<BandState> state;
};

/// Where it stands on a track that ends where no points are left.
struct Track {
  /// -1 to 1; from the left end where it has no direction.
  double share = 0.0;
  /// Within it all points are there; 0: no band.
  double full_share = 0.0;
  bool has_direction = true;
  std::string caption;
};

struct Level {
  Value value;
  Track track;
};

Meaning meaning_of(BandState state) {
  return state == BandState::Full      ? Meaning::Good
         : state == BandState::Partial ? Meaning::Warn
                                       : Meaning::Bad;
}

const char* words_of(BandState state) {
  return state == BandState::Full      ? "operate.band.all"
         : state == BandState::Partial ? "operate.band.some"
                                       : "operate.band.none";
}

std::string band_text(const Hud& in, const LiveBand& band, const char* unit) {
  return in.ui.texts().say(
      "operate.band", {{"full", short_text(band.full)}, {"zero", short_text(band.zero) + unit}});
}

void set_band(Level& level, const std::optional<LiveBand>& band, double value) {
  if (!band) return;
  level.track.share = value / band->zero;
  level.track.full_share = band->full / band->zero;
  level.value.state = state_in(*band, value);
}

// -- the values

Value tilt(const Hud& in, const char* id, const char* name, double rad) {
  return {id, in.ui.text(name), signed_text(degree_from_radian(rad)) + "°", widest_deg, {}};
}

std::array<Value, 2> tilts(const Hud& in) {
  const PlanReading& blade = in.hud.plan->blade;
  return {tilt(in, "plan.pitch", "operate.plan.pitch", blade.pitch_rad),
          tilt(in, "plan.roll", "operate.plan.roll", blade.roll_rad)};
}

Level angle(const Hud& in) {
  const HudPlan& plan = *in.hud.plan;
  const double degree = degree_from_radian(plan.blade.angle_rad);
  Level level{
      {"plan.angle", in.ui.text("operate.plan.angle"), decimal_text(degree) + "°", widest_deg, {}},
      {degree / angle_scale_deg, 0.0, false, {}}};
  set_band(level, plan.bands.angle_deg, degree);
  if (plan.bands.angle_deg) level.track.caption = band_text(in, *plan.bands.angle_deg, "°");
  return level;
}

Level offset(const Hud& in) {
  const HudPlan& plan = *in.hud.plan;
  const double off_mm = plan.blade.distance_mm;
  Level level{{"plan.distance",
               in.ui.text("operate.plan.distance"),
               signed_text(off_mm) + " mm",
               widest_mm,
               {}},
              {off_mm / distance_scale_mm, 0.0, true, {}}};
  set_band(level, plan.bands.location_mm, off_mm);
  if (plan.bands.location_mm) level.track.caption = band_text(in, *plan.bands.location_mm, " mm");
  return level;
}

Level along(const Hud& in) {
  const PassReading& pass = in.hud.plan->pass;
  return {{"plan.along",
           in.ui.text("operate.plan.along"),
           signed_text(pass.along_mm) + " mm",
           widest_mm,
           {}},
          {pass.along_mm / along_scale_mm, 0.0, true,
           in.ui.texts().say("operate.plan.pass", {{"pass", std::to_string(pass.pass + 1)},
                                                   {"count", std::to_string(pass.count)}})}};
}

// -- drawn

void tell(const Hud& in, const Value& value, const std::string& caption, const Rect& rect) {
  std::string told = std::string(value.name) + " " + value.text;
  if (!caption.empty()) told += " (" + caption + ")";
  if (value.state) told += ": " + in.text(words_of(*value.state));
  in.ui.tell(std::string("operate.") + value.id, told, rect);
}

float value_width(const Hud& in, const Value& value) {
  return in.ui.width_of(Type::Small, value.name) + name_gap + (value.state ? sign_width : 0.0F) +
         in.ui.width_of(Type::BodyStrong, value.widest);
}

void draw_value(Hud& in, const Rect& line, const Value& value) {
  const float width = in.ui.width_of(Type::BodyStrong, value.text);
  in.canvas().text_in({line.x, line.y, in.ui.width_of(Type::Small, value.name) + 1.0F, line.h},
                      {Type::Small, in.theme().text_secondary}, value.name);
  if (value.state) {
    draw_meaning(in.canvas(), in.theme(), meaning_of(*value.state),
                 {line.right() - width - 12.0F, line.mid_y()}, 5.5F);
  }
  in.canvas().text_in({line.right() - width, line.y, width + 1.0F, line.h},
                      {Type::BodyStrong, in.theme().text}, value.text);
}

void draw_track(Hud& in, const Rect& rect, const Track& track) {
  Canvas& canvas = in.canvas();
  const bool has_band = track.full_share > 0.0;
  const float zero_x = track.has_direction ? rect.mid_x() : rect.x;
  const float most = track.has_direction ? 0.5F * rect.w : rect.w;
  canvas.fill(rect, has_band ? faded(in.theme().warn, 0.35F) : in.theme().chip, 4.0F);
  const float full = most * static_cast<float>(track.full_share);
  const float from = track.has_direction ? zero_x - full : zero_x;
  if (has_band) canvas.fill({from, rect.y, zero_x + full - from, rect.h}, in.theme().good, 2.0F);
  const float at = most * static_cast<float>(std::clamp(track.share, -1.0, 1.0));
  canvas.fill({zero_x + at - 2.0F, rect.y - 5.0F, 4.0F, rect.h + 10.0F}, in.theme().text, 2.0F);
}

float level_width(const Hud& in, const Level& level) {
  return std::max(value_width(in, level.value),
                  in.ui.width_of(Type::Caption, level.track.caption) + 1.0F);
}

void draw_level(Hud& in, const Rect& rect, const Level& level) {
  draw_value(in, {rect.x, rect.y, rect.w, row_height}, level.value);
  draw_track(in, {rect.x, rect.y + 30.0F, rect.w, 8.0F}, level.track);
  in.canvas().text_in({rect.x, rect.y + 44.0F, rect.w, 18.0F},
                      {Type::Caption, in.theme().text_caption}, level.track.caption);
  tell(in, level.value, level.track.caption, rect);
}

float tilts_width(const Hud& in) {
  float width = 0.0F;
  for (const Value& value : tilts(in)) width = std::max(width, value_width(in, value));
  return width;
}

void draw_tilts(Hud& in, const Rect& rect) {
  Rect line{rect.x, rect.y, rect.w, row_height};
  for (const Value& value : tilts(in)) {
    draw_value(in, line, value);
    tell(in, value, {}, line);
    line.y += row_height + 4.0F;
  }
}

struct CompactLine {
  Value value;
  std::string caption;
};

std::array<CompactLine, 5> compact_lines(const Hud& in) {
  const Level whole = angle(in), off = offset(in), place = along(in);
  const std::array<Value, 2> parts = tilts(in);
  return {CompactLine{whole.value, whole.track.caption}, CompactLine{parts[0], {}},
          CompactLine{parts[1], {}}, CompactLine{off.value, off.track.caption},
          CompactLine{place.value, place.track.caption}};
}

}  // namespace

float plan_width(const Hud& in) {
  return level_width(in, angle(in)) + tilts_width(in) + level_width(in, offset(in)) +
         level_width(in, along(in)) + 3.0F * column_gap + 2.0F * hud_pad;
}

void draw_hud_plan(Hud& in, const Rect& rect) {
  const HudPanel panel(in, "operate.panel.plan", rect);
  const float spare = 0.25F * (rect.w - plan_width(in));
  Rect column = inset(rect, hud_pad, 12.0F);
  const auto next = [&](float width) {
    const Rect place{column.x, column.y, width + spare, column.h};
    column.x += place.w + column_gap;
    return place;
  };
  const Level whole = angle(in), off = offset(in), place = along(in);
  draw_level(in, next(level_width(in, whole)), whole);
  draw_tilts(in, next(tilts_width(in)));
  draw_level(in, next(level_width(in, off)), off);
  draw_level(in, next(level_width(in, place)), place);
}

Point compact_plan_size(const Hud& in) {
  const std::array<CompactLine, 5> lines = compact_lines(in);
  float width = 0.0F;
  for (const CompactLine& line : lines) width = std::max(width, value_width(in, line.value));
  return {width + 2.0F * compact_edge_x,
          compact_row * static_cast<float>(lines.size()) + 2.0F * compact_edge_y};
}

void draw_compact_plan(Hud& in, const Rect& rect) {
  const HudPanel panel(in, "operate.panel.plan", rect);
  Rect row = inset(rect, compact_edge_x, compact_edge_y);
  row.h = compact_row;
  for (const CompactLine& line : compact_lines(in)) {
    draw_value(in, row, line.value);
    tell(in, line.value, line.caption, row);
    row.y += compact_row;
  }
}

}  // namespace hallux::ui
