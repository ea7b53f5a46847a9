// The committed pictures are those that are drawn today, and each metric's row in docs/metrics.md
// links one that names it.
#include "tests/screenshots/metrics/metric_pictures.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "scenarios/metric_names.h"

namespace hallux::tests {
namespace {

const std::filesystem::path docs = HALLUX_DOCS;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::map<std::string, std::string> drawn() {
  std::map<std::string, std::string> pictures;
  for (const Picture& picture : metric_pictures()) pictures[picture.name] = picture.svg;
  return pictures;
}

/// The lines of the table under a heading of docs/metrics.md.
std::vector<std::string> rows_under(const std::string& heading) {
  const std::string page = text_of(docs / "metrics.md");
  const std::size_t begin = page.find("\n## " + heading + "\n");
  EXPECT_NE(begin, std::string::npos) << heading;
  std::istringstream part(page.substr(begin + 1, page.find("\n## ", begin + 1) - begin));
  std::vector<std::string> rows;
  for (std::string line; std::getline(part, line);) {
    if (line.starts_with("| ")) rows.push_back(line);
  }
  return rows;
}

/// The first row in which the metric stands; empty where none does.
std::string row_of(const std::vector<std::string>& rows, std::string_view metric) {
  for (const std::string& row : rows) {
    if (row.find("`" + std::string(metric) + "`") != std::string::npos) return row;
  }
  return {};
}

TEST(MetricPictures, AreTheCommittedOnesToTheLastByte) {
  const auto pictures = drawn();
  for (const auto& [name, svg] : pictures) {
    EXPECT_TRUE(text_of(docs / "pictures" / "metrics" / (name + ".svg")) == svg)
        << name << " is out of date: build the target `screenshots`, look at it, commit it";
    EXPECT_LT(svg.size(), 250U * 1024U) << name;
    EXPECT_EQ(svg.find("not a number"), std::string::npos) << name;
  }
  for (const auto& entry : std::filesystem::directory_iterator(docs / "pictures" / "metrics"))
    EXPECT_TRUE(pictures.contains(entry.path().stem().string()))
        << entry.path() << " is made by nothing";
}

TEST(MetricPictures, AreAllShownInTheText) {
  const std::string text = text_of(docs / "metrics.md");
  for (const auto& [name, svg] : drawn())
    EXPECT_NE(text.find("](pictures/metrics/" + name + ".svg)"), std::string::npos) << name;
}

TEST(MetricPictures, EachMetricsRowLinksThePictureThatNamesIt) {
  const auto pictures = drawn();
  const std::vector<std::string> rows = rows_under("Moments and places");
  for (const scenarios::MetricName& metric : scenarios::known_metrics()) {
    const std::string row = row_of(rows, metric.name);
    ASSERT_FALSE(row.empty()) << metric.name << " has no row";
    bool is_named = false;
    for (const auto& [name, svg] : pictures) {
      const bool is_linked = row.find("](pictures/metrics/" + name + ".svg)") != std::string::npos;
      if (is_linked && svg.find(metric.name) != std::string::npos) is_named = true;
    }
    EXPECT_TRUE(is_named) << metric.name << ": no picture of its row names it";
  }
}

TEST(MetricPictures, EachMetricSaysHowSureItIs) {
  const std::vector<std::string> rows = rows_under("How sure");
  for (const scenarios::MetricName& metric : scenarios::known_metrics())
    EXPECT_FALSE(row_of(rows, metric.name).empty()) << metric.name;
}

}  // namespace
}  // namespace hallux::tests
