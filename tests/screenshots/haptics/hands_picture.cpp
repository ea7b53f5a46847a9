// Two columns, an expert's and a novice's hand at Silver; rows over time: push, hottest bone, depth
// of the teeth.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/scenarios/hands/hand_trace.h"
#include "tests/screenshots/haptics/haptic_pictures.h"
#include "tests/screenshots/svg_page.h"
#include "ui/report/html_text.h"

namespace hallux::tests {

namespace {

constexpr double top = 84.0, row_height = 132.0, plot_height = 100.0, plot_width = 330.0;
constexpr double shown_s = 40.0;
constexpr std::uint64_t seed = 2;

/// One row: what it shows of a moment, and its scale.
struct Row {
  double HandMoment::*value;
  double low, high;
  std::string_view name, unit;
  std::array<double, 3> marks;
};
constexpr std::array<Row, 3> rows{
    {{&HandMoment::push_newton, 0.0, 30.0, "push", "N", {0.0, 10.0, 20.0}},
     {&HandMoment::hottest_celsius, 37.0, 125.0, "hottest bone", "degrees C", {47.0, 80.0, 120.0}},
     {&HandMoment::depth_mm, -10.0, 40.0, "depth of the teeth", "mm", {0.0, 20.0, 40.0}}}};

struct Column {
  const char* hand;
  double left;
};
constexpr std::array<Column, 2> columns{{{"expert", 76.0}, {"novice", 470.0}}};

/// Depth grows downwards, the others upwards.
double y_of(const Row& row, double value, double row_top) {
  const double share = std::clamp((value - row.low) / (row.high - row.low), 0.0, 1.0);
  return row.low < 0.0 ? row_top + plot_height * share : row_top + plot_height * (1.0 - share);
}

double x_of(double time_s, double left) {
  return left + plot_width * std::min(1.0, time_s / shown_s);
}

void draw_scale(SvgPage& page, const Row& row, double left, double row_top) {
  for (const double mark : row.marks) {
    const double y = y_of(row, mark, row_top);
    page.line({left, y}, {left + plot_width, y}, mark == 47.0 ? "plan" : "thin");
    page.text({left - 6.0, y + 4.0}, ui::coordinate(mark), "small", "end");
  }
}

/// The bone between the first and the last of the section.
void draw_bone(SvgPage& page, const Row& row, const HandTrace& trace, double left, double row_top) {
  const double near_y = y_of(row, 0.0, row_top), far_y = y_of(row, trace.bone_mm, row_top);
  const std::array<Vec2, 4> bone{Vec2(left, near_y), Vec2(left + plot_width, near_y),
                                 Vec2(left + plot_width, far_y), Vec2(left, far_y)};
  page.polygon(bone, "bonefill");
}

/// A bar over the times at which water ran.
void draw_water(SvgPage& page, const HandTrace& trace, double left, double y) {
  double began_s = -1.0;
  for (const HandMoment& moment : trace.moments) {
    if (moment.is_rinsed && began_s < 0.0) began_s = moment.time_s;
    if (!moment.is_rinsed && began_s >= 0.0) {
      page.line({x_of(began_s, left), y}, {x_of(moment.time_s, left), y}, "water");
      began_s = -1.0;
    }
  }
}

void draw_column(SvgPage& page, const Column& column, const HandTrace& trace) {
  page.text({column.left, 62.0}, column.hand, "head");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    const double row_top = top + row_height * static_cast<double>(i);
    if (row.value == &HandMoment::depth_mm) draw_bone(page, row, trace, column.left, row_top);
    draw_scale(page, row, column.left, row_top);
    std::vector<Vec2> places;
    for (const HandMoment& moment : trace.moments) {
      if (moment.time_s > shown_s) break;
      places.emplace_back(x_of(moment.time_s, column.left), y_of(row, moment.*row.value, row_top));
    }
    page.polyline(places, "wall");
    page.text({column.left + plot_width, row_top - 6.0},
              std::string(row.name) + " [" + std::string(row.unit) + "]", "small", "end");
  }
  draw_water(page, trace, column.left, top + row_height + plot_height + 8.0);
}

/// What the text below the columns says of one hand.
std::array<std::string, 3> said_of(const HandTrace& trace) {
  const auto number = [](double value) { return ui::coordinate(0.1 * std::round(10.0 * value)); };
  return {"force at most " + number(trace.peak_newton) + " N; " + number(trace.beyond_mm) +
              " mm beyond the last bone",
          number(trace.hottest_celsius) + " degrees at most, " + number(trace.hot_s) +
              " s above 47, " + number(trace.necrotic_mm3) + " mm3 lost",
          number(trace.dry_s) + " of " + number(trace.cut_s) +
              " s cut dry; danger zones touched: " + std::to_string(trace.zone_contacts)};
}

}  // namespace

std::string draw_hands() {
  scenarios::Scenario silver = scenarios::load_shipped_scenario("silver");
  silver.patient.edge_mm = 0.8;
  const simulator::Bone bone = make_patient_bones(silver).front();
  const scenarios::Plan plan = plan_on(silver, bone);
  const double bottom = top + row_height * static_cast<double>(rows.size());
  SvgPage page({840.0, bottom + 70.0}, "What an expert's and a novice's hand do at Silver");
  page.add_style("water", "stroke:#2f7fb5;stroke-width:5");
  page.text({20.0, 28.0}, "One attempt at Silver each, seed 2; over 40 s; the blue bar: water runs",
            "head");
  for (const Column& column : columns) {
    scenarios::FeelingHand hand(silver, bone, plan, scenarios::hand_skill(column.hand), seed);
    const HandTrace trace = trace_hand(silver, bone, plan, hand);
    draw_column(page, column, trace);
    double line_y = bottom + 14.0;
    for (const std::string& line : said_of(trace)) {
      page.text({column.left, line_y}, line, "small");
      line_y += 18.0;
    }
  }
  return page.take();
}

}  // namespace hallux::tests
