// An Akin's wedge before and after it is closed.
#include "tests/screenshots/metrics/metric_pictures.h"
#include "tests/screenshots/metrics/sketch.h"

namespace hallux::tests {

namespace {

void draw_two_faces(SvgPage& page) {
  page.text({40.0, 45.0}, "from dorsal", "head");
  draw_bone(page, shaft({40.0, 80.0}, {470.0, 260.0}));
  const Vec2 apex(215.0, 226.0), planned_apex(190.0, 236.0);
  page.line({185.0, 70.0}, planned_apex, "plan");
  page.line({250.0, 70.0}, planned_apex, "plan");
  page.line({180.0, 70.0}, apex, "cut");
  page.line({290.0, 70.0}, apex, "cut");
  draw_arc(page, apex, Vec2(180.0, 70.0) - apex, Vec2(290.0, 70.0) - apex, 62.0);
  page.label({310.0, 195.0}, {228.0, 165.0}, "wedge_error_deg: off the plan");
  page.text({310.0, 211.0}, "wedge_reversed: open below");
  page.measure({185.8, 96.0}, {277.5, 96.0});
  page.label({330.0, 60.0}, {262.0, 96.0}, "base_mm");
  page.dot(apex, 4.0, "corner");
  page.dot(planned_apex, 4.0, "node");
  page.measure(planned_apex, apex);
  page.label({120.0, 290.0}, {200.0, 234.0}, "apex_offset_mm");
}

void draw_lines(SvgPage& page) {
  page.text({500.0, 45.0}, "along the hinge's line", "head");
  page.polygon(oval({580.0, 165.0}, {62.0, 92.0}), "bonefill");
  page.polygon(oval({580.0, 165.0}, {62.0, 92.0}), "bone");
  page.line({612.0, 70.0}, {612.0, 260.0}, "plan");
  page.line({592.0, 70.0}, {632.0, 260.0}, "cut");
  draw_arc(page, {612.0, 165.0}, {-20.0, -95.0}, {0.0, -95.0}, 70.0);
  page.label({622.0, 75.0}, {606.0, 96.0}, "apex_angle_deg");
  page.text({505.0, 282.0}, "wedge_sagittal_deg:");
  page.text({505.0, 298.0}, "one end is wider");
}

void draw_bridge(SvgPage& page) {
  page.text({720.0, 45.0}, "the bridge", "head");
  draw_bone(page, {{720.0, 80.0},
                   {800.0, 80.0},
                   {820.0, 120.0},
                   {824.0, 165.0},
                   {820.0, 210.0},
                   {800.0, 250.0},
                   {720.0, 250.0}});
  page.polygon(std::vector<Vec2>{{720.0, 110.0}, {785.0, 120.0}, {792.0, 210.0}, {720.0, 220.0}},
               "open");
  page.line({785.0, 120.0}, {792.0, 210.0}, "cut");
  page.line({824.0, 70.0}, {824.0, 262.0}, "thin");
  page.measure({791.0, 190.0}, {824.0, 190.0});
  page.text({712.0, 282.0}, "hinge_mm; 0: hinge_lost");
  page.text({712.0, 298.0}, "beyond: over_cut_mm");
}

}  // namespace

std::string draw_wedge() {
  SvgPage page({880.0, 315.0}, "The wedge between two faces, and the bridge at its end");
  draw_two_faces(page);
  draw_lines(page);
  draw_bridge(page);
  return page.take();
}

std::string draw_closing() {
  SvgPage page({880.0, 300.0}, "The wedge taken out, and closed");
  page.text({40.0, 45.0}, "piece_out: most of the bone between the faces went", "head");
  draw_bone(page, {{40.0, 100.0}, {180.0, 105.0}, {210.0, 215.0}, {40.0, 225.0}});
  draw_bone(page, {{240.0, 105.0}, {400.0, 100.0}, {400.0, 225.0}, {215.0, 215.0}});
  page.polygon(std::vector<Vec2>{{190.0, 60.0}, {238.0, 62.0}, {215.0, 150.0}}, "strip");
  page.arrow({213.0, 110.0}, {213.0, 40.0}, "cut");
  page.text({460.0, 45.0}, "wedge_closed: turned about the hinge", "head");
  draw_bone(page, {{460.0, 100.0}, {600.0, 105.0}, {630.0, 215.0}, {460.0, 225.0}});
  draw_bone(page, {{611.0, 103.0}, {768.0, 68.0}, {796.0, 190.0}, {633.0, 213.0}});
  page.dot({632.0, 214.0}, 4.0, "corner");
  page.measure({600.0, 105.0}, {611.0, 103.0});
  page.label({575.0, 80.0}, {605.0, 100.0}, "gap_mm");
  page.text({460.0, 255.0}, "contact_share: of the first face, what lies within 0.2 mm");
  page.line({632.0, 214.0}, {830.0, 214.0}, "plan");
  page.line({632.0, 214.0}, {822.0, 186.0}, "cut");
  draw_arc(page, {632.0, 214.0}, {198.0, 0.0}, {190.0, -28.0}, 175.0);
  page.text({806.0, 176.0}, "correction_deg", "words", "middle");
  page.line({815.0, 60.0}, {815.0, 150.0}, "plan");
  page.measure({782.0, 128.0}, {815.0, 128.0});
  page.text({872.0, 60.0}, "shortening_mm", "words", "end");
  return page.take();
}

}  // namespace hallux::tests
