/// Work without a bound: what a kerf's plane meets, which pieces the kerfs leave, and whether a hinge closes.
///
/// A job is a pure function of the operation at the tick of its request. It is computed beside the step, on a copy of
/// the kerfs that was opened from the same samples, and its result enters the step as the command ApplyJob.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "simulator/cutting/commit_patch.h"
#include "simulator/cutting/hinge.h"
#include "simulator/cutting/kerf_set.h"
#include "simulator/mesh/bone.h"

namespace hallux::simulator {

enum class JobKind : std::int32_t {
  Contact,  ///< slice the bone along a kerf that was just frozen
  Pieces,   ///< commit what the blade has opened and see what comes free
  Hinge     ///< close the wedge beside the planned bridge
};

struct JobRequest {
  std::int32_t id = -1;
  JobKind kind = JobKind::Contact;
  std::int32_t kerf = -1;  ///< the one that asked; none for Hinge
  std::int64_t tick = 0;   ///< the state after this tick is what the job sees
};

/// A bridge that an operation wants left and closed, said in the bone frame.
struct PlannedBridge {
  HingeLine line;
  Vec3 toward_moved{1.0, 0.0, 0.0};  ///< from the half that stays to the one that turns
  double breaks_below_mm = 0.3, bends_up_to_mm = 2.5;
};

struct PieceBody {
  std::int32_t id = 0;  ///< 0 is the bone; what is cut off gets the next number and keeps it
  bool is_new = false;  ///< came free by this job
  double volume_mm3 = 0.0;
  CutSolid solid;
  std::unique_ptr<const Bvh> bvh;
};

/// Never changes once made; the step borrows it for the rest of the attempt.
struct JobResult {
  JobRequest request;
  double section_mm2 = 0.0;             ///< Contact: of the solid as it stood, at the kerf's planes
  std::vector<PieceBody> pieces;        ///< Pieces: without debris, largest first
  std::vector<std::int32_t> completed;  ///< Pieces: kerfs that took their whole section, ascending
  double debris_mm3 = 0.0;              ///< Pieces: in the wound as it is
  double removed_mm3 = 0.0;             ///< Pieces: taken by the blade so far in the attempt
  std::uint32_t nudges = 0;             ///< Pieces: see KerfCut; expected 0
  ClosedHinge hinge;                    ///< Hinge
};

/// The operation as the jobs see it: the solid as cut so far and a copy of the kerfs.
class OperationGeometry {
 public:
  OperationGeometry(const Bone& bone, const Blade& blade, std::optional<PlannedBridge> bridge = {});

  /// Follows what the step gave out; events of a tick before its sample.
  void follow(const CutEvent& event);
  void follow(const ToolSample& sample);
  /// thread  worker, or the caller's in virtual time
  std::unique_ptr<const JobResult> run(const JobRequest& request);

  /// What lies in the wound, as the last job of pieces left it.
  const CutSolid& solid() const noexcept { return solid_; }
  const KerfSet& kerfs() const noexcept { return kerfs_; }
  /// What lies in the wound with all kerfs opened as far as they are now but one (-1: but none), for a display that shows
  /// that one's cut on it. Nothing where a piece that was taken out would hang on the bone again.
  /// thread  the one that follows; changes nothing
  std::optional<CutSolid> solid_without(std::int32_t kerf) const;

 private:
  /// The bone after one more kerf.
  struct Stage {
    CutSolid solid;
    std::unique_ptr<const Bvh> bvh;
    double removed_mm3 = 0.0;  ///< by this kerf
    bool takes_section = false;
    std::uint32_t nudges = 0;
  };
  struct KnownPiece {
    std::int32_t id = 0;
    CutSolid solid;
    std::unique_ptr<const Bvh> bvh;
  };

  void run_contact(JobResult& result);
  void run_pieces(JobResult& result);
  void run_hinge(JobResult& result);
  const Stage& stage_before(std::int32_t kerf);
  void number_pieces(std::vector<CutSolid> solids, JobResult& result);
  std::int32_t inherited_id(const CutSolid& solid, std::vector<std::int32_t>& taken) const;
  bool was_taken_out(const CutSolid& solid) const;
  void take_out(std::int32_t piece);
  void gather_solid();
  std::vector<HingeGap> gaps_of_kerfs(std::vector<std::int32_t>& kerfs);

  KerfSet kerfs_;
  std::optional<PlannedBridge> bridge_;
  Stage whole_;                ///< the bone that was never cut
  std::vector<Stage> stages_;  ///< after kerf 0, 1, ...; those whose fields have not risen since
  CutSolid solid_;
  std::vector<KnownPiece> pieces_;
  std::vector<std::unique_ptr<const Bvh>> taken_out_;
  std::vector<CutSolid> debris_;
  std::int32_t next_piece_ = 1;
};

}  // namespace hallux::simulator
