/// Work without a bound: what a kerf's plane meets, and which pieces a covered section leaves.
///
/// A job is a pure function of the operation at the tick of its request. It is computed beside the step, on a copy of
/// the kerfs that was opened from the same samples, and its result enters the step as the command ApplyJob.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "simulator/cutting/cut.h"
#include "simulator/cutting/kerf_set.h"
#include "simulator/mesh/bone.h"

namespace hallux::simulator {

enum class JobKind : std::int32_t {
  Contact,  ///< slice the bone along a kerf that was just frozen
  Pieces    ///< take the covered slab away and see what comes free
};

struct JobRequest {
  std::int32_t id = -1;
  JobKind kind = JobKind::Contact;
  std::int32_t kerf = -1;
  std::int64_t tick = 0;  ///< the state after this tick is what the job sees
};

struct PieceBody {
  std::int32_t id = 0;  ///< 0 is the largest; a piece keeps its number while nothing cuts it
  bool is_new = false;  ///< came free by this job
  double volume_mm3 = 0.0;
  CutSolid solid;
  std::unique_ptr<const Bvh> bvh;
};

/// Never changes once made; the step borrows it for the rest of the attempt.
struct JobResult {
  JobRequest request;
  Section section;  ///< Contact
  std::vector<std::vector<std::int32_t>>
      nodes;                      ///< Contact: per region the field's nodes that must open
  std::vector<PieceBody> pieces;  ///< Pieces: without debris, largest first
  double debris_mm3 = 0.0;        ///< Pieces: so far in the attempt
  double removed_mm3 = 0.0;       ///< Pieces: taken by the blade so far in the attempt
};

/// The operation as the jobs see it: the solid as cut so far and a copy of the kerfs.
class OperationGeometry {
 public:
  OperationGeometry(const Bone& bone, const BladeSize& blade);

  /// Follows what the step gave out; events of a tick before its sample.
  void follow(const CutEvent& event);
  void follow(const ToolSample& sample);
  /// thread  worker, or the caller's in virtual time
  std::unique_ptr<const JobResult> run(const JobRequest& request);

  const CutSolid& solid() const noexcept { return solid_; }
  const KerfSet& kerfs() const noexcept { return kerfs_; }

 private:
  void run_contact(JobResult& result);
  void run_pieces(JobResult& result);
  void number_pieces(std::vector<CutSolid> solids, JobResult& result);
  void take_out(std::int32_t piece);

  struct KnownPiece {
    std::int32_t id = 0;
    CutSolid solid;
  };
  struct KerfSection {
    Section section;
    SectionMask mask;
  };

  KerfSet kerfs_;
  CutSolid solid_;
  std::unique_ptr<const Bvh> bvh_;
  std::vector<KerfSection> sections_;
  std::vector<KnownPiece> pieces_;
  std::vector<CutSolid> debris_;
  std::int32_t next_piece_ = 1;
  double removed_mm3_ = 0.0;
};

}  // namespace hallux::simulator
