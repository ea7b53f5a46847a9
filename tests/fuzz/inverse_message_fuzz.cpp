/// Feeds any bytes to what reads the messages of an Inverse3's service: each must be refused or
/// understood, within what an arm can say, and what is said back must be JSON whatever the id was.
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "simulator/device/inverse3/inverse_message.h"

namespace {

using namespace hallux;
using namespace hallux::simulator;

void expect(bool is_so) {
  if (!is_so) std::abort();
}

void look_at(const InverseArm& arm) {
  constexpr double number_most = 1000.0;
  for (const std::optional<Vec3>& each : {arm.cursor_m, arm.force_newton})
    for (int axis = 0; each && axis < 3; ++axis) expect(std::abs((*each)[axis]) <= number_most);
  const std::string said = inverse_force(arm.id, InverseForceKey::Vector, {1.0, -2.0, 0.0});
  expect(nlohmann::json::parse(said)["inverse3"][0]["device_id"] == arm.id);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  static_cast<void>(inverse_version(text));
  const std::optional<InverseMessage> message = inverse_message(text);
  if (!message) return 0;
  expect(message->arm_count <= inverse_arms_most && message->grip_count <= inverse_grips_most);
  for (std::size_t i = 0; i < message->arm_count; ++i) look_at(message->arms[i]);
  for (std::size_t i = 0; i < message->grip_count; ++i) {
    const auto& rotation = message->grips[i].rotation;
    if (rotation) expect(std::abs(glm::length(*rotation) - 1.0) < 1e-9);
  }
  return 0;
}
