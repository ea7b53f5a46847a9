/// A block of noise without seams, sampled by the shaders for all that is irregular in bone and steel.
#pragma once

#include <cstdint>
#include <vector>

namespace hallux::ui {

/// Cells of four bytes, x running fastest:
///   red    clouds: smooth noise of three octaves
///   green  pores: distance to the nearest of scattered points, over the distance to the next
///   blue   clouds again, other ones
///   alpha  grain: fine noise
/// Each is periodic in all directions.
struct NoiseVolume {
  std::uint32_t side = 0;
  std::vector<std::uint8_t> rgba;
};

/// ensures the same block each time
/// needs   side is a power of two, at least 32
NoiseVolume make_noise(std::uint32_t side);

}  // namespace hallux::ui
