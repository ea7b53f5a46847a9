// Two maps side by side, a column a tick of delay, upwards the wall's stiffness: how calm a hand
// rests on it, and theory.
#include <array>
#include <string>

#include "simulator/base/elementary.h"
#include "tests/screenshots/haptics/haptic_pictures.h"
#include "tests/screenshots/svg_page.h"
#include "tests/simulator/device/wall_experiments.h"
#include "ui/report/html_text.h"

namespace hallux::tests {

namespace {

constexpr double bottom = 372.0, octave_height = 48.0, column_width = 62.0;
constexpr double softest_newton_per_mm = 0.25;
constexpr double calm_mm = 0.05, thrown_mm = 1.0;
/// Half of what a device like a Falcon renders.
constexpr double half_of_device_newton_per_mm = 1.5;
constexpr std::array<double, 7> marked_newton_per_mm{0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};

double y_of(double stiffness_newton_per_mm) {
  const double octaves =
      elementary::log(stiffness_newton_per_mm / softest_newton_per_mm) / elementary::log(2.0);
  return bottom - octave_height * octaves;
}

const char* class_of(double range_mm) {
  if (range_mm < calm_mm) return "calm";
  return range_mm < thrown_mm ? "rings" : "thrown";
}

void draw_cells(SvgPage& page, const StabilityColumn& column, double left, bool is_passive) {
  const double half_height = 0.5 * octave_height / 4.0;
  for (const StabilityCell& cell : column.cells) {
    const double y = y_of(cell.stiffness_newton_per_mm);
    const double right = left + column_width - 4.0;
    const std::array<Vec2, 4> box{
        Vec2(left, y - half_height + 0.5), Vec2(right, y - half_height + 0.5),
        Vec2(right, y + half_height - 0.5), Vec2(left, y + half_height - 0.5)};
    page.polygon(box, class_of(is_passive ? cell.passive_range_mm : cell.plain_range_mm));
  }
}

void draw_scale(SvgPage& page, double left) {
  for (const double stiffness : marked_newton_per_mm) {
    page.text({left - 8.0, y_of(stiffness) + 4.0}, ui::coordinate(stiffness), "small", "end");
  }
}

void draw_panel(SvgPage& page, const std::array<StabilityColumn, map_delays>& columns, double left,
                bool is_passive) {
  draw_scale(page, left);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double x = left + column_width * static_cast<double>(i);
    draw_cells(page, columns[i], x, is_passive);
    const double theory_y = y_of(columns[i].theory_newton_per_mm);
    page.line({x - 2.0, theory_y}, {x + column_width - 2.0, theory_y}, "axis");
    const double measured_y = y_of(columns[i].measured_newton_per_mm);
    page.dot({x + 0.5 * column_width - 2.0, measured_y}, 3.5, "node");
    page.text({x + 0.5 * column_width - 2.0, bottom + 26.0}, std::to_string(columns[i].delay_ticks),
              "words", "middle");
  }
  const double right = left + column_width * static_cast<double>(columns.size()) - 4.0;
  const double half_y = y_of(half_of_device_newton_per_mm);
  page.line({left - 2.0, half_y}, {right + 2.0, half_y}, "plan");
  page.text({left, 62.0}, is_passive ? "with the passivity controller" : "the spring alone",
            "head");
  page.text({0.5 * (left + right), bottom + 46.0}, "delay of the force, ticks of 1 ms", "words",
            "middle");
}

void draw_key(SvgPage& page) {
  const double x = 640.0;
  page.key({x, 80.0}, "calm", "rests within 0.05 mm");
  page.key({x, 104.0}, "rings", "to and fro below 1 mm");
  page.key({x, 128.0}, "thrown", "thrown off");
  page.line({x, 160.0}, {x + 14.0, 160.0}, "axis");
  page.text({x + 20.0, 164.0}, "b / (T/2 + dT)");
  page.dot({x + 7.0, 184.0}, 3.5, "node");
  page.text({x + 20.0, 188.0}, "a spring without end,");
  page.text({x + 20.0, 204.0}, "motors without limit");
  page.line({x, 224.0}, {x + 14.0, 224.0}, "plan");
  page.text({x + 20.0, 228.0}, "half of what the");
  page.text({x + 20.0, 244.0}, "device renders");
}

}  // namespace

std::string draw_stability() {
  const auto columns = map_stability();
  SvgPage page({820.0, 436.0}, "Stable stiffness over delay, beside theory");
  page.add_style("calm", "fill:#cfe3f2");
  page.add_style("rings", "fill:#f2c14e");
  page.add_style("thrown", "fill:#d55e00;fill-opacity:.85");
  page.text(
      {20.0, 28.0},
      "A hand pushes with 2 N against a wall; 0.15 kg, b = 5 N s/m, encoder 15 um, motors 8 N",
      "head");
  page.text({20.0, 46.0}, "N/mm", "small");
  draw_panel(page, columns, 60.0, false);
  draw_panel(page, columns, 360.0, true);
  draw_key(page);
  return page.take();
}

}  // namespace hallux::tests
