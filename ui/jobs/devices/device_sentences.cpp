#include "ui/jobs/devices/device_sentences.h"

namespace hallux::ui {

namespace {

using simulator::DeviceKind;
using simulator::DeviceTrouble;

constexpr const char* rules_line =
    "hallux devices rules | sudo tee /etc/udev/rules.d/70-hallux-haptics.rules && sudo udevadm "
    "control --reload && sudo udevadm trigger";

constexpr const char
    *falcon_home = "pull the grip out fully, then push it in until its light turns blue",
    *arm_home = "put the arm into its stand and hold its button for half a second",
    *inverse_home = "calibrate it as its maker's guide says, until its service calls it calibrated";

/// Why nobody but its maker speaks with it.
std::string closed_sentence(DeviceKind kind) {
  if (kind == DeviceKind::ForceDimension)
    return "its maker gives only a closed library, which no open program may carry along";
  if (kind == DeviceKind::FireWireOmni)
    return "it speaks over FireWire, which today's machines and this program do not have";
  return "its maker keeps its protocol closed: only its own driver speaks with it";
}

std::string with(const std::string& words, const std::string& detail) {
  return detail.empty() ? words : words + " (" + detail + ")";
}

}  // namespace

std::string sentence_of(const simulator::TroubleReport& trouble, const simulator::KindFacts& kind) {
  const std::string name(kind.name);
  const std::string& subject = trouble.subject;
  switch (trouble.trouble) {
    case DeviceTrouble::None:
      return {};
    case DeviceTrouble::NoPermission:
      return name + ": this account may not open " + subject;
    case DeviceTrouble::Busy:
      return name + ": another program has it (" + subject + ")";
    case DeviceTrouble::NoFirmware:
      return name + ": it has no firmware of its own, and no file with it was named";
    case DeviceTrouble::BadFirmware:
      return name + ": " + subject + " is no firmware: " + trouble.detail;
    case DeviceTrouble::WrongEcho:
      return name + ": ten times it said its firmware back otherwise than it was sent";
    case DeviceTrouble::NotHomed:
      return name + ": it does not know where its legs are";
    case DeviceTrouble::NotCalibrated:
      return name + ": it does not know where its joints are";
    case DeviceTrouble::NoService:
      return name + ": its service does not answer on this machine at port " + subject;
    case DeviceTrouble::ServiceVersion:
      return with(name + ": its service speaks none of the protocols from 3.1 on that are known",
                  trouble.detail);
    case DeviceTrouble::WrongModel:
      return with(name + ": it is another model", trouble.detail);
    case DeviceTrouble::ClosedProtocol:
      return name + ": " + closed_sentence(kind.kind);
    case DeviceTrouble::BadRecord:
      return name + ": the record of its geometry cannot be used: " + trouble.detail;
    case DeviceTrouble::TooSlow:
      return name + ": it answers later than 3 ms, too late for a force: it is given none";
    case DeviceTrouble::Unplugged:
      return name + ": it was unplugged";
    case DeviceTrouble::Silent:
      return name + ": it has said nothing for 0.2 s";
    case DeviceTrouble::Garbled:
      return name + ": what it says is none of its packets";
    case DeviceTrouble::ServiceGone:
      return name + ": its service has gone";
    case DeviceTrouble::SystemRefused:
      return with(name + ": the system would not open " + subject, trouble.detail);
  }
  return {};
}

std::string mend_of(const simulator::TroubleReport& trouble, const simulator::KindFacts& kind,
                    const std::string& id) {
  switch (trouble.trouble) {
    case DeviceTrouble::NoPermission:
      return rules_line;
    case DeviceTrouble::Busy:
      return "fuser -v " + trouble.subject;
    case DeviceTrouble::NoFirmware:
    case DeviceTrouble::BadFirmware:
      return "hallux devices set " + id + " firmware FILE";
    case DeviceTrouble::WrongEcho:
      return "switch it off and on, use another cable and a socket of the machine itself, then "
             "`hallux devices test " +
             id + "`";
    case DeviceTrouble::NotHomed:
      return falcon_home;
    case DeviceTrouble::NotCalibrated:
      return kind.kind == DeviceKind::Inverse3 ? inverse_home : arm_home;
    case DeviceTrouble::NoService:
      return "start its maker's service; where it listens elsewhere: hallux devices set " +
             std::string(kind.id) + " service_port PORT";
    case DeviceTrouble::ServiceVersion:
      return "install a version 3.1 to 3.5 of the service";
    case DeviceTrouble::BadRecord:
      return "hallux devices set " + id + " geometry FILE";
    case DeviceTrouble::TooSlow:
      return "use a socket of the machine itself, without a hub";
    case DeviceTrouble::Unplugged:
      return "plug it in again";
    case DeviceTrouble::Silent:
    case DeviceTrouble::Garbled:
      return "unplug it, plug it in again, then `hallux devices test " + id + "`";
    case DeviceTrouble::ServiceGone:
      return "start its maker's service again";
    case DeviceTrouble::ClosedProtocol:
      return kind.kind == DeviceKind::FireWireOmni
                 ? ""
                 : "use the mouse, or a device that `docs/haptics.md` lists";
    case DeviceTrouble::None:
    case DeviceTrouble::WrongModel:
    case DeviceTrouble::SystemRefused:
      return {};
  }
  return {};
}

std::string trouble_words(const simulator::TroubleReport& trouble, const simulator::KindFacts& kind,
                          const std::string& id) {
  const std::string mend = mend_of(trouble, kind, id);
  return sentence_of(trouble, kind) + (mend.empty() ? "" : "; " + mend);
}

std::string home_sentence(const simulator::KindFacts& kind) {
  const auto words = [&](std::string_view what) {
    return std::string(kind.name) + ": " + std::string(what) + ".";
  };
  if (kind.kind == DeviceKind::Falcon) return words(falcon_home);
  if (kind.kind == DeviceKind::Inverse3) return words(inverse_home);
  return kind.kind == DeviceKind::RawHidArm ? words(arm_home) : std::string();
}

const simulator::KindFacts* kind_of_device(std::string_view id) noexcept {
  return simulator::kind_named(id.substr(0, id.find_first_of("-@")));
}

}  // namespace hallux::ui
