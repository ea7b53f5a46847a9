// Six small plots: rows are laws, columns are rates; how deep the handle goes into a plate, over
// time.
#include <array>
#include <string>
#include <vector>

#include "tests/screenshots/haptics/haptic_pictures.h"
#include "tests/screenshots/svg_page.h"
#include "tests/simulator/device/wall_experiments.h"
#include "ui/report/html_text.h"

namespace hallux::tests {

namespace {

constexpr double row_height = 150.0, top = 70.0, plot_width = 300.0, plot_height = 112.0;
constexpr double least_mm = -8.0, most_mm = 12.0;
constexpr std::size_t shown_ticks = 1500, ticks_per_point = 3;

struct Rate {
  std::int64_t ticks_per_update;
  std::string_view name;
  double left;
};
constexpr std::array<Rate, 2> rates{
    {{17, "60 updates a second", 150.0}, {1, "1000 updates a second", 500.0}}};

struct Law {
  PlateLaw law;
  std::array<std::string_view, 2> name;
};
constexpr std::array<Law, 3> laws{{{PlateLaw::Proxy, {"spring", "to a proxy"}},
                                   {PlateLaw::Penalty, {"penalty: spring", "to nearest face"}},
                                   {PlateLaw::Thesis, {"historic:", "the thesis"}}}};

/// Into the plate is down.
double y_of(double place_mm, double row_top) {
  return row_top + plot_height * (place_mm - least_mm) / (most_mm - least_mm);
}

void draw_plate(SvgPage& page, double left, double row_top) {
  const double near_y = y_of(0.0, row_top), far_y = y_of(plate_mm, row_top);
  const std::array<Vec2, 4> plate{Vec2(left, near_y), Vec2(left + plot_width, near_y),
                                  Vec2(left + plot_width, far_y), Vec2(left, far_y)};
  page.polygon(plate, "bonefill");
  page.line({left, near_y}, {left + plot_width, near_y}, "bone");
  page.line({left, far_y}, {left + plot_width, far_y}, "bone");
  page.text({left - 6.0, near_y + 4.0}, "0", "small", "end");
  page.text({left - 6.0, far_y + 4.0}, ui::coordinate(plate_mm), "small", "end");
}

std::string said_of(const PlateResult& result) {
  if (result.has_fallen_through && result.rest_mm > plate_mm)
    return "through, and out at the far side";
  if (result.range_mm < 0.05) {
    return "at rest " + ui::coordinate(result.rest_mm) + " mm deep";
  }
  return "to and fro " + ui::coordinate(result.range_mm) + " mm, " +
         std::to_string(result.switches) + " switches in 3 s";
}

void draw_plot(SvgPage& page, const Law& law, const Rate& rate, double row_top) {
  const PlateResult result = press_plate(law.law, rate.ticks_per_update);
  draw_plate(page, rate.left, row_top);
  std::vector<Vec2> places;
  for (std::size_t tick = 0; tick < shown_ticks; tick += ticks_per_point) {
    places.emplace_back(rate.left + plot_width * static_cast<double>(tick) / shown_ticks,
                        y_of(result.trace.place_mm[tick], row_top));
  }
  page.polyline(places, "wall");
  page.text({rate.left + plot_width, row_top + plot_height + 14.0}, said_of(result), "small",
            "end");
}

}  // namespace

std::string draw_laws() {
  SvgPage page({840.0, top + 3.0 * row_height + 20.0}, "Three force laws at a plate, at two rates");
  page.text({20.0, 28.0},
            "A hand pushes with 2 N against a plate 5 mm thick; 1 N/mm; how deep the handle is "
            "[mm], for 1.5 s",
            "head");
  for (const Rate& rate : rates) page.text({rate.left, 54.0}, rate.name, "head");
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const double row_top = top + row_height * static_cast<double>(i);
    page.text({20.0, y_of(0.0, row_top)}, laws[i].name[0]);
    page.text({20.0, y_of(0.0, row_top) + 16.0}, laws[i].name[1]);
    for (const Rate& rate : rates) draw_plot(page, laws[i], rate, row_top);
  }
  return page.take();
}

}  // namespace hallux::tests
