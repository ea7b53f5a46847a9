// A press means by its place what it is for: the playhead, the part that is shown, or the strip;
// what it means is decided where it begins and holds until the button is let go. The marks are
// controls over the area, so that they are reached by keys and read out.
#include "ui/widgets/controls/timeline_view.h"

#include <algorithm>
#include <cmath>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/tooltip.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

using Grip = TimelineState::Grip;

constexpr double wheel_step = 1.25, key_step = 1.6;
/// Of what is shown.
constexpr double key_move = 0.5, wheel_move = 0.1;
constexpr float grip_reach = 8.0F, strip_reach = 5.0F, mark_height = 24.0F;
/// Below it, a moment is said with tenths.
constexpr double tenths_below_s = 20.0;
constexpr float button_gap = 4.0F, text_gap = 12.0F, button_size = 36.0F;
constexpr float legend_line = 22.0F, legend_shape = 24.0F, legend_gap = 20.0F;

std::string moment_in(const Timeline& shown, double time_s) {
  return range_of(shown).span_s() < tenths_below_s ? clock_tenths_text(time_s) : clock_text(time_s);
}

void set_range(TimelineState& state, const TimeRange& range, double duration_s) {
  state.range = is_whole(range, duration_s) ? std::nullopt : std::optional(range);
}

void zoom(TimelineState& state, const Timeline& shown, double factor, double about_s) {
  set_range(state, zoomed(range_of(shown), shown.duration_s, factor, about_s), shown.duration_s);
}

void move(TimelineState& state, const Timeline& shown, double by_s) {
  set_range(state, moved(range_of(shown), shown.duration_s, by_s), shown.duration_s);
}

/// Where the playhead is in sight there, else about the middle.
void zoom_by_key(TimelineState& state, const Timeline& shown, double factor) {
  const TimeRange range = range_of(shown);
  const bool is_in_sight = shown.now_s && range.contains(*shown.now_s);
  zoom(state, shown, factor, is_in_sight ? *shown.now_s : 0.5 * (range.begin_s + range.end_s));
}

void follow_playhead(const Timeline& shown, TimelineState& state) {
  const std::optional<double> before_s = std::exchange(state.last_now_s, shown.now_s);
  if (!state.range || !shown.now_s || before_s == shown.now_s) return;
  state.range = showing(*state.range, shown.duration_s, *shown.now_s);
}

Grip grip_at(const TimelineLayout& layout, const Timeline& shown, Point at) {
  if (!shown.is_compact && at.y >= layout.overview.y - strip_reach) return Grip::Strip;
  const bool is_on_playhead =
      shown.now_s && std::abs(layout.plot.x(*shown.now_s) - at.x) <= grip_reach;
  const bool is_on_time = at.y < layout.steps.bottom() || at.y >= layout.axis_y - grip_reach;
  if (!shown.range || is_on_playhead || is_on_time) return Grip::Playhead;
  return Grip::Range;
}

void hear_wheel(const Ui& ui, const AreaResponse& area, const TimelineLayout& layout,
                const Timeline& shown, TimelineState& state) {
  if (area.wheel == 0.0F) return;
  const double notches = static_cast<double>(area.wheel);
  const TimeRange range = range_of(shown);
  if (ui.modifiers().shift) return move(state, shown, -notches * wheel_move * range.span_s());
  const double about_s =
      std::clamp(layout.plot.value_at(area.pointer.x), range.begin_s, range.end_s);
  zoom(state, shown, std::pow(wheel_step, notches), about_s);
}

/// The strip is of all of the time.
double strip_time_at(const TimelineLayout& layout, const Timeline& shown, float x) {
  const double share = static_cast<double>((x - layout.overview.x) / layout.overview.w);
  return std::clamp(share, 0.0, 1.0) * shown.duration_s;
}

/// What the held left button does; returns the moment that it leads the playhead to.
std::optional<double> hear_grip(const AreaResponse& area, const Rect& rect,
                                const TimelineLayout& layout, const Timeline& shown,
                                TimelineState& state) {
  if (!area.is_down[0]) {
    state.grip = Grip::None;
    return std::nullopt;
  }
  if (state.grip == Grip::None) state.grip = grip_at(layout, shown, area.pointer);
  if (state.grip == Grip::Playhead) return time_at(rect, shown, area.pointer.x);
  if (state.grip == Grip::Range)
    move(state, shown,
         layout.plot.value_at(layout.plot.rect.x) -
             layout.plot.value_at(layout.plot.rect.x + area.dragged[0].x));
  if (state.grip == Grip::Strip && shown.range) {
    const TimeRange range = range_of(shown);
    move(state, shown,
         strip_time_at(layout, shown, area.pointer.x) - 0.5 * (range.begin_s + range.end_s));
  }
  return std::nullopt;
}

std::optional<double> hear_pointer(const AreaResponse& area, const Rect& rect,
                                   const TimelineLayout& layout, const Timeline& shown,
                                   TimelineState& state) {
  // With the other buttons it is moved from everywhere.
  const float dragged = area.dragged[1].x + area.dragged[2].x;
  if (shown.range && dragged != 0.0F)
    move(state, shown,
         layout.plot.value_at(layout.plot.rect.x) -
             layout.plot.value_at(layout.plot.rect.x + dragged));
  const std::optional<double> led_s = hear_grip(area, rect, layout, shown, state);
  if (led_s) return led_s;
  if (area.is_double) {
    state.range.reset();
    return std::nullopt;
  }
  if (!area.clicked[0]) return std::nullopt;
  const bool is_on_strip = grip_at(layout, shown, area.pointer) == Grip::Strip;
  return is_on_strip ? strip_time_at(layout, shown, area.pointer.x)
                     : time_at(rect, shown, area.pointer.x);
}

/// A mark, or a number of marks, as a person presses and reads it.
struct MarkControl {
  std::string id, label, tip, context;
  Point at;
  float half_width = 0.0F;
};

Response mark_control(Ui& ui, const MarkControl& mark, const std::string& group) {
  const float half = std::max(mark.half_width, 6.0F);
  const Rect rect{mark.at.x - half, mark.at.y - 0.5F * mark_height, 2.0F * half, mark_height};
  const Response response = ui.control({.id = mark.id,
                                        .label = mark.label,
                                        .rect = rect,
                                        .role = Role::Option,
                                        .group = group,
                                        .is_in_sequence = true});
  if (response.shows_ring) draw_focus_ring(ui.canvas(), ui.theme(), rect, radius::row);
  if (response.is_hovered || response.shows_ring) tooltip(ui, mark.at, mark.tip, mark.context);
  return response;
}

using CountedText = std::string (*)(const Texts& texts, long count);
std::string events_text(const Texts& texts, long count) {
  return texts.say_count("timeline.events", count);
}
std::string notes_text(const Texts& texts, long count) {
  return texts.say_count("timeline.notes", count);
}

template <typename Item>
MarkControl control_of(const Ui& ui, const Timeline& shown, const std::vector<Item>& items,
                       const MarkCluster& cluster, CountedText counted) {
  MarkControl mark;
  mark.half_width = cluster.half_width;
  const Item& first = items[cluster.first];
  const std::string begin = moment_in(shown, first.time_s);
  if (cluster.count == 1) {
    mark.tip = first.words;
    mark.context = begin;
  } else {
    const Item& last = items[cluster.first + cluster.count - 1];
    mark.tip = counted(ui.texts(), static_cast<long>(cluster.count));
    mark.context = ui.texts().say("timeline.from_to",
                                  {{"begin", begin}, {"end", moment_in(shown, last.time_s)}});
  }
  mark.label = ui.texts().say("timeline.mark", {{"what", mark.tip}, {"when", mark.context}});
  return mark;
}

/// One is looked at, several are opened: shown so large that they come apart. What happened in one
/// instant does not.
template <typename Item>
std::optional<double> press_marks(TimelineState& state, const Timeline& shown,
                                  const std::vector<Item>& items, const MarkCluster& cluster) {
  const double first_s = items[cluster.first].time_s;
  if (cluster.count == 1) return first_s;
  const double last_s = items[cluster.first + cluster.count - 1].time_s;
  const TimeRange opened = around(first_s, last_s, shown.duration_s);
  if (opened.span_s() >= range_of(shown).span_s()) return first_s;
  set_range(state, opened, shown.duration_s);
  return std::nullopt;
}

/// Marks on one line, each a control `id.N`.
template <typename Item>
struct MarkLine {
  std::string id;
  const std::vector<Item>& items;
  std::vector<MarkCluster> clusters;
  float y = 0.0F;
  CountedText counted = nullptr;
};

struct PressedMark {
  /// Of the items.
  std::size_t first = 0;
  std::optional<double> asked_s;
};

template <typename Item>
PressedMark hear_marks(Ui& ui, const MarkLine<Item>& line, const Timeline& shown,
                       TimelineState& state) {
  PressedMark pressed;
  for (const MarkCluster& cluster : line.clusters) {
    MarkControl mark = control_of(ui, shown, line.items, cluster, line.counted);
    mark.id = line.id + "." + std::to_string(cluster.first + 1);
    mark.at = {cluster.x, line.y};
    if (!mark_control(ui, mark, line.id + "s").is_pressed()) continue;
    pressed = {cluster.first, press_marks(state, shown, line.items, cluster)};
  }
  return pressed;
}

/// Where a line of the legend breaks: calls `place(key, x, line)` for each.
template <typename Place>
int lay_out_legend(const Ui& ui, const Timeline& shown, float width, Place&& place) {
  int line = 0;
  float x = 0.0F;
  for (const TimelineKey& key : shown.legend) {
    const float own = legend_shape + ui.width_of(Type::Small, key.words);
    if (x > 0.0F && x + own > width) {
      x = 0.0F;
      ++line;
    }
    place(key, x, line);
    x += own + legend_gap;
  }
  return shown.legend.empty() ? 0 : line + 1;
}

}  // namespace

TimelineAnswer timeline(Ui& ui, std::string_view id, const Rect& rect, Timeline shown,
                        TimelineState& state, bool hears_wheel) {
  follow_playhead(shown, state);
  shown.range = state.range;
  const std::optional<TimeRange> before = state.range;
  const TimelineLayout layout = layout_of(rect, shown);
  const AreaResponse area =
      ui.area(id, ui.texts().say("timeline.label", {{"range", range_text(ui.texts(), shown)}}),
              rect, hears_wheel);
  draw_timeline(ui.canvas(), ui.theme(), rect, shown);
  if (hears_wheel) hear_wheel(ui, area, layout, shown, state);
  TimelineAnswer answer{hear_pointer(area, rect, layout, shown, state)};
  const std::string name(id);
  const MarkLine<TimelineEvent> events{name + ".event", shown.events, event_marks(layout, shown),
                                       layout.events_y, events_text};
  const MarkLine<TimelineNote> notes{name + ".note", shown.notes, note_marks(layout, shown),
                                     layout.notes_y, notes_text};
  const PressedMark event = hear_marks(ui, events, shown, state);
  const PressedMark note = hear_marks(ui, notes, shown, state);
  if (event.asked_s) answer = {event.asked_s, {}, true};
  if (note.asked_s) answer = {note.asked_s, note.first, true};
  if (state.range != before) ui.want_frame_in_s(0.0);
  return answer;
}

void hear_timeline_keys(Ui& ui, const Timeline& of, TimelineState& state) {
  const Timeline shown{.duration_s = of.duration_s, .range = state.range, .now_s = of.now_s};
  if (ui.shortcut({Key::Plus}, ui.text("timeline.nearer"))) zoom_by_key(state, shown, key_step);
  if (ui.shortcut({Key::Minus}, ui.text("timeline.farther")))
    zoom_by_key(state, shown, 1.0 / key_step);
  if (ui.shortcut({Key::Digit0}, ui.text("timeline.all"))) state.range.reset();
  const double half_s = key_move * range_of(shown).span_s();
  if (ui.shortcut(with_control(Key::Left), ui.text("timeline.earlier")))
    move(state, shown, -half_s);
  if (ui.shortcut(with_control(Key::Right), ui.text("timeline.later"))) move(state, shown, half_s);
}

std::string range_text(const Texts& texts, const Timeline& shown) {
  const std::string duration = clock_text(shown.duration_s);
  if (!shown.range) return texts.say("timeline.whole", {{"duration", duration}});
  return texts.say("timeline.range", {{"begin", moment_in(shown, shown.range->begin_s)},
                                      {"end", moment_in(shown, shown.range->end_s)},
                                      {"duration", duration}});
}

float timeline_bar_width(const Ui& ui, const Timeline& shown, const TimelineState& state) {
  Timeline as_shown{.duration_s = shown.duration_s, .range = state.range};
  return ui.width_of(Type::Small, range_text(ui.texts(), as_shown)) + text_gap +
         4.0F * button_size + 3.0F * button_gap;
}

void timeline_bar(Ui& ui, std::string_view id, const Rect& line, const Timeline& shown,
                  TimelineState& state, bool shows_legend) {
  Timeline as_shown{.duration_s = shown.duration_s, .range = state.range, .now_s = shown.now_s};
  const std::string name(id);
  Rect rest = line;
  // What would do nothing is not there; its room stays.
  const auto pressed = [&](const char* what, const IconButtonSpec& spec, bool is_there) {
    const Rect place = take_right(rest, button_size, button_gap);
    return is_there &&
           icon_button(ui, name + what,
                       {place.x, place.mid_y() - 0.5F * button_size, button_size, button_size},
                       spec);
  };
  const bool is_part = state.range.has_value();
  const bool may_come_nearer =
      range_of(as_shown).span_s() > std::min(least_span_s, shown.duration_s) * (1.0 + 1.0e-9);
  if (pressed(".legend",
              {ui.text(shows_legend ? "timeline.legend.hide" : "timeline.legend.show"), Icon::Help,
               shows_legend},
              !shown.legend.empty()))
    state.shows_legend = !shows_legend;
  if (pressed(".all", {ui.text("timeline.all"), Icon::Expand}, is_part)) state.range.reset();
  if (pressed(".nearer", {ui.text("timeline.nearer"), Icon::Add}, may_come_nearer))
    zoom_by_key(state, as_shown, key_step);
  if (pressed(".farther", {ui.text("timeline.farther"), Icon::Less}, is_part))
    zoom_by_key(state, as_shown, 1.0 / key_step);
  take_right(rest, text_gap - button_gap);
  ui.canvas().text({rest.right(), rest.mid_y()},
                   {Type::Small, ui.theme().text_secondary, Align::Right},
                   range_text(ui.texts(), as_shown));
}

float timeline_legend_height(const Ui& ui, const Timeline& shown, float width) {
  const auto nowhere = [](const TimelineKey&, float, int) {};
  return legend_line * static_cast<float>(lay_out_legend(ui, shown, width, nowhere));
}

void draw_timeline_legend(Ui& ui, const Rect& rect, const Timeline& shown) {
  lay_out_legend(ui, shown, rect.w, [&](const TimelineKey& key, float x, int line) {
    const float y = rect.y + legend_line * (static_cast<float>(line) + 0.5F);
    const bool has_number = key.shape == TimelineShape::Note || key.shape == TimelineShape::Cluster;
    draw_timeline_shape(ui.canvas(), ui.theme(), key.shape, {rect.x + x + 9.0F, y},
                        has_number ? "3" : "");
    ui.canvas().text({rect.x + x + legend_shape, y}, {Type::Small, ui.theme().text_secondary},
                     key.words);
  });
}

}  // namespace hallux::ui
