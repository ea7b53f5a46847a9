/// The devices of this station: what is plugged in and why it can be used or not, which one
/// operates, and how one feels in the hand.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/jobs/devices/felt_device.h"
#include "ui/jobs/devices/own_station.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

class DevicesScreen : public Screen {
 public:
  DevicesScreen(std::shared_ptr<SignedInSession> signed_in, std::shared_ptr<OwnStation> station)
      : signed_in_(std::move(signed_in)), own_(std::move(station)) {}

  GuideSection guide_section() const override { return GuideSection::Devices; }
  std::string_view navigation_id() const override { return "nav.devices"; }
  /// Somebody else wants it, or nobody looks: it is let go.
  void leave(Shell&) override;
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  using Device = simulator::FoundDevice;

  simulator::Station& station() { return *station_.value(); }
  const Device* chosen() const;
  void draw_table(Ui& ui, const Rect& content, const Preferences& preferences);
  void draw_chosen(Ui& ui, const Rect& rect, Shell& shell);
  void draw_choice(Ui& ui, Rect& rest, const Device& device, Preferences& preferences) const;
  /// Why it cannot be used, and the line that mends it.
  void draw_trouble(Ui& ui, Rect& rest, const Device& device, Shell& shell) const;
  /// What is set for the station, and what the person chose over it.
  void draw_settings(Ui& ui, Rect& rest, const Device& device, Shell& shell);
  void set(Ui& ui, Shell& shell, const Device& device, std::string_view key,
           const std::string& value);
  void draw_feel(Ui& ui, Rect rest, const Device& device, Shell& shell);
  void draw_felt(Ui& ui, Rect rest, const simulator::KindFacts& kind);
  void open(Ui& ui, Shell& shell, const Device& device);

  std::shared_ptr<SignedInSession> signed_in_;
  std::shared_ptr<OwnStation> own_;
  Loaded<std::shared_ptr<simulator::Station>> station_;
  /// As of this frame.
  std::vector<Device> devices_;
  std::string chosen_ = std::string(mouse_id);
  TableState table_;
  /// While one is felt.
  std::unique_ptr<FeltDevice> felt_;
  /// Nobody looks any more: what is being opened is let go at once.
  bool is_left_ = false;
  ScreenWork opening_, setting_;
};

}  // namespace hallux::ui
