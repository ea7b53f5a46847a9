/// How well an attempt was recorded, and what an arm made of its force: kept with the attempt as a
/// JSON text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "database/recording/recorder.h"
#include "database/records/certificate.h"
#include "simulator/device/device_facts.h"
#include "simulator/loop/attempt_loop.h"

namespace hallux::ui {

/// How much of what happened was kept. An attempt with gaps is stored with their count.
struct Quality {
  database::RecordingCertificate certificate;
  /// Device newtons per simulated newton; 1 where nobody is pushed back.
  double force_scale = 1.0;
  /// Bits of simulator::ForceLimit that occurred.
  std::uint32_t force_limits = 0;
  /// What the arm was made to feel.
  simulator::ForceLaw force_law = simulator::ForceLaw::Simulated;
  /// With what it was operated; none: a mouse, a script or a modelled arm.
  std::optional<simulator::DeviceFacts> device = std::nullopt;
  /// The kind's id of what the other hand held; empty: none.
  std::string second_device = {};
};

Quality quality_of(const simulator::LoopStatistics& loop,
                   const database::RecorderStatistics& recorder);

/// The words of a law in JSON and on the command line.
const char* name_of(simulator::ForceLaw law) noexcept;
std::optional<simulator::ForceLaw> force_law_from(const std::string& name) noexcept;

std::string quality_json(const Quality& quality);
/// What quality_json wrote, the verdict left out. What an older program did not write yet is as
/// where nobody is pushed back; limits that this one does not know are left out. Nothing where the
/// text is no such object, or its force law is none that is known.
std::optional<Quality> quality_from_json(const std::string& json);

}  // namespace hallux::ui
