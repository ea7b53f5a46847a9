#include "tests/benchmarks/report/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "simulator/base/check.h"
#include "tests/benchmarks/report/table.h"
#include "ui/report/html_text.h"

namespace hallux::benchmarks {

namespace {

using ui::escaped;

// Okabe and Ito's colours, yellow (too pale on white) replaced by brown, and grey: told apart by
// all eyes.
constexpr std::array<const char*, 8> colours{"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                                             "#d55e00", "#56b4e9", "#5c5c5c", "#6b3e12"};
constexpr double legend_width = 340.0;

const char* colour_of(std::size_t series) { return colours[series % colours.size()]; }

struct Text {
  double x = 0.0, y = 0.0;
  std::string words;
  const char* anchor = "start";
  int size = 12;
};

class Drawing {
 public:
  Drawing(double width, double height, const std::string& title) {
    svg_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\""
         << height << "\" viewBox=\"0 0 " << width << ' ' << height
         << "\" font-family=\"sans-serif\" fill=\"#222\">\n<title>" << escaped(title)
         << "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    text({20.0, 28.0, title, "start", 16});
  }
  void text(const Text& text) {
    svg_ << "<text x=\"" << text.x << "\" y=\"" << text.y << "\" text-anchor=\"" << text.anchor
         << "\" font-size=\"" << text.size << "\">" << escaped(text.words) << "</text>\n";
  }
  void box(double x, double y, double width, double height, const char* colour) {
    svg_ << "<rect x=\"" << x << "\" y=\"" << y << "\" width=\"" << width << "\" height=\""
         << height << "\" fill=\"" << colour << "\"/>\n";
  }
  void line(double x1, double y1, double x2, double y2) {
    svg_ << "<line x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2 << "\" y2=\"" << y2
         << "\" stroke=\"#d0d0d0\"/>\n";
  }
  void path(const std::string& points, const char* colour) {
    svg_ << "<polyline points=\"" << points << "\" fill=\"none\" stroke=\"" << colour
         << "\" stroke-width=\"1.6\"/>\n";
  }
  std::string take() { return svg_.str() + "</svg>\n"; }

 private:
  std::ostringstream svg_;
};

void draw_legend(Drawing& drawing, const std::vector<Series>& series, double x, double y) {
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double top = y + 18.0 * static_cast<double>(i);
    drawing.box(x, top, 12.0, 12.0, colour_of(i));
    drawing.text({x + 18.0, top + 10.5, series[i].name});
  }
}

/// A linear scale's step: 1, 2 or 5 times a power of ten, four to eight steps in all.
double round_step(double greatest) {
  const double power = std::pow(10.0, std::floor(std::log10(greatest / 4.0)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (greatest / (factor * power) <= 8.0) return factor * power;
  }
  return 10.0 * power;
}

double greatest_of(const std::vector<Series>& series) {
  double greatest = 0.0;
  for (const Series& one : series) {
    for (const double value : one.values) greatest = std::max(greatest, value);
  }
  return greatest;
}

/// Maps logarithms to places; whole decades around the values.
struct DecadeScale {
  double low = 0.0, high = 1.0, left = 0.0, width = 1.0;

  double at(double value) const { return left + width * (std::log10(value) - low) / (high - low); }
};

DecadeScale decades_around(const std::vector<Series>& series, double left, double width) {
  double least = 1e300;
  for (const Series& one : series) {
    for (const double value : one.values) {
      if (value > 0.0) least = std::min(least, value);
    }
  }
  const double greatest = greatest_of(series);
  CHECK(greatest > 0.0);
  const double low = std::floor(std::log10(least) - 0.3);
  return {low, std::max(low + 1.0, std::ceil(std::log10(greatest))), left, width};
}

}  // namespace

std::string draw_bars(const BarChart& chart) {
  constexpr double left = 150.0, width = 560.0, bar = 14.0, gap = 12.0, top = 50.0;
  const double group_height = bar * static_cast<double>(chart.series.size()) + gap;
  const double bottom = top + group_height * static_cast<double>(chart.groups.size());
  Drawing drawing(left + width + legend_width, bottom + 50.0, chart.title);
  const DecadeScale scale = decades_around(chart.series, left, width);
  for (double decade = scale.low; decade <= scale.high; decade += 1.0) {
    const double x = scale.at(std::pow(10.0, decade));
    drawing.line(x, top, x, bottom);
    drawing.text({x, bottom + 16.0, text_of(std::pow(10.0, decade)), "middle"});
  }
  drawing.text({left + 0.5 * width, bottom + 36.0, chart.unit + ", logarithmic", "middle"});
  for (std::size_t group = 0; group < chart.groups.size(); ++group) {
    const double y = top + group_height * static_cast<double>(group) + 0.5 * gap;
    drawing.text({left - 10.0, y + 0.5 * (group_height - gap) + 4.0, chart.groups[group], "end"});
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
      CHECK(chart.series[i].values.size() == chart.groups.size());
      const double value = chart.series[i].values[group];
      const double bar_y = y + bar * static_cast<double>(i);
      if (!(value > 0.0)) continue;
      drawing.box(left, bar_y, scale.at(value) - left, bar - 2.0, colour_of(i));
      drawing.text({scale.at(value) + 4.0, bar_y + 10.5, text_of(value), "start", 11});
    }
  }
  draw_legend(drawing, chart.series, left + width + 60.0, top);
  return drawing.take();
}

std::string draw_lines(const LineChart& chart) {
  constexpr double left = 80.0, width = 620.0, top = 50.0, height = 320.0;
  CHECK(!chart.along.empty() && greatest_of(chart.series) > 0.0);
  Drawing drawing(left + width + legend_width, top + height + 60.0, chart.title);
  const double high = 1.05 * greatest_of(chart.series);
  const double last = *std::max_element(chart.along.begin(), chart.along.end());
  const auto x_of = [&](double value) { return left + width * value / last; };
  const auto y_of = [&](double value) { return top + height * (1.0 - value / high); };
  for (double value = 0.0; value <= high; value += round_step(high)) {
    drawing.line(left, y_of(value), left + width, y_of(value));
    drawing.text({left - 8.0, y_of(value) + 4.0, text_of(value), "end"});
  }
  for (double value = 0.0; value <= last; value += round_step(last)) {
    drawing.text({x_of(value), top + height + 18.0, text_of(value), "middle"});
  }
  drawing.text({left + 0.5 * width, top + height + 40.0, chart.along_name, "middle"});
  drawing.text({left, top - 6.0, chart.value_name});
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    CHECK(chart.series[i].values.size() <= chart.along.size());
    std::ostringstream points;
    for (std::size_t k = 0; k < chart.series[i].values.size(); ++k) {
      points << x_of(chart.along[k]) << ',' << y_of(chart.series[i].values[k]) << ' ';
    }
    drawing.path(points.str(), colour_of(i));
  }
  draw_legend(drawing, chart.series, left + width + 30.0, top);
  return drawing.take();
}

}  // namespace hallux::benchmarks
