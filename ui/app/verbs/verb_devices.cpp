/// devices, with rules, set and test: what is plugged in, why it can be used or not, and how to
/// mend it. It needs no database: settings lie beside it.
#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <iomanip>
#include <memory>
#include <ostream>

#include "simulator/base/embedded.h"
#include "simulator/device/station/station.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/station_access.h"
#include "ui/jobs/devices/device_sentences.h"
#include "ui/jobs/devices/device_test.h"
#include "ui/jobs/devices/devices_file.h"

namespace hallux::ui {

std::span<const EmbeddedText> udev_rules() noexcept;

namespace {

using nlohmann::ordered_json;
using simulator::FoundDevice;

ordered_json device_json(const FoundDevice& device) {
  const simulator::KindFacts& kind = facts_of(device.kind);
  return {
      {"id", device.id},
      {"kind", kind.id},
      {"class", kind.device_class.empty() ? ordered_json() : ordered_json(kind.device_class)},
      {"name", device.name},
      {"library", kind.library.empty() ? ordered_json() : ordered_json(kind.library)},
      {"address", device.address},
      {"usable", device.is_usable()},
      {"reason", device.is_usable() ? ordered_json() : ordered_json(id_of(device.trouble.trouble))},
      {"sentence", sentence_of(device.trouble, kind)},
      {"mend", mend_of(device.trouble, kind, device.id)}};
}

ordered_json libraries_json() {
  ordered_json libraries = ordered_json::object();
  for (const auto& [name, version] : simulator::device_libraries()) libraries[name] = version;
  return libraries;
}

void print_device(std::ostream& out, const FoundDevice& device) {
  const simulator::KindFacts& kind = facts_of(device.kind);
  out << std::left << std::setw(24) << device.id << std::setw(8)
      << (kind.device_class.empty() ? "-" : kind.device_class) << std::setw(10)
      << (device.is_usable() ? "usable" : "not usable") << "  " << terminal_text(device.name);
  if (!device.address.empty()) out << "  " << terminal_text(device.address);
  out << "\n";
  if (device.is_usable()) return;
  out << "    " << terminal_text(sentence_of(device.trouble, kind)) << "\n";
  const std::string mend = mend_of(device.trouble, kind, device.id);
  if (!mend.empty()) out << "    " << terminal_text(mend) << "\n";
}

ExitCode list_devices_on(const VerbContext& context) {
  simulator::Buses buses;
  const std::vector<FoundDevice> devices =
      find_devices(buses, read_devices(context.data_directory));
  auto rows = ordered_json::array();
  for (const FoundDevice& each : devices) rows.push_back(device_json(each));
  answer(context, {{"devices", rows}, {"libraries", libraries_json()}}, [&](std::ostream& out) {
    for (const FoundDevice& each : devices) print_device(out, each);
  });
  return ExitCode::Done;
}

ExitCode print_rules_on(const VerbContext& context) {
  const std::string_view text = udev_rules().front().text;
  answer(context, {{"file", "70-hallux-haptics.rules"}, {"rules", text}},
         [&](std::ostream& out) { out << text; });
  return ExitCode::Done;
}

struct SetOptions {
  std::string id, key, value;
};

ExitCode set_device_on(const VerbContext& context, const SetOptions& options) {
  set_device(context.data_directory, options.id, options.key, options.value);
  answer(context, {{"id", options.id}, {"key", options.key}, {"value", options.value}},
         [&](std::ostream& out) {
           out << options.id << ": " << options.key
               << (options.value.empty() ? " is not set any more" : " is set") << "\n";
         });
  return ExitCode::Done;
}

ordered_json test_json(const std::string& id, const DeviceTestResult& result) {
  const simulator::PortFigures& figures = result.figures;
  return {{"id", id},
          {"exchanges", figures.exchanges},
          {"bad_packets", figures.bad_packets},
          {"late_packets", figures.late_packets},
          {"round_trip_us",
           {{"p50", figures.round_trip_p50_us},
            {"p99", figures.round_trip_p99_us},
            {"max", figures.round_trip_max_us}}},
          {"rate_hz", result.rate_hz},
          {"homed", result.is_homed},
          {"greatest_force_newton", figures.greatest_force_newton},
          {"own_force_scale", or_null(figures.own_force_scale)},
          {"fault", result.fault ? ordered_json(id_of(result.fault.trouble)) : ordered_json()},
          {"zero_after_packets", result.zero_after_packets}};
}

ExitCode test_device_on(const VerbContext& context, const std::string& id,
                        const DeviceTest& wanted) {
  const std::unique_ptr<simulator::Station> station = open_station(context);
  const simulator::KindFacts& kind = facts_of(usable_device(*station, id).kind);
  const DeviceTestResult result =
      test_device(*station, id, wanted, progress_on(context, "Testing " + id));
  answer(context, test_json(id, result), [&](std::ostream& out) {
    const simulator::PortFigures& figures = result.figures;
    out << id << ": " << figures.exchanges << " exchanges, " << figures.bad_packets
        << " bad packets, " << std::fixed << std::setprecision(0) << result.rate_hz
        << " a second; round trip " << figures.round_trip_p50_us << " us (p50), "
        << figures.round_trip_p99_us << " us (p99), " << figures.round_trip_max_us << " us (max)\n";
    if (!result.fault) return;
    out << terminal_text(sentence_of(result.fault, kind)) << "\n    "
        << terminal_text(mend_of(result.fault, kind, id)) << "\n";
  });
  return result.fault ? ExitCode::CheckFailed : ExitCode::Done;
}

/// "firmware (of falcon: the file ...), ...".
std::string words_of_keys() {
  std::string words;
  for (const DeviceKey& key : device_keys()) {
    words += (words.empty() ? "" : "; ") + std::string(key.name) + ": ";
    if (!key.kind.empty()) words += "of " + std::string(key.kind) + ", ";
    words += key.what;
  }
  return words;
}

void add_test(CLI::App& devices, VerbContext& context) {
  auto id = std::make_shared<std::string>();
  auto wanted = std::make_shared<DeviceTest>();
  CLI::App* test = devices.add_subcommand(
      "test", "open a device, home it and exchange with it; no force unless --wall asks");
  test->add_option("id", *id, "as `hallux devices` names it")->required();
  test->add_option("--seconds", wanted->seconds, "how long to exchange, once it is homed")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  test->add_option("--home-within", wanted->home_within_s,
                   "how many seconds somebody has to bring its grip home")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  test->add_option("--wall", wanted->wall_newton_per_mm,
                   "a wall where the grip is after homing, held from both sides, so stiff")
      ->check(CLI::Range(0.01, 5.0));
  choose(*test, context, [id, wanted, &context] { return test_device_on(context, *id, *wanted); });
}

}  // namespace

void add_devices_verb(CLI::App& app, VerbContext& context) {
  CLI::App* devices =
      app.add_subcommand("devices", "what is plugged in, and why it can be used or not");
  // The parent's callback comes after that of a verb below it.
  devices->callback([devices, &context] {
    if (!devices->get_subcommands().empty()) return;
    context.chosen = [&context] { return list_devices_on(context); };
  });
  CLI::App* rules = devices->add_subcommand(
      "rules", "print the udev file that lets whoever sits here open the devices");
  choose(*rules, context, [&context] { return print_rules_on(context); });
  auto options = std::make_shared<SetOptions>();
  CLI::App* set =
      devices->add_subcommand("set", "set a value for a device, or for all of its kind");
  set->add_option("id", options->id, "a device or a kind")->required();
  set->add_option("key", options->key, words_of_keys())->required();
  set->add_option("value", options->value, "empty: not set any more")->required();
  choose(*set, context, [options, &context] { return set_device_on(context, *options); });
  add_test(*devices, context);
}

}  // namespace hallux::ui
