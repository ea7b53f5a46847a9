// The blade's plane drawn by rows: bone may be concave and have holes, which a canvas does not
// fill, so each row of pixels is filled where it runs through bone and not through what is open.
// Every kind of thing has a line of its own beside its colour: bone a fill, what is open an
// outline, the plan long dashes, a zone short ones until the blade is near.
#include "ui/screens/pictures/blade_section_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "ui/screens/pictures/section_rows.h"

namespace hallux::ui {

namespace {

constexpr Color bone_dark{208, 192, 160}, bone_light{214, 196, 160};
constexpr Color canal_dark{84, 58, 44}, canal_light{176, 140, 112};
/// Room before the bone, where the blade comes from, and around it.
constexpr double approach_mm = 8.0, around_mm = 3.0;
constexpr float plan_on = 7.0F, plan_off = 4.0F;
constexpr double zone_on_mm = 0.8, zone_on_off_mm = 1.5;
/// Of the words about the way, at the foot.
constexpr float way_height = 20.0F;

/// The plane on the window: x downwards, y to the right.
class PlaneOnWindow {
 public:
  PlaneOnWindow(const Rect& rect, const Vec2& low_mm, const Vec2& high_mm)
      : rect_(rect), middle_mm_(0.5 * (low_mm + high_mm)) {
    const Vec2 size_mm = glm::max(high_mm - low_mm, Vec2(1.0));
    pixels_per_mm_ = std::min(rect.w / size_mm.y, rect.h / size_mm.x);
  }

  Point at(const Vec2& place_mm) const {
    const Vec2 off = pixels_per_mm_ * (place_mm - middle_mm_);
    return {rect_.mid_x() + static_cast<float>(off.y), rect_.mid_y() + static_cast<float>(off.x)};
  }
  float across(double y_mm) const { return at(Vec2(0.0, y_mm)).x; }
  double x_mm_of(float y) const {
    return middle_mm_.x + static_cast<double>(y - rect_.mid_y()) / pixels_per_mm_;
  }
  std::vector<Point> points_of(const PlaneLoop& loop) const {
    std::vector<Point> points;
    points.reserve(loop.size() + 1);
    for (const Vec2& corner : loop) points.push_back(at(corner));
    if (!points.empty()) points.push_back(points.front());
    return points;
  }

 private:
  Rect rect_;
  Vec2 middle_mm_;
  double pixels_per_mm_ = 1.0;
};

struct ShownPart {
  Vec2 low_mm, high_mm;
};

Rect rect_between(Point low, Point high) { return {low.x, low.y, high.x - low.x, high.y - low.y}; }

ShownPart part_of(const PlaneLoop& loop) {
  ShownPart bounds{loop.front(), loop.front()};
  for (const Vec2& corner : loop) {
    bounds.low_mm = glm::min(bounds.low_mm, corner);
    bounds.high_mm = glm::max(bounds.high_mm, corner);
  }
  return bounds;
}

/// The part of the bone that the teeth are at: a plane along a shaft meets the bone twice.
ShownPart shown_part(const BladeSection& section) {
  const Vec2 teeth_mm = 0.5 * (section.teeth_from_mm + section.teeth_to_mm);
  ShownPart nearest{teeth_mm - Vec2(12.0), teeth_mm + Vec2(12.0)};
  double least_mm = std::numeric_limits<double>::infinity();
  for (const PlaneLoop& loop : section.section.bone_mm) {
    if (is_hole(loop)) continue;
    const ShownPart bounds = part_of(loop);
    const double off_mm =
        glm::distance(teeth_mm, glm::clamp(teeth_mm, bounds.low_mm, bounds.high_mm));
    if (off_mm >= least_mm) continue;
    least_mm = off_mm;
    nearest = bounds;
  }
  nearest.low_mm -= Vec2(approach_mm, around_mm);
  nearest.high_mm += Vec2(around_mm);
  return nearest;
}

void dashed(Canvas& canvas, Point from, Point to, Color color) {
  // Dashes along an axis are filled from their lesser end.
  if (from.x > to.x || from.y > to.y) std::swap(from, to);
  canvas.dashes(from, to, color, plan_on, plan_off, 1.5F);
}

void dashed_way(Canvas& canvas, Point from, Point to, Color color) {
  if (from.x > to.x || from.y > to.y) std::swap(from, to);
  canvas.dashes(from, to, color, 2.0F, 3.0F, 1.5F);
}

/// The loop's edges in short pieces, each told with how far along the loop it lies.
template <typename Visit>
void for_pieces(const PlaneLoop& loop, double longest_mm, Visit&& visit) {
  double run_mm = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const double length_mm = glm::distance(a, b);
    const int count = std::max(1, static_cast<int>(std::ceil(length_mm / longest_mm)));
    for (int piece = 0; piece < count; ++piece) {
      const double from = static_cast<double>(piece) / count;
      const double to = static_cast<double>(piece + 1) / count;
      visit(a + from * (b - a), a + to * (b - a), run_mm + from * length_mm);
    }
    run_mm += length_mm;
  }
}

/// Only where `is_drawn` says so of a piece's middle and its place along the loop.
template <typename Test>
void draw_pieces(Canvas& canvas, const PlaneOnWindow& plane, const PlaneLoop& loop, Color color,
                 float thickness, Test&& is_drawn) {
  constexpr double longest_mm = 0.35;
  std::vector<Point> run;
  const auto end_run = [&] {
    if (run.size() > 1) canvas.polyline(run, color, thickness);
    run.clear();
  };
  for_pieces(loop, longest_mm, [&](const Vec2& from_mm, const Vec2& to_mm, double along_mm) {
    if (!is_drawn(0.5 * (from_mm + to_mm), along_mm)) return end_run();
    if (run.empty()) run.push_back(plane.at(from_mm));
    run.push_back(plane.at(to_mm));
  });
  end_run();
}

bool is_in_bone(const KerfSection& section, const Vec2& place_mm) {
  const std::vector<RowSpan> spans = spans_at(section.bone_mm, place_mm.x);
  // Between the first and the last: holes are in it, too.
  return !spans.empty() && place_mm.y > spans.front().from_mm && place_mm.y < spans.back().to_mm;
}

void fill_rows(Canvas& canvas, const Rect& rect, const PlaneOnWindow& plane,
               std::span<const PlaneLoop> loops, std::span<const PlaneLoop> opened, Color color) {
  const float row = 1.0F / canvas.scale();
  for (float y = rect.y; y < rect.bottom(); y += row) {
    const double x_mm = plane.x_mm_of(y + 0.5F * row);
    for (const RowSpan& span : without(spans_at(loops, x_mm), spans_at(opened, x_mm))) {
      const float left = plane.across(span.from_mm), right = plane.across(span.to_mm);
      canvas.fill({left, y, right - left, row}, color);
    }
  }
}

void draw_bone(Ui& ui, const Rect& rect, const PlaneOnWindow& plane, const KerfSection& section) {
  const bool is_dark = ui.theme().is_dark();
  std::vector<PlaneLoop> canals;
  for (const PlaneLoop& loop : section.bone_mm) {
    if (is_hole(loop)) canals.push_back(loop);
  }
  Canvas& canvas = ui.canvas();
  fill_rows(canvas, rect, plane, section.bone_mm, section.opened_mm,
            is_dark ? bone_dark : bone_light);
  fill_rows(canvas, rect, plane, canals, section.opened_mm, is_dark ? canal_dark : canal_light);
  for (const PlaneLoop& loop : section.bone_mm)
    canvas.polyline(plane.points_of(loop), ui.theme().border, 1.0F);
  for (const PlaneLoop& loop : section.opened_mm) {
    draw_pieces(canvas, plane, loop, ui.theme().accent, 2.0F,
                [&](const Vec2& middle_mm, double) { return is_in_bone(section, middle_mm); });
  }
}

void draw_blade(Ui& ui, const PlaneOnWindow& plane, const BladeSection& section) {
  const Vec2 back = -section.blade_depth_mm * section.feed;
  const std::array corners{plane.at(section.teeth_from_mm), plane.at(section.teeth_to_mm),
                           plane.at(section.teeth_to_mm + back),
                           plane.at(section.teeth_from_mm + back)};
  Color steel = ui.theme().text_caption;
  steel.alpha = 90;
  ui.canvas().polygon(corners, steel);
  ui.canvas().line(corners[0], corners[1], ui.theme().text, 3.0F);
}

/// Where the tooth line is to go: on by the way, as wide as it is.
void draw_way(Ui& ui, const PlaneOnWindow& plane, const BladeSection& section) {
  const WayAhead& way = *section.way;
  if (way.to == WayEnd::Beside) return;
  const Vec2 on = (way.to == WayEnd::PastHinge ? -way.way_mm : way.way_mm) * section.feed;
  const Vec2 middle_mm = 0.5 * (section.teeth_from_mm + section.teeth_to_mm);
  const Color ink = ui.theme().text;
  dashed_way(ui.canvas(), plane.at(middle_mm), plane.at(middle_mm + on), ink);
  ui.canvas().line(plane.at(section.teeth_from_mm + on), plane.at(section.teeth_to_mm + on), ink,
                   1.5F);
}

/// At the foot, where it covers nothing and stays.
void draw_words(Ui& ui, const Rect& rect, const std::string& words) {
  const float width = ui.width_of(Type::CaptionMedium, words);
  const float x = rect.mid_x() - 0.5F * width, y = rect.bottom() - 9.0F;
  ui.canvas().fill({x - 4.0F, y - 9.0F, width + 8.0F, 18.0F}, ui.theme().hud, radius::step);
  ui.canvas().text({x, y}, {Type::CaptionMedium, ui.theme().text}, words);
}

void draw_plan(Ui& ui, const PlaneOnWindow& plane, const BladeSection& section) {
  for (const PlanTrace& trace : section.plan) {
    dashed(ui.canvas(), plane.at(trace.from_mm), plane.at(trace.to_mm), ui.theme().reference);
    if (trace.kind != PlanTraceKind::Hinge) continue;
    ui.canvas().ring(plane.at(0.5 * (trace.from_mm + trace.to_mm)), 4.0F, ui.theme().reference,
                     2.0F);
  }
}

void draw_zones(Ui& ui, const PlaneOnWindow& plane, const BladeSection& section) {
  for (const ZoneInSection& zone : section.zones) {
    if (zone.outline_mm.empty()) continue;
    if (!zone.is_near) {
      draw_pieces(ui.canvas(), plane, zone.outline_mm, ui.theme().bad, 1.5F,
                  [](const Vec2&, double along_mm) {
                    return std::fmod(along_mm, zone_on_off_mm) < zone_on_mm;
                  });
      continue;
    }
    const std::vector<Point> points = plane.points_of(zone.outline_mm);
    Color fill = ui.theme().bad;
    fill.alpha = 90;
    ui.canvas().polygon(std::span(points).first(points.size() - 1), fill);
    ui.canvas().polyline(points, ui.theme().bad, 2.5F);
  }
}

void draw_no_section(Ui& ui, const Rect& rect) {
  ui.canvas().paragraph(inset(rect, 12.0F), {Type::Small, ui.theme().text_secondary},
                        ui.text("section.none"));
}

/// One pass of several: its edges along the teeth, and its place among them.
struct ShownPass {
  Vec2 edges_mm;
  std::size_t index = 0, count = 1;
};

/// Its way through the bone: what lies in two of them is darker.
void draw_way_of_pass(Ui& ui, const PlaneOnWindow& plane, const ShownPart& part,
                      const ShownPass& pass) {
  const Rect way = rect_between(plane.at(Vec2(part.low_mm.x, pass.edges_mm.x)),
                                plane.at(Vec2(part.high_mm.x, pass.edges_mm.y)));
  Color tint = ui.theme().accent;
  tint.alpha = 28;
  ui.canvas().fill(way, tint);
  for (const float x : {way.x, way.right()})
    dashed(ui.canvas(), {x, way.y}, {x, way.bottom()}, ui.theme().text_secondary);
}

/// Its blade before the bone, below those before it, since they lie in each other.
void draw_blade_of_pass(Ui& ui, const PlaneOnWindow& plane, const ShownPart& part,
                        const ShownPass& pass) {
  const double row_mm = (approach_mm - 1.0) / static_cast<double>(pass.count);
  const double from_mm = part.low_mm.x + row_mm * static_cast<double>(pass.index);
  const Rect blade = rect_between(plane.at(Vec2(from_mm, pass.edges_mm.x)),
                                  plane.at(Vec2(from_mm + row_mm, pass.edges_mm.y)));
  ui.canvas().fill(blade, ui.theme().chip);
  ui.canvas().outline(blade, ui.theme().border);
  ui.canvas().line({blade.x, blade.bottom()}, {blade.right(), blade.bottom()}, ui.theme().text,
                   3.0F);
  ui.canvas().text({blade.mid_x(), blade.mid_y()},
                   {Type::CaptionMedium, ui.theme().text, Align::Centre},
                   std::to_string(pass.index + 1));
}

}  // namespace

void draw_blade_section(Ui& ui, const Rect& rect, const BladeSection& section) {
  if (section.section.bone_mm.empty()) return draw_no_section(ui, rect);
  const ShownPart bounds = shown_part(section);
  const PlaneOnWindow plane({rect.x, rect.y, rect.w, rect.h - way_height}, bounds.low_mm,
                            bounds.high_mm);
  const ClipScope clip(ui.canvas(), rect);
  draw_bone(ui, rect, plane, section.section);
  draw_zones(ui, plane, section);
  draw_plan(ui, plane, section);
  draw_blade(ui, plane, section);
  if (!section.way) return;
  draw_way(ui, plane, section);
  draw_words(ui, rect, words_of(ui.texts(), *section.way));
}

void draw_section_with_passes(Ui& ui, const Rect& rect, const BladeSection& section,
                              std::span<const double> middles_mm, double blade_width_mm) {
  if (section.section.bone_mm.empty()) return draw_no_section(ui, rect);
  ShownPart part = shown_part(section);
  const double half_mm = 0.5 * blade_width_mm;
  part.low_mm.y = std::min(part.low_mm.y, middles_mm.front() - half_mm - 1.0);
  part.high_mm.y = std::max(part.high_mm.y, middles_mm.back() + half_mm + 1.0);
  const PlaneOnWindow plane(rect, part.low_mm, part.high_mm);
  const ClipScope clip(ui.canvas(), rect);
  draw_bone(ui, rect, plane, section.section);
  draw_zones(ui, plane, section);
  draw_plan(ui, plane, section);
  std::vector<ShownPass> passes;
  for (const double middle_mm : middles_mm) {
    passes.push_back(
        {Vec2(middle_mm - half_mm, middle_mm + half_mm), passes.size(), middles_mm.size()});
  }
  for (const ShownPass& pass : passes) draw_way_of_pass(ui, plane, part, pass);
  for (const ShownPass& pass : passes) draw_blade_of_pass(ui, plane, part, pass);
}

}  // namespace hallux::ui
