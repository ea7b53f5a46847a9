/// Random frames by the thousand: each is checked, and what they were is counted.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/simulator/cutting/frames/kerf_play.h"

namespace hallux::tests {

/// What frames were; one frame may be several of these.
struct FrameCount {
  std::uint64_t frames = 0;
  /// The region reached bone.
  std::uint64_t intersected = 0;
  /// Bone was taken and the slab's bone was not taken wholly.
  std::uint64_t partial = 0;
  /// The solid shown has more bodies than the kerf found.
  std::uint64_t severed = 0;
  /// A skin was reached that runs around a hole of the section.
  std::uint64_t nested = 0;
  std::uint64_t commits = 0;
  /// Each names the world's seed, the kerf and the frame.
  std::vector<std::string> faults;
};

/// Plays the world of a seed, every fourth a lattice, and checks each frame and each commit:
/// nothing is refused, the shown mesh is closed, volumes add up by an independent route, what was
/// removed never shrinks.
void count_world(std::uint64_t seed, FrameCount& count);
/// The same on a given bone.
void count_mesh(const simulator::IndexedMesh& mesh, std::uint64_t seed, FrameCount& count);

/// The counts in one line, with shares.
std::string sentence_of(const FrameCount& count);
/// Faults, or a share of at most 10 percent: then the run was not what it claims to be. Empty: all
/// is well.
std::vector<std::string> complaints(const FrameCount& count);

}  // namespace hallux::tests
