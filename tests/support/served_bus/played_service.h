/// A channel to a service of an Inverse3 that is computed: one state for each message, as its
/// maker's pages say.
#pragma once

#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "simulator/device/inverse3/inverse3_driver.h"

namespace hallux::tests {

struct ServiceModel {
  /// Words under which it understands a force.
  std::set<std::string> keys{"values", "vector"};
  std::optional<std::string> version_page;
  nlohmann::json arms = nlohmann::json::array(), grips = nlohmann::json::array();
  /// Of what it is told it gives so much.
  double force_scale = 1.0;
  bool is_absent = false, is_gone = false, is_silent = false, names_arm = true, tells_force = true;
  /// Says that it gives nothing, whatever it was told.
  bool mutes_force = false;
  /// Said in place of a state.
  std::optional<std::string> rubbish;
  int told = 0;
  /// By word, what was told last upwards [N].
  std::map<std::string, double> last_told;
  std::deque<std::string> to_say;

  ServiceModel() { arms.push_back(arm("049D", "inverse3")); }

  static nlohmann::json arm(const std::string& id, const std::string& type) {
    const nlohmann::json zero{{"x", 0.0}, {"y", 0.0}, {"z", 0.0}};
    return {{"device_id", id},
            {"config", {{"type", type}, {"port", "COM12"}}},
            {"state",
             {{"cursor_position", {{"x", 0.0}, {"y", -0.12}, {"z", 0.15}}},
              {"current_cursor_force", zero}}},
            {"status", {{"calibrated", true}}}};
  }

  nlohmann::json& state() { return arms[0]["state"]; }
  /// Of the force that it gives now [N, its own frame].
  double force(const char* axis) { return state()["current_cursor_force"][axis].get<double>(); }

  double last_of(const std::string& key) const {
    const auto found = last_told.find(key);
    return found == last_told.end() ? 0.0 : found->second;
  }

  void say_all(bool is_whole) {
    nlohmann::json all{{"inverse3", nlohmann::json::array()}, {"wireless_verse_grip", grips}};
    if (is_whole) all["session_id"] = 7;
    for (const nlohmann::json& each : arms) {
      if (!names_arm && !is_whole) break;
      all["inverse3"].push_back(each);
      if (is_whole) continue;
      nlohmann::json& said = all["inverse3"].back();
      said.erase("config");
      said.erase("status");
      if (!tells_force) said["state"].erase("current_cursor_force");
    }
    to_say.push_back(rubbish && !is_whole ? *rubbish : all.dump());
  }

  void take(std::string_view text) {
    ++told;
    const nlohmann::json command = nlohmann::json::parse(text);
    const bool is_asked = command.contains("session");
    if (command.contains("inverse3")) {
      const nlohmann::json& force = command["inverse3"][0]["commands"]["set_cursor_force"];
      for (const auto& [key, value] : force.items()) {
        last_told[key] = value["z"].get<double>();
        if (!keys.contains(key) || mutes_force) continue;
        for (const char* axis : {"x", "y", "z"})
          state()["current_cursor_force"][axis] = force_scale * value[axis].get<double>();
      }
    }
    if (!is_silent) say_all(is_asked);
  }
};

class PlayedService final : public simulator::ServiceChannel {
 public:
  /// Borrowed.
  explicit PlayedService(ServiceModel& model) : model_(model) {
    model_.to_say.clear();
    model_.say_all(true);
  }

  simulator::BusAnswer say(std::string_view text) noexcept override {
    if (model_.is_gone) return simulator::BusAnswer::Gone;
    model_.take(text);
    return simulator::BusAnswer::Done;
  }
  simulator::HeardMessage hear(std::chrono::milliseconds) noexcept override {
    if (model_.is_gone) return {simulator::BusAnswer::Gone, {}};
    if (model_.to_say.empty()) return {};
    heard_ = std::move(model_.to_say.front());
    model_.to_say.pop_front();
    if (heard_.size() > simulator::service_message_bytes)
      return {simulator::BusAnswer::Refused, {}};
    return {simulator::BusAnswer::Done, heard_};
  }

 private:
  ServiceModel& model_;
  std::string heard_;
};

inline simulator::InverseAccess access_to(ServiceModel& model) {
  return {[&model]() -> simulator::OpenedService {
            if (model.is_absent)
              return {nullptr, {simulator::DeviceTrouble::NoService, "10001", {}}};
            return {std::make_unique<PlayedService>(model), {}};
          },
          [&model] { return model.version_page; }};
}

}  // namespace hallux::tests
