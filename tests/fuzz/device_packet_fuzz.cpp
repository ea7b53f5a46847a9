/// Feeds any bytes to what reads the packets of devices, in pieces as a bus may cut them: each must
/// be refused or understood, within what its device can say.
#include <cstdlib>

#include "simulator/device/bus/hid_descriptor.h"
#include "simulator/device/falcon/falcon_firmware.h"
#include "simulator/device/falcon/falcon_packet.h"
#include "simulator/device/falcon/ftdi_line.h"
#include "simulator/device/raw_hid_arm/arm_packet.h"
#include "simulator/device/space_mouse/space_mouse_report.h"

namespace {

using namespace hallux::simulator;
using Bytes = std::span<const std::uint8_t>;

void expect(bool is_so) {
  if (!is_so) std::abort();
}

/// The first byte says how long the pieces are.
void read_falcon(Bytes bytes) {
  FalconReports reports;
  const std::size_t piece = bytes.empty() ? 1 : 1 + bytes.front() % 64;
  std::uint64_t whole = 0;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    const Bytes part = ftdi_payload(bytes.subspan(at, std::min(piece, bytes.size() - at)));
    if (reports.take(part)) ++whole;
  }
  expect(whole <= reports.count());
  expect(reports.count() * falcon_packet_bytes <= bytes.size());
}

void read_space_mouse(Bytes bytes) {
  SpaceMouseState state;
  const std::size_t piece = bytes.empty() ? 1 : 1 + bytes.front() % 16;
  for (std::size_t at = 0; at < bytes.size(); at += piece)
    static_cast<void>(take_report(state, bytes.subspan(at, std::min(piece, bytes.size() - at))));
  const Deflection deflection = deflection_of(state, 350);
  for (int axis = 0; axis < 3; ++axis) {
    expect(std::abs(deflection.pushed[axis]) <= 1.0);
    expect(std::abs(deflection.turned[axis]) <= 1.0);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const Bytes all(bytes, size);
  read_falcon(all);
  read_space_mouse(all);
  expect(arm_report(all).has_value() == (size == arm_report_bytes));
  if (const auto limit = axis_limit_in(all)) expect(*limit > 0);
  if (const auto fault = fault_in(all)) expect(fault->byte <= size);
  return 0;
}
