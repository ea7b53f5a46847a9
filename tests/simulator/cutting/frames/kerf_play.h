/// Random attempts on a bone: kerf after kerf, each opened in a few frames and then committed.
/// Every frame is shown to whoever asks, before it is forgotten.
#pragma once

#include <functional>

#include "simulator/cutting/solid/commit_patch.h"
#include "tests/simulator/cutting/worlds/random_worlds.h"

namespace hallux::tests {

inline constexpr std::int32_t kerfs_played = 4;
inline constexpr std::int32_t frames_of_kerf = 5;

/// What there is when a frame has been built; all of it lives as long as the call only.
struct PlayedFrame {
  /// As the kerfs before left it.
  const simulator::CutSolid& solid;
  const simulator::SlabSlice& contact;
  const simulator::RegionOutline& region;
  const simulator::SolidPatch& patch;
  const simulator::PatchBuilder& builder;
  /// False: refused, the patch is the frame's before.
  bool is_built = false;
  std::int32_t kerf = 0, frame = 0;
};
using FrameVisitor = std::function<void(const PlayedFrame&)>;
/// The solid after a kerf is committed.
using CommitVisitor = std::function<void(const simulator::CutSolid& solid, std::int32_t kerf)>;

/// The next plane: the same again, parallel at exactly the kerf's width, a wedge of up to 23
/// degrees, across, or anew.
simulator::KerfPlane plane_after(const simulator::KerfPlane& plane, Random& random,
                                 const std::function<simulator::KerfPlane(Random&)>& draw_plane);

/// One of random_bone's.
void play_bone(Random& random, const FrameVisitor& visit, const CommitVisitor& visit_commit);
/// One of lattice_bone's, with everything on quarters of a millimetre.
void play_lattice(Random& random, const FrameVisitor& visit, const CommitVisitor& visit_commit);
/// A given bone, with planes through its box.
void play_mesh(const simulator::IndexedMesh& mesh, Random& random, const FrameVisitor& visit,
               const CommitVisitor& visit_commit);

}  // namespace hallux::tests
