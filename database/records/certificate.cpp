#include "database/records/certificate.h"

namespace hallux::database {

namespace {

constexpr double tick_us = 1000.0;

bool is_above_share(std::int64_t part, double share, double whole) noexcept {
  return static_cast<double>(part) > share * whole;
}

}  // namespace

Verdict verdict_of(const RecordingCertificate& certificate) {
  using namespace certificate_limits;
  // A line covers its own tick and those missed before it.
  const auto ticks = static_cast<double>(certificate.expected_samples + certificate.missed_ticks);
  Verdict verdict;
  const auto judge = [&verdict](bool is_so, Invalidity reason) {
    if (is_so) verdict.reasons.push_back(reason);
  };
  judge(!certificate.is_complete(), Invalidity::SamplesLost);
  judge(certificate.gaps != 0, Invalidity::TicksLeftOut);
  judge(certificate.duplicates != 0, Invalidity::TicksDoubled);
  judge(certificate.clock_steps != 0, Invalidity::ClockStepped);
  judge(is_above_share(certificate.unsampled_us, unsampled_share_max, ticks * tick_us),
        Invalidity::TimeUnseen);
  judge(is_above_share(certificate.missed_ticks, missed_share_max, ticks), Invalidity::TicksMissed);
  judge(is_above_share(certificate.faulted_ticks, faulted_share_max, ticks),
        Invalidity::DeviceFaulted);
  judge(certificate.has_changed_device, Invalidity::DeviceChanged);
  return verdict;
}

}  // namespace hallux::database
