#include "scenarios/read_rubric.h"

#include "scenarios/metric_names.h"

namespace hallux::scenarios {
namespace {

constexpr double metric_value_max = 1000.0;

const MetricName& read_metric(const JsonNode& node) {
  const MetricName* metric = find_metric(node.name());
  if (metric == nullptr) {
    std::string mend = "use one of:";
    for (const MetricName& known : known_metrics()) mend += " " + std::string(known.name);
    node.refuse_value(mend);
  }
  return *metric;
}

RubricGroup read_group(const JsonNode& node) {
  node.expect_keys({"name", "title", "weight", "origin"}, {"not_measured"});
  return {.name = node.at("name").name(),
          .title = node.at("title").text(1, 120),
          .weight_milli = node.at("weight").milli(0.0, 100.0),
          .origin = node.at("origin").text(1, 1000),
          .not_measured_milli =
              node.has("not_measured") ? node.at("not_measured").milli(0.001, 100.0) : 0};
}

void read_band(const JsonNode& node, RubricItem& item) {
  const std::vector<JsonNode> knots = node.list(4, 4);
  item.is_band = true;
  item.zero_low = knots[0].number(-metric_value_max, metric_value_max);
  item.full_low = knots[1].number(-metric_value_max, metric_value_max);
  item.full_high = knots[2].number(-metric_value_max, metric_value_max);
  item.zero_high = knots[3].number(-metric_value_max, metric_value_max);
  if (!(item.zero_low < item.full_low && item.full_low <= item.full_high &&
        item.full_high < item.zero_high)) {
    node.refuse_value("give four rising numbers: zero, full, full, zero");
  }
}

RubricItem read_item(const JsonNode& node) {
  node.expect_keys({"id", "title", "group", "metric", "weight", "origin", "provisional"},
                   {"cut", "hinge", "full", "zero", "band"});
  const MetricName& metric = read_metric(node.at("metric"));
  RubricItem item;
  item.id = node.at("id").text(1, 16);
  item.title = node.at("title").text(1, 120);
  item.group = node.at("group").name();
  item.metric = metric.name;
  item.unit = metric.unit;
  item.cut = node.name_where_given("cut");
  item.hinge = node.name_where_given("hinge");
  item.weight_milli = node.at("weight").milli(0.001, 100.0);
  item.origin = node.at("origin").text(1, 1000);
  item.is_provisional = node.at("provisional").boolean();
  const bool has_line = node.has("full") && node.has("zero");
  if (node.has("full") != node.has("zero") || node.has("band") == has_line) {
    node.refuse_value("give either both \"full\" and \"zero\", or \"band\"");
  }
  if (node.has("band")) {
    read_band(node.at("band"), item);
    return item;
  }
  item.full = node.at("full").number(0.0, metric_value_max);
  item.zero = node.at("zero").number(0.0, metric_value_max);
  if (!(item.full < item.zero)) node.at("zero").refuse_value("give more than \"full\"");
  return item;
}

Gate read_gate(const JsonNode& node) {
  node.expect_keys({"name", "title", "metric", "cap", "origin", "provisional"},
                   {"cut", "hinge", "limit", "at_least"});
  const MetricName& metric = read_metric(node.at("metric"));
  const bool is_at_least = node.has("at_least");
  if (is_at_least == node.has("limit")) {
    node.refuse_value("give either \"limit\", the most that is allowed, or \"at_least\"");
  }
  return {.name = node.at("name").name(),
          .title = node.at("title").text(1, 120),
          .metric = std::string(metric.name),
          .cut = node.name_where_given("cut"),
          .unit = std::string(metric.unit),
          .limit = node.at(is_at_least ? "at_least" : "limit").number(0.0, metric_value_max),
          .cap_milli = node.at("cap").milli(0.0, 99.0),
          .origin = node.at("origin").text(1, 1000),
          .is_provisional = node.at("provisional").boolean(),
          .hinge = node.name_where_given("hinge"),
          .is_at_least = is_at_least};
}

}  // namespace

Rubric read_rubric(const JsonNode& node) {
  node.expect_keys({"version", "groups", "items", "gates"});
  Rubric rubric;
  rubric.version = node.at("version").integer(1, 1'000'000);
  for (const JsonNode& group : node.at("groups").list(1, 16)) {
    rubric.groups.push_back(read_group(group));
  }
  for (const JsonNode& item : node.at("items").list(1, 64)) {
    rubric.items.push_back(read_item(item));
  }
  for (const JsonNode& gate : node.at("gates").list(0, 16)) {
    rubric.gates.push_back(read_gate(gate));
  }
  return rubric;
}

}  // namespace hallux::scenarios
