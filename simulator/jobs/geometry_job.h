/// Work without a bound: what a kerf's plane meets, which pieces the kerfs leave, and whether a
/// hinge closes. Inside this room only.
///
/// A job is a pure function of the attempt at the tick of its request. It is computed beside the
/// step, on a copy of the kerfs that was opened from the same samples, and its result enters the
/// step as the command ApplyJob.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "simulator/bone/close_bridge.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/mesh/bone.h"

namespace hallux::simulator {

enum class JobKind : std::int32_t {
  /// Slice the bone along a kerf that was just frozen.
  Section,
  /// Commit what the blade has opened and see what comes free.
  Pieces,
  /// Close the wedge beside the planned bridge.
  Hinge
};

struct JobRequest {
  std::int32_t id = -1;
  JobKind kind = JobKind::Section;
  /// The one that asked; none for Hinge.
  std::int32_t kerf = -1;
  /// The state after this tick is what the job sees.
  std::int64_t tick = 0;
};

/// A piece as a job found it.
struct FoundPiece {
  /// 0 is the bone; what is cut off gets the next number and keeps it.
  std::int32_t id = 0;
  /// Came free since the job before.
  bool is_new = false;
  double volume_mm3 = 0.0;
  /// A point well inside it; of the bone none.
  Vec3 inside_mm{0.0, 0.0, 0.0};
  /// Where nothing stands any more once it is taken out; none for the bone, which stays.
  std::unique_ptr<const Bvh> body;
  /// Set by the step.
  bool is_taken_out = false;
};

/// The step borrows it until it gives it back (StepOutput::given_back); the bodies of pieces that
/// it has marked as taken out it borrows for the rest of the attempt.
struct JobResult {
  JobRequest request;
  /// Section: of the solid as it stood, at the kerf's planes.
  double section_mm2 = 0.0;
  /// Pieces: without debris, largest first.
  std::vector<FoundPiece> pieces;
  /// Pieces: kerfs that took their whole section, ascending.
  std::vector<std::int32_t> completed;
  /// Pieces: in the wound as it is.
  double debris_mm3 = 0.0;
  /// Pieces: taken by the blade so far in the attempt.
  double removed_mm3 = 0.0;
  /// Pieces: see KerfCut; expected 0.
  std::uint32_t nudges = 0;
  /// Hinge.
  ClosedHinge hinge;
};

/// A bone that others cut too.
struct BoneToCut {
  const WholeBone& whole;
  RigidTransform world_from_bone;
};

/// The attempt as the jobs see it: a copy of the kerfs, and the bone that they leave.
class AttemptGeometry {
 public:
  /// Builds the tree of the whole bone; work of 0.1 s.
  AttemptGeometry(const Bone& bone, const Blade& blade, std::optional<PlannedBridge> bridge = {});
  /// Borrows the bone's solid and its tree.
  AttemptGeometry(const BoneToCut& bone, const Blade& blade,
                  std::optional<PlannedBridge> bridge = {});

  /// Applies what the step gave out; events of a tick before its sample.
  void apply(const CutEvent& event);
  void apply(const ToolSample& sample);
  /// thread  worker, or the caller's in virtual time
  std::unique_ptr<JobResult> run(const JobRequest& request);

  /// What lies in the wound, as the last job of pieces left it.
  CutSolid solid() const { return bone_.pieces().gathered(); }
  /// Of those the pieces, under their numbers.
  const std::vector<PieceBody>& pieces() const noexcept { return bone_.pieces().pieces(); }
  const KerfSet& kerfs() const noexcept { return kerfs_; }
  /// The bone that was never cut, with its tree.
  SolidWithTree whole() { return bone_.before(0); }
  /// Bodies that were taken out; they live as long as this.
  std::vector<const Bvh*> taken_out() const { return bone_.pieces().taken_out(); }
  /// Nothing but this kerf was opened, and nothing taken out: without it the bone is whole.
  bool is_only_kerf(std::int32_t kerf) const;
  /// What lies in the wound with all kerfs opened as far as they are now but one (-1: but none),
  /// for a display that shows that one's cut on it. Nothing where a piece that was taken out would
  /// hang on the bone again.
  /// thread  the one that applies
  std::optional<CutSolid> solid_without(std::int32_t kerf);

 private:
  void run_section(JobResult& result);
  void run_pieces(JobResult& result);
  /// Opens the bone's kerfs as far as the fields are open now.
  void bring_up_to_date();

  KerfSet kerfs_;
  std::optional<PlannedBridge> bridge_;
  CutBone bone_;
  /// Per kerf: its field rose since the bone was opened as far.
  std::vector<std::uint8_t> has_risen_;
};

}  // namespace hallux::simulator
