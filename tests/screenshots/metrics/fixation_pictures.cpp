// The arms of a V, the fragment that they free, and what holds it.
#include "tests/screenshots/metrics/metric_pictures.h"
#include "tests/screenshots/metrics/sketch.h"

namespace hallux::tests {

namespace {

void draw_arms(SvgPage& page) {
  page.text({40.0, 45.0}, "two arms, from medial", "head");
  draw_bone(page, shaft({40.0, 80.0}, {420.0, 250.0}));
  const Vec2 apex(340.0, 165.0);
  page.line(apex, {175.0, 85.0}, "plan");
  page.line(apex, {175.0, 245.0}, "plan");
  page.line(apex, {205.0, 82.0}, "cut");
  page.line(apex, {175.0, 245.0}, "cut");
  draw_arc(page, apex, Vec2(205.0, 82.0) - apex, Vec2(175.0, 245.0) - apex, 80.0);
  page.dot(apex, 4.0, "corner");
  page.label({190.0, 165.0}, {259.0, 165.0}, "included_angle_deg");
  page.text({40.0, 282.0}, "right_tool: sawn with the planned blade");
}

void draw_axis(SvgPage& page) {
  page.text({480.0, 45.0}, "one arm, from dorsal", "head");
  page.polygon(oval({585.0, 165.0}, {70.0, 85.0}), "bonefill");
  page.polygon(oval({585.0, 165.0}, {70.0, 85.0}), "bone");
  page.line({585.0, 65.0}, {585.0, 275.0}, "axis");
  page.line({567.0, 70.0}, {603.0, 268.0}, "cut");
  draw_arc(page, {585.0, 165.0}, {-17.0, -95.0}, {0.0, -95.0}, 78.0);
  page.label({640.0, 75.0}, {578.0, 90.0}, "common_axis_deg");
  page.text({500.0, 295.0}, "contained direction, and the face");
}

void draw_overhang(SvgPage& page) {
  page.text({720.0, 45.0}, "after a shift", "head");
  draw_bone(page, {{700.0, 150.0}, {790.0, 150.0}, {790.0, 235.0}, {700.0, 235.0}});
  draw_bone(page, {{794.0, 110.0}, {860.0, 110.0}, {860.0, 215.0}, {794.0, 215.0}});
  page.line({700.0, 205.0}, {870.0, 205.0}, "plan");
  page.measure({770.0, 205.0}, {770.0, 235.0});
  page.label({755.0, 270.0}, {769.0, 222.0}, "overhang_mm");
  page.text({700.0, 90.0}, "bone beyond the face");
}

void draw_shift(SvgPage& page) {
  page.text({40.0, 45.0}, "where the plan brings it, and where it lies", "head");
  draw_bone(page, {{40.0, 110.0}, {190.0, 110.0}, {190.0, 240.0}, {40.0, 240.0}});
  page.polyline(
      std::vector<Vec2>{
          {202.0, 80.0}, {320.0, 80.0}, {320.0, 210.0}, {202.0, 210.0}, {202.0, 80.0}},
      "plan");
  draw_bone(page, {{210.0, 102.0}, {328.0, 84.0}, {346.0, 212.0}, {229.0, 230.0}});
  page.dot({261.0, 145.0}, 4.0, "node");
  page.dot({278.0, 157.0}, 4.0, "corner");
  page.measure({261.0, 145.0}, {278.0, 157.0});
  page.label({370.0, 110.0}, {272.0, 150.0}, "shift_error_mm");
  page.arrow({270.0, 265.0}, {278.0, 163.0}, "thin");
  page.text({225.0, 282.0}, "shift_mm: its whole way");
  page.text({225.0, 302.0}, "shifted: at least half of the planned one");
  page.line({328.0, 84.0}, {346.0, 212.0}, "cut");
  page.line({328.0, 84.0}, {328.0, 212.0}, "plan");
  draw_arc(page, {328.0, 84.0}, {0.0, 128.0}, {18.0, 128.0}, 100.0);
  page.text({360.0, 200.0}, "turn_error_deg");
  page.arrow({470.0, 240.0}, {470.0, 90.0}, "axis");
  page.text({420.0, 260.0}, "elevation_mm: up or down");
  page.measure({190.0, 190.0}, {223.0, 190.0});
  page.label({182.0, 80.0}, {206.0, 188.0}, "gap_mm, contact_share");
}

void draw_screw(SvgPage& page) {
  page.text({600.0, 45.0}, "what holds it: fixed", "head");
  draw_bone(page, shaft({600.0, 85.0}, {860.0, 255.0}));
  page.line({735.0, 100.0}, {735.0, 240.0}, "cut");
  page.line({650.0, 70.0}, {835.0, 182.0}, "plan");
  page.line({662.0, 66.0}, {822.0, 196.0}, "bone");
  page.dot({703.0, 101.0}, 4.0, "crossing");
  page.dot({822.0, 196.0}, 4.0, "tip");
  page.measure({681.0, 89.0}, {703.0, 101.0});
  page.label({610.0, 285.0}, {692.0, 97.0}, "entry_mm");
  page.text({690.0, 68.0}, "direction_deg: off the plan");
  page.measure({822.0, 196.0}, {858.0, 182.0});
  page.text({870.0, 270.0}, "tip_to_joint_mm", "words", "end");
  page.text({680.0, 290.0}, "cortices crossed, insertions");
  page.text({560.0, 308.0}, "length_error_mm; protrusion_mm: out of bone");
}

}  // namespace

std::string draw_arms_of_a_v() {
  SvgPage page({880.0, 315.0}, "The arms of a V, their axis, and what stands out after a shift");
  draw_arms(page);
  draw_axis(page);
  draw_overhang(page);
  return page.take();
}

std::string draw_fixation() {
  SvgPage page({880.0, 325.0}, "A fragment against its plan, and the screw that holds it");
  draw_shift(page);
  draw_screw(page);
  return page.take();
}

}  // namespace hallux::tests
