/// Services of this machine through libwebsockets: opening a channel to one, and asking it a thing.
/// The library is named in the source of this header only. Inside this corner only.
///
/// The address is 127.0.0.1 and nothing else: no name is looked up, no other machine is asked.
#pragma once

#include <cstdint>
#include <optional>

#include "simulator/device/bus/service_channel.h"

namespace hallux::simulator {

/// Waits for it 300 ms at most. Of one that does not answer: NoService.
OpenedService open_service(std::uint16_t port);

/// The body of its answer to a GET of that path; none where there is no such thing, or no service.
/// Waits for it 300 ms at most.
std::optional<std::string> service_page(std::uint16_t port, const std::string& path);

/// The library's own version.
std::string service_library_version();

}  // namespace hallux::simulator
