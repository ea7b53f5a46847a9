// How the work was done: harm, a break-through, the attempt's times, movements of the hand.
#include <algorithm>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"
#include "tests/screenshots/metrics/metric_pictures.h"
#include "tests/screenshots/metrics/sketch.h"

namespace hallux::tests {

namespace {

struct Span {
  double from = 0.0, to = 0.0;
};

void draw_bar(SvgPage& page, const Span& span, double y, std::string_view css_class) {
  page.polygon(
      std::vector<Vec2>{{span.from, y}, {span.to, y}, {span.to, y + 14.0}, {span.from, y + 14.0}},
      css_class);
}

/// Of the least jerk, from 0 to 1.
double speed_of(double share) {
  const double rest = share * (1.0 - share);
  return 16.0 * rest * rest;
}

/// The size of its Fourier transform over that at rest; turns of its duration.
double spectrum_of(double turns) {
  constexpr int parts = 200;
  double cosines = 0.0, sines = 0.0, whole = 0.0;
  for (int part = 0; part <= parts; ++part) {
    const double share = static_cast<double>(part) / parts, speed = speed_of(share);
    const double angle_rad = 2.0 * pi * turns * share;
    cosines += speed * elementary::cos(angle_rad);
    sines += speed * elementary::sin(angle_rad);
    whole += speed;
  }
  return std::sqrt(cosines * cosines + sines * sines) / whole;
}

void draw_speeds(SvgPage& page) {
  page.text({40.0, 45.0}, "speed of the handle", "head");
  page.line({40.0, 200.0}, {450.0, 200.0}, "thin");
  page.line({40.0, 192.0}, {450.0, 192.0}, "dash");
  page.text({455.0, 196.0}, "5 mm/s", "small");
  const Span spans[] = {{60.0, 170.0}, {190.0, 215.0}, {240.0, 420.0}};
  const double heights[] = {100.0, 40.0, 120.0};
  for (int movement = 0; movement < 3; ++movement) {
    const Span& span = spans[movement];
    std::vector<Vec2> places;
    for (int part = 0; part <= 40; ++part) {
      const double share = part / 40.0;
      places.emplace_back(span.from + share * (span.to - span.from),
                          200.0 - heights[movement] * speed_of(share));
    }
    page.polyline(places, movement == 1 ? "dash" : "wall");
  }
  draw_bar(page, {64.0, 166.0}, 206.0, "open");
  draw_bar(page, {245.0, 415.0}, 206.0, "open");
  page.text({40.0, 245.0}, "free movements: 0.3 s and longer, no tooth at bone, no kerf");
  page.text({40.0, 262.0}, "ldlj: how much their speed bends");
}

void draw_spectrum(SvgPage& page) {
  page.text({540.0, 45.0}, "one movement's spectrum", "head");
  page.line({540.0, 200.0}, {760.0, 200.0}, "thin");
  page.line({540.0, 194.0}, {760.0, 194.0}, "dash");
  page.text({765.0, 198.0}, "5 %", "small");
  std::vector<Vec2> places;
  for (int part = 0; part <= 80; ++part) {
    const double share = spectrum_of(part / 20.0);
    places.emplace_back(540.0 + 2.75 * part, 200.0 - 120.0 * share);
    if (share < 0.05) break;
  }
  page.polyline(places, "cut");
  page.line(places.back(), places.back() + Vec2(0.0, 14.0), "thin");
  page.text({540.0, 245.0}, "sparc: minus the length of the line");
}

void draw_way(SvgPage& page) {
  page.text({40.0, 300.0}, "way of the blade near the bone", "head");
  draw_bone(page, shaft({300.0, 300.0}, {620.0, 390.0}));
  page.polyline(std::vector<Vec2>{{60.0, 330.0}, {440.0, 312.0}, {440.0, 365.0}}, "plan");
  page.polyline(std::vector<Vec2>{{60.0, 330.0},
                                  {160.0, 360.0},
                                  {270.0, 295.0},
                                  {380.0, 330.0},
                                  {350.0, 290.0},
                                  {440.0, 305.0},
                                  {442.0, 366.0},
                                  {437.0, 320.0},
                                  {441.0, 362.0}},
                "cut");
  page.text({640.0, 350.0}, "path_ratio: red over dashed");
}

}  // namespace

std::string draw_harm() {
  SvgPage page({880.0, 300.0}, "What must not be touched: zones, joints, hot bone");
  page.text({40.0, 45.0}, "a danger zone", "head");
  page.polygon(std::vector<Vec2>{{40.0, 150.0}, {200.0, 150.0}, {200.0, 162.0}, {40.0, 162.0}},
               "pane");
  page.polygon(oval({205.0, 156.0}, {34.0, 34.0}), "hull");
  page.polygon(oval({205.0, 156.0}, {34.0, 34.0}), "cut");
  page.measure({171.0, 190.0}, {200.0, 190.0});
  page.label({150.0, 225.0}, {186.0, 190.0}, "danger_depth_mm");
  page.text({40.0, 255.0}, "danger_contacts_count: how often; danger_s: how long,");
  page.text({40.0, 271.0}, "of the running saw");
  page.text({400.0, 45.0}, "a joint", "head");
  draw_bone(page, {{400.0, 90.0},
                   {500.0, 90.0},
                   {540.0, 120.0},
                   {550.0, 160.0},
                   {540.0, 200.0},
                   {500.0, 230.0},
                   {400.0, 230.0}});
  page.polyline(
      std::vector<Vec2>{
          {500.0, 90.0}, {540.0, 120.0}, {550.0, 160.0}, {540.0, 200.0}, {500.0, 230.0}},
      "wall");
  page.polygon(std::vector<Vec2>{{452.0, 60.0}, {462.0, 60.0}, {462.0, 185.0}, {452.0, 185.0}},
               "open");
  page.measure({462.0, 160.0}, {550.0, 160.0});
  page.text({470.0, 262.0}, "joint_margin_mm", "words", "middle");
  draw_bone(page, {{612.0, 90.0},
                   {580.0, 96.0},
                   {562.0, 130.0},
                   {562.0, 190.0},
                   {580.0, 224.0},
                   {612.0, 230.0}});
  page.polygon(std::vector<Vec2>{{590.0, 75.0}, {598.0, 75.0}, {598.0, 130.0}, {590.0, 130.0}},
               "open");
  page.text({590.0, 284.0}, "wrong_bones_count: 1, begun on a bone without a planned cut", "words",
            "middle");
  page.text({640.0, 45.0}, "cells of the kerf's walls", "head");
  for (int u = 0; u < 9; ++u) {
    for (int v = 0; v < 6; ++v) {
      const int heat = 8 - u - std::abs(2 * v - 5) / 2;
      const Vec2 low(640.0 + 22.0 * u, 90.0 + 22.0 * v);
      const std::vector<Vec2> cell{low, low + Vec2(20.0, 0.0), low + Vec2(20.0, 20.0),
                                   low + Vec2(0.0, 20.0)};
      page.polygon(cell, heat > 4 ? "strip" : (heat > 1 ? "hull" : "bonefill"));
    }
  }
  page.text({640.0, 245.0}, "necrotic_mm3: the dark cells");
  page.text({640.0, 261.0}, "hot_s: while any is above 47 C");
  return page.take();
}

std::string draw_break_through() {
  SvgPage page({880.0, 340.0}, "Push and way of the teeth over a break-through");
  const double through = 430.0;
  page.line({through, 40.0}, {through, 290.0}, "plan");
  page.text({through, 32.0}, "the last tooth leaves bone", "head", "middle");
  page.text({40.0, 32.0}, "force on the hand", "head");
  const std::vector<Vec2> force{{60.0, 160.0},  {110.0, 110.0}, {170.0, 118.0}, {200.0, 80.0},
                                {240.0, 78.0},  {280.0, 112.0}, {350.0, 105.0}, {through, 108.0},
                                {450.0, 150.0}, {560.0, 160.0}, {820.0, 160.0}};
  page.line({60.0, 160.0}, {820.0, 160.0}, "thin");
  page.polyline(force, "wall");
  draw_bar(page, {200.0, 240.0}, 62.0, "open");
  page.text({220.0, 56.0}, "force_peak_newton: 20 ms", "words", "middle");
  page.line({60.0, 92.0}, {through, 92.0}, "dash");
  page.text({66.0, 88.0}, "force_p95_newton");
  page.text({66.0, 180.0}, "side_load_newton: the part along the blade's normal", "small");
  draw_bar(page, {395.0, through}, 164.0, "open");
  page.text({through - 8.0, 196.0}, "breakthrough_newton: 20 ms before", "words", "end");
  page.text({40.0, 215.0}, "way of the teeth", "head");
  page.polyline(std::vector<Vec2>{{60.0, 300.0},
                                  {through, 285.0},
                                  {500.0, 250.0},
                                  {580.0, 225.0},
                                  {650.0, 222.0},
                                  {740.0, 240.0},
                                  {820.0, 255.0}},
                "cut");
  page.line({through, 285.0}, {820.0, 285.0}, "thin");
  page.measure({650.0, 285.0}, {650.0, 222.0});
  page.text({658.0, 272.0}, "plunge_mm: in 200 ms");
  page.line({through, 285.0}, {500.0, 250.0}, "axis");
  page.text({508.0, 268.0}, "breakthrough_mm_s");
  page.text({508.0, 300.0}, "over 50 ms", "small");
  return page.take();
}

std::string draw_timeline() {
  SvgPage page({880.0, 330.0}, "The attempt's times");
  const double begin = 150.0, end = 820.0;
  const auto row = [&](double y, std::string_view words) {
    page.text({140.0, y + 11.5}, words, "words", "end");
    page.line({begin, y + 14.0}, {end, y + 14.0}, "thin");
  };
  page.measure({begin, 40.0}, {end, 40.0});
  page.text({0.5 * (begin + end), 30.0}, "time_s: from started to finished", "head", "middle");
  page.measure({begin, 66.0}, {270.0, 66.0});
  page.text({278.0, 70.0}, "planning_s: to the first tick that cut");
  row(90.0, "saw on");
  for (const Span& span : {Span{225.0, 420.0}, Span{520.0, 740.0}})
    draw_bar(page, span, 90.0, "pane");
  row(125.0, "teeth at bone");
  for (const Span& span : {Span{255.0, 400.0}, Span{500.0, 560.0}, Span{660.0, 730.0}})
    draw_bar(page, span, 125.0, "strip");
  page.label({540.0, 84.0}, {520.0, 97.0}, "started_in_bone");
  row(160.0, "cutting");
  for (const Span& span : {Span{270.0, 390.0}, Span{525.0, 555.0}, Span{665.0, 725.0}})
    draw_bar(page, span, 160.0, "open");
  for (const double x : {270.0, 525.0, 665.0}) page.line({x, 155.0}, {x, 178.0}, "cut");
  page.text({740.0, 160.0}, "restarts_count:");
  page.text({740.0, 174.0}, "beyond those needed", "small");
  row(195.0, "water");
  for (const Span& span : {Span{265.0, 360.0}, Span{660.0, 735.0}})
    draw_bar(page, span, 195.0, "pane");
  page.text({372.0, 206.0}, "irrigated_share: of the cutting");
  row(230.0, "handle at rest");
  draw_bar(page, {425.0, 490.0}, 230.0, "hull");
  page.text({500.0, 241.0}, "idle_s: longer than 1.5 s, below 2 mm/s");
  page.measure({563.0, 265.0}, {657.0, 265.0});
  page.text({610.0, 282.0}, "air_cutting_s: longer than 2 s", "words", "middle");
  const char* steps[] = {"1", "2", "4", "3", "5"};
  page.text({140.0, 310.0}, "steps", "words", "end");
  for (int step = 0; step < 5; ++step) page.number({180.0 + 70.0 * step, 306.0}, steps[step]);
  page.text({510.0, 310.0}, "step_order: 4 of 5 in their order");
  return page.take();
}

std::string draw_movements() {
  SvgPage page({880.0, 410.0}, "Free movements of the handle, one's spectrum, and the blade's way");
  draw_speeds(page);
  draw_spectrum(page);
  draw_way(page);
  return page.take();
}

std::vector<Picture> metric_pictures() {
  return {{"faces", draw_faces()},
          {"resection", draw_resection()},
          {"piece", draw_piece()},
          {"wedge", draw_wedge()},
          {"closing", draw_closing()},
          {"arms", draw_arms_of_a_v()},
          {"fixation", draw_fixation()},
          {"harm", draw_harm()},
          {"break_through", draw_break_through()},
          {"timeline", draw_timeline()},
          {"movements", draw_movements()}};
}

}  // namespace hallux::tests
