#include "ui/jobs/devices/device_test.h"

#include <chrono>
#include <thread>

#include "simulator/base/units.h"
#include "ui/jobs/devices/device_sentences.h"
#include "ui/jobs/devices/felt_wall.h"

namespace hallux::ui {

namespace {

using simulator::DevicePort;
using simulator::PortPhase;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds tick{1};

/// Every millisecond for so long, or until the device is gone.
void exchange(DevicePort& port, const DeviceTest& wanted, const Progress& progress) {
  std::optional<FeltWall> wall;
  const auto limits = port.description().limits;
  if (wanted.wall_newton_per_mm && limits) {
    wall.emplace(*limits, *wanted.wall_newton_per_mm,
                 port.newest().said.device_from_handle.translation_mm);
  }
  const auto begun = Clock::now();
  const std::chrono::duration<double> whole(wanted.seconds);
  auto next = begun;
  for (auto now = begun; now - begun < whole && port.phase() != PortPhase::Ended;
       now = Clock::now()) {
    const Vec3 grip_mm = port.newest().said.device_from_handle.translation_mm;
    if (wall) port.say(wall->force_newton(grip_mm));
    report(progress, (now - begun) / whole);
    next += tick;
    std::this_thread::sleep_until(next);
  }
}

}  // namespace

simulator::DeviceTrouble trouble_of_homing(simulator::DeviceKind kind) noexcept {
  return kind == simulator::DeviceKind::Falcon ? simulator::DeviceTrouble::NotHomed
                                               : simulator::DeviceTrouble::NotCalibrated;
}

bool is_brought_home(DevicePort& port, double within_s, const Progress& progress) {
  const auto end = Clock::now() + std::chrono::duration<double>(within_s);
  while (port.phase() != PortPhase::Running && port.phase() != PortPhase::Ended) {
    if (Clock::now() > end) return false;
    report(progress, 0.0);
    std::this_thread::sleep_for(tick);
  }
  return port.phase() == PortPhase::Running;
}

DeviceTestResult test_device(simulator::Station& station, const std::string& id,
                             const DeviceTest& wanted, const Progress& progress) {
  DeviceTestResult result;
  const std::shared_ptr<DevicePort> port = station.open(id);
  if (!port) {
    result.fault = {simulator::DeviceTrouble::Unplugged, {}, {}};
    return result;
  }
  result.is_homed = is_brought_home(*port, wanted.home_within_s, progress);
  if (result.is_homed) {
    const std::uint64_t before = port->figures().packets;
    const auto begun = Clock::now();
    exchange(*port, wanted, progress);
    const std::chrono::duration<double> took = Clock::now() - begun;
    result.rate_hz = static_cast<double>(port->figures().packets - before) / took.count();
  } else if (port->phase() != PortPhase::Ended) {
    result.fault = {trouble_of_homing(kind_of_device(id)->kind), {}, {}};
  }
  // One that answers too late for a force goes on without one: that is no end, but a fault.
  if (!result.fault) result.fault = port->trouble();
  result.figures = port->figures();
  result.zero_after_packets = result.figures.pushes_unanswered;
  station.close(id);
  return result;
}

}  // namespace hallux::ui
