/// A block of noise without seams, sampled by the shaders for all that is irregular in bone and
/// steel. Inside this corner only.
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

/// The relief of a bone's skin over the same clouds and pores, so that a shader has slope and shade
/// at once.
///   red, green, blue   the slope of the height along x, y and z: 0.5 is none
///   alpha              how bright the skin is there, 1 is as it is
struct ReliefVolume {
  NoiseVolume volume;
  /// (byte / 255 - 0.5) * scale is the slope, height [mm] over the block's side.
  double slope_scale = 1.0;
};

ReliefVolume make_relief(const NoiseVolume& noise);

}  // namespace hallux::ui
