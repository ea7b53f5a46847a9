#include "scenarios/read_rubric.h"

#include "scenarios/metric_names.h"
#include "simulator/device/device_class.h"

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

Knots read_band(const JsonNode& node) {
  const std::vector<JsonNode> given = node.list(4, 4);
  const Knots knots{.is_band = true,
                    .zero_low = given[0].number(-metric_value_max, metric_value_max),
                    .full_low = given[1].number(-metric_value_max, metric_value_max),
                    .full_high = given[2].number(-metric_value_max, metric_value_max),
                    .zero_high = given[3].number(-metric_value_max, metric_value_max)};
  if (!(knots.zero_low < knots.full_low && knots.full_low <= knots.full_high &&
        knots.full_high < knots.zero_high)) {
    node.refuse_value("give four rising numbers: zero, full, full, zero");
  }
  return knots;
}

/// What lies on both sides of what was planned, or of 0, has its points in a band.
void check_has_one_side(const JsonNode& node, const MetricName& metric) {
  if (metric.sense != MetricSense::Band || !metric.is_signed) return;
  node.refuse_value("give \"band\": " + std::string(metric.name) + " may lie on both sides");
}

Knots read_line(const JsonNode& node, const MetricName& metric) {
  check_has_one_side(node, metric);
  const double low = metric.is_signed ? -metric_value_max : 0.0;
  const Knots knots{.full = node.at("full").number(low, metric_value_max),
                    .zero = node.at("zero").number(low, metric_value_max)};
  if (metric.sense == MetricSense::Higher) {
    if (!(knots.full > knots.zero)) node.at("zero").refuse_value("give less than \"full\"");
  } else if (!(knots.full < knots.zero)) {
    node.at("zero").refuse_value("give more than \"full\"");
  }
  return knots;
}

Knots read_knots(const JsonNode& node, const MetricName& metric) {
  const bool has_line = node.has("full") && node.has("zero");
  if (node.has("full") != node.has("zero") || node.has("band") == has_line) {
    node.refuse_value("give either both \"full\" and \"zero\", or \"band\"");
  }
  return has_line ? read_line(node, metric) : read_band(node.at("band"));
}

DeviceKnots read_device_knots(const JsonNode& node, const MetricName& metric) {
  node.expect_keys({"device", "origin"}, {"full", "zero", "band"});
  DeviceKnots made{.device_class = node.at("device").name(),
                   .knots = read_knots(node, metric),
                   .origin = node.at("origin").text(1, 1000)};
  if (simulator::is_device_class(made.device_class)) return made;
  std::string mend = "use one of:";
  for (const std::string_view known : simulator::device_classes) mend += " " + std::string(known);
  node.at("device").refuse_value(mend);
}

/// What an item or a gate is about.
template <typename Part>
void read_subject(const JsonNode& node, Part& part) {
  part.cut = node.name_where_given("cut");
  part.hinge = node.name_where_given("hinge");
  part.zone = node.name_where_given("zone");
  part.fragment = node.name_where_given("fragment");
  part.implant = node.name_where_given("implant");
}

RubricItem read_item(const JsonNode& node) {
  node.expect_keys(
      {"id", "title", "group", "metric", "weight", "origin", "provisional"},
      {"cut", "hinge", "zone", "fragment", "implant", "full", "zero", "band", "devices"});
  const MetricName& metric = read_metric(node.at("metric"));
  RubricItem item;
  static_cast<Knots&>(item) = read_knots(node, metric);
  item.id = node.at("id").text(1, 16);
  item.title = node.at("title").text(1, 120);
  item.group = node.at("group").name();
  item.metric = metric.name;
  item.unit = metric.unit;
  read_subject(node, item);
  item.weight_milli = node.at("weight").milli(0.001, 100.0);
  item.origin = node.at("origin").text(1, 1000);
  item.is_provisional = node.at("provisional").boolean();
  if (!node.has("devices")) return item;
  for (const JsonNode& entry : node.at("devices").list(1, simulator::device_classes.size())) {
    item.device_knots.push_back(read_device_knots(entry, metric));
  }
  return item;
}

Gate read_gate(const JsonNode& node) {
  node.expect_keys({"name", "title", "metric", "cap", "origin", "provisional"},
                   {"cut", "hinge", "zone", "fragment", "implant", "limit", "at_least"});
  const MetricName& metric = read_metric(node.at("metric"));
  const bool is_at_least = node.has("at_least");
  if (is_at_least == node.has("limit")) {
    node.refuse_value("give either \"limit\", the most that is allowed, or \"at_least\"");
  }
  Gate gate;
  gate.name = node.at("name").name();
  gate.title = node.at("title").text(1, 120);
  gate.metric = metric.name;
  gate.unit = metric.unit;
  gate.limit = node.at(is_at_least ? "at_least" : "limit").number(0.0, metric_value_max);
  gate.cap_milli = node.at("cap").milli(0.0, 99.0);
  gate.origin = node.at("origin").text(1, 1000);
  gate.is_provisional = node.at("provisional").boolean();
  gate.is_at_least = is_at_least;
  read_subject(node, gate);
  return gate;
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
