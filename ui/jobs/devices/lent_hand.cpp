#include "ui/jobs/devices/lent_hand.h"

#include "ui/jobs/devices/device_sentences.h"
#include "ui/jobs/devices/device_test.h"

namespace hallux::ui {

namespace {

using simulator::DeviceTrouble;
using simulator::TroubleReport;

}  // namespace

DeviceRefused::DeviceRefused(const TroubleReport& trouble, const simulator::FoundDevice& device)
    : std::runtime_error(trouble_words(trouble, facts_of(device.kind), device.id)) {}

std::optional<simulator::FoundDevice> found_now(simulator::Station& station,
                                                const std::string& id) {
  const std::vector<simulator::FoundDevice> devices = station.look();
  if (const simulator::FoundDevice* found = device_with(devices, id)) return *found;
  if (id != facts_of(simulator::DeviceKind::Inverse3).id) return std::nullopt;
  return simulator::unserved_inverse(service_port(station.settings()));
}

void bring_home(simulator::Station& station, const simulator::FoundDevice& device,
                const Progress& progress) {
  const std::shared_ptr<simulator::DevicePort> port = station.open(device.id);
  if (port && is_brought_home(*port, homed_within_s, progress)) return;
  TroubleReport trouble =
      port ? port->trouble() : TroubleReport{DeviceTrouble::Unplugged, device.address, {}};
  if (!trouble) trouble.trouble = trouble_of_homing(device.kind);
  throw DeviceRefused(trouble, device);
}

std::unique_ptr<simulator::LentDevice> lend_hand(const std::shared_ptr<simulator::Station>& station,
                                                 const simulator::FoundDevice& device,
                                                 const simulator::HandChoice& own,
                                                 const HandStart& start) {
  auto lent = lend(station, device.id,
                   setup_of(*station, device, own, start.world_from_tool, start.world_from_view));
  if (!lent) throw DeviceRefused({DeviceTrouble::Unplugged, device.address, {}}, device);
  return lent;
}

}  // namespace hallux::ui
