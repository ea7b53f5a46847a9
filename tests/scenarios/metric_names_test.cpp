#include "scenarios/metric_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "simulator/base/embedded.h"

namespace hallux::scenarios_test {

std::span<const EmbeddedText> metric_files() noexcept;

}  // namespace hallux::scenarios_test

namespace hallux::scenarios {
namespace {

std::string_view file_named(std::string_view name) {
  for (const EmbeddedText& file : scenarios_test::metric_files())
    if (file.name == name) return file.text;
  ADD_FAILURE() << name << " is not compiled in";
  return {};
}

std::vector<std::string> ids() {
  std::vector<std::string> names;
  for (const MetricName& metric : known_metrics()) names.emplace_back(metric.name);
  return names;
}

TEST(MetricNames, AreThoseThatTheSchemaAllows) {
  const auto schema = nlohmann::json::parse(file_named("scenario.schema.json"));
  const auto allowed = schema.at("$defs").at("metric").at("enum").get<std::vector<std::string>>();
  EXPECT_THAT(allowed, testing::UnorderedElementsAreArray(ids()));
}

TEST(MetricNames, AreDescribed) {
  const std::string page(file_named("metrics.md"));
  for (const std::string& id : ids())
    EXPECT_THAT(page, testing::HasSubstr("`" + id + "`")) << "docs/metrics.md";
}

TEST(MetricNames, EndInTheUnitThatTheyAreSaidIn) {
  for (const MetricName& metric : known_metrics()) {
    EXPECT_EQ(find_metric(metric.name)->metric, metric.metric);
    EXPECT_EQ(name_of(metric.metric), metric.name);
    if (metric.unit.empty()) continue;
    EXPECT_TRUE(metric.name.ends_with("_" + std::string(metric.unit))) << metric.name;
  }
}

}  // namespace
}  // namespace hallux::scenarios
