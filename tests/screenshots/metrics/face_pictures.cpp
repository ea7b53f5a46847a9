// A face against the planned one: its turns and ends, the landmarks of a resection, what is uneven
// and what is taken.
#include "tests/screenshots/metrics/metric_pictures.h"
#include "tests/screenshots/metrics/sketch.h"

namespace hallux::tests {

namespace {

void draw_across(SvgPage& page) {
  draw_bone(page, shaft({40.0, 80.0}, {400.0, 230.0}));
  page.text({40.0, 50.0}, "from dorsal: a cut across the bone", "head");
  const Vec2 plan_low(190.0, 75.0), plan_high(190.0, 245.0), low(225.0, 75.0), high(165.0, 245.0);
  page.line(plan_low, plan_high, "plan");
  page.line(low, high, "cut");
  draw_arc(page, {200.6, 144.0}, low - high, plan_low - plan_high, 52.0);
  page.measure({190.0, 90.0}, {219.7, 90.0});
  page.label({265.0, 70.0}, {212.0, 90.0}, "entry_mm");
  page.measure({190.0, 222.0}, {173.1, 222.0});
  page.label({130.0, 252.0}, {181.0, 222.0}, "exit_mm");
  page.label({275.0, 120.0}, {207.0, 98.0}, "transverse_tilt_deg");
  page.text({275.0, 136.0}, "in space: angle_deg");
  page.text({40.0, 285.0}, "dashed: the plan; red: the fitted face; distal is right, medial above",
            "small");
}

void draw_leaning(SvgPage& page) {
  draw_bone(page, shaft({470.0, 80.0}, {620.0, 230.0}));
  page.text({470.0, 50.0}, "from medial", "head");
  const Vec2 plan_low(540.0, 75.0), plan_high(540.0, 245.0), low(520.0, 75.0), high(560.0, 245.0);
  page.line(plan_low, plan_high, "plan");
  page.line(low, high, "cut");
  draw_arc(page, {540.0, 160.0}, low - high, plan_low - plan_high, 60.0);
  page.label({575.0, 80.0}, {534.0, 100.0}, "sagittal_tilt_deg");
}

void draw_distances(SvgPage& page) {
  page.text({680.0, 50.0}, "distances of the samples", "head");
  page.line({690.0, 75.0}, {690.0, 245.0}, "plan");
  double sum = 0.0;
  for (int sample = 0; sample < 9; ++sample) {
    const double y = 80.0 + 20.0 * sample, off = 64.0 - 6.5 * sample;
    page.line({690.0, y}, {690.0 + off, y}, "thin");
    page.dot({690.0 + off, y}, 3.0, "corner");
    sum += off / 9.0;
  }
  page.line({690.0 + sum, 75.0}, {690.0 + sum, 245.0}, "dash");
  page.text({762.0, 84.0}, "location_mm");
  page.label({775.0, 190.0}, {690.0 + sum, 180.0}, "mean_mm,");
  page.text({775.0, 206.0}, "rms_mm");
}

}  // namespace

std::string draw_faces() {
  SvgPage page({880.0, 305.0}, "A face against the planned one: turns, ends and distances");
  draw_across(page);
  draw_leaning(page);
  draw_distances(page);
  return page.take();
}

std::string draw_resection() {
  SvgPage page({880.0, 320.0}, "A resection along the bone, at its two landmarks");
  draw_bone(page, {{60.0, 130.0},
                   {230.0, 140.0},
                   {520.0, 120.0},
                   {600.0, 85.0},
                   {700.0, 70.0},
                   {780.0, 90.0},
                   {810.0, 160.0},
                   {800.0, 250.0},
                   {520.0, 250.0},
                   {60.0, 240.0}});
  page.line({180.0, 150.0}, {830.0, 112.0}, "plan");
  page.line({180.0, 122.0}, {830.0, 164.0}, "cut");
  page.dot({770.0, 135.0}, 4.5, "node");
  page.measure({770.0, 115.5}, {770.0, 160.0});
  page.label({700.0, 40.0}, {770.0, 122.0}, "depth_mm: from the plan to the face");
  page.label({690.0, 205.0}, {770.0, 148.0}, "past_landmark_mm: from the sulcus");
  page.text({690.0, 221.0}, "into what is kept", "words", "end");
  page.measure({240.0, 146.5}, {240.0, 126.0});
  page.label({300.0, 60.0}, {240.0, 136.0}, "step_mm: here a ledge");
  page.text({305.0, 190.0}, "the other way: notch_mm, into the shaft");
  page.line({300.0, 186.0}, {246.0, 150.0}, "thin");
  page.text({60.0, 300.0},
            "dashed: the plan; red: the fitted face; medial, where the waste lies, is above",
            "small");
  return page.take();
}

std::string draw_piece() {
  SvgPage page({880.0, 320.0}, "What is left uneven, and how thick the piece is");
  page.text({40.0, 45.0}, "the blade in its kerf", "head");
  const double heights[] = {0.0, 9.0, 14.0, 6.0, -8.0, -15.0, -6.0, 4.0, 10.0, 2.0};
  std::vector<Vec2> way;
  way.reserve(std::size(heights));
  for (int tick = 0; tick < 10; ++tick) way.emplace_back(50.0 + 20.0 * tick, 150.0 - heights[tick]);
  page.line({40.0, 150.0}, {240.0, 150.0}, "plan");
  page.polyline(way, "cut");
  for (const Vec2& place : way) page.dot(place, 3.0, "corner");
  page.measure({255.0, 137.0}, {255.0, 164.0});
  page.text({40.0, 200.0}, "flatness_mm: 95 of 100");
  page.text({40.0, 216.0}, "points of the tooth line");
  page.text({330.0, 45.0}, "a second kerf beside the face", "head");
  page.polygon(std::vector<Vec2>{{330.0, 120.0},
                                 {450.0, 120.0},
                                 {450.0, 150.0},
                                 {570.0, 150.0},
                                 {570.0, 230.0},
                                 {330.0, 230.0}},
               "bonefill");
  page.line({330.0, 120.0}, {450.0, 120.0}, "wall");
  page.line({450.0, 150.0}, {570.0, 150.0}, "cut");
  page.line({330.0, 150.0}, {450.0, 150.0}, "dash");
  page.measure({390.0, 120.0}, {390.0, 150.0});
  page.text({330.0, 255.0}, "ledges_count: walls more than 0.5 mm off");
  page.text({620.0, 45.0}, "what lies over the face", "head");
  draw_bone(page, {{620.0, 200.0},
                   {640.0, 140.0},
                   {690.0, 100.0},
                   {750.0, 85.0},
                   {810.0, 120.0},
                   {840.0, 200.0}});
  page.line({620.0, 200.0}, {840.0, 200.0}, "cut");
  for (const auto& [x, top] : {std::pair{660.0, 124.0}, std::pair{705.0, 96.3},
                               std::pair{795.0, 111.3}, std::pair{825.0, 160.0}})
    page.line({x, 200.0}, {x, top}, "thin");
  page.measure({750.0, 200.0}, {750.0, 85.0});
  page.text({742.0, 150.0}, "thickness_max_mm", "words", "end");
  page.text({620.0, 230.0}, "thickness_mm: their mean");
  return page.take();
}

}  // namespace hallux::tests
