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
#include <span>
#include <vector>

#include "simulator/bone/close_bridge.h"
#include "simulator/bone/cut_bone.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/mesh/bone.h"

namespace hallux::simulator {

enum class JobKind : std::int32_t {
  /// Slice the bone along a kerf that was just frozen.
  Section,
  /// Commit what the blade has opened and see what comes free.
  Pieces,
  /// Close the wedge beside a planned bridge.
  Hinge,
  /// Find what a piece meets when it is moved.
  Grip
};

struct JobRequest {
  std::int32_t id = -1;
  JobKind kind = JobKind::Section;
  /// Section, Pieces: the kerf that asked. Hinge: which of the operation. Grip: the piece.
  std::int32_t subject = -1;
  /// The state after this tick is what the job sees.
  std::int64_t tick = 0;
};

/// A piece as a job found it.
struct FoundPiece {
  /// The bones are the first, from 0; what is cut off gets the next number and keeps it.
  std::int32_t id = 0;
  /// Came free since the job before.
  bool is_new = false;
  double volume_mm3 = 0.0;
  /// A point well inside it; of the fragment's own piece none.
  Vec3 inside_mm{0.0, 0.0, 0.0};
  /// Where nothing stands any more once it is taken out; none for the fragment's own piece, which
  /// stays.
  std::unique_ptr<const Bvh> body;
  /// Set by the step.
  bool is_taken_out = false;
};

/// What a piece may meet: the solids of one fragment, in that one's frame; of its own fragment what
/// it leaves.
struct MetFragment {
  std::int32_t fragment = 0;
  /// Shared with the jobs, which cut the same solid.
  std::shared_ptr<const Bvh> surface;
  /// By which it meets the piece.
  std::vector<Vec3> points_mm;
};

/// A piece that the forceps take hold of, in the frame of its fragment.
struct GrippedPiece {
  /// That it is, or will be a part of no more.
  std::int32_t fragment = 0;
  Vec3 centroid_mm{0.0, 0.0, 0.0};
  /// Null where there is no such piece; else shared likewise.
  std::shared_ptr<const Bvh> surface;
  /// By which it meets the others.
  std::vector<Vec3> points_mm;
  /// Into what its sawn walls came from, as far as that is still there; of unit length, zero where
  /// they say nothing.
  Vec3 closing{0.0, 0.0, 0.0};
  std::vector<MetFragment> met;
};

/// The bone after a hinge has closed: two fragments.
struct DividedFragment {
  /// That was divided, and keeps the half that stayed.
  std::int32_t fragment = 0;
  /// The number that the other half has as a piece.
  std::int32_t moved_piece = 0;
  double moved_mm3 = 0.0;
  /// A point well inside it.
  Vec3 inside_moved_mm{0.0, 0.0, 0.0};
  std::unique_ptr<const Bvh> fixed_surface, moved_surface;
};

/// The step borrows it until it gives it back (StepOutput::given_back); the bodies of pieces that
/// it has marked as taken out it borrows for the rest of the attempt, and so what it never gives
/// back.
struct JobResult {
  JobRequest request;
  /// Section: of the solid as it stood, at the kerf's planes.
  double section_mm2 = 0.0;
  /// Pieces: that they are of.
  std::int32_t fragment = 0;
  /// Pieces: without debris, largest first.
  std::vector<FoundPiece> pieces;
  /// Pieces: kerfs that took their whole section, ascending.
  std::vector<std::int32_t> completed;
  /// Pieces: in the wound as it is.
  double debris_mm3 = 0.0;
  /// Pieces: taken by the blade so far in the attempt.
  double removed_mm3 = 0.0;
  /// Pieces: see KerfTally; expected 0.
  std::uint32_t nudges = 0;
  /// Hinge.
  ClosedHinge hinge;
  /// Hinge, where it has closed.
  DividedFragment divided;
  /// Grip.
  GrippedPiece gripped;
};

/// A bone that others cut too.
struct BoneToCut {
  const WholeBone& whole;
  RigidTransform world_from_bone;
};

/// The attempt as the jobs see it: a copy of the kerfs, and the fragments that they leave.
class AttemptGeometry {
 public:
  /// Builds the tree of the whole bone; work of 0.1 s.
  AttemptGeometry(const Bone& bone, const Tray& tray, const PlannedBridges& bridges = {});
  /// Of one to bone_limit bones. Borrows their solids and trees.
  AttemptGeometry(std::span<const BoneToCut> bones, const Tray& tray,
                  const PlannedBridges& bridges = {});
  AttemptGeometry(const BoneToCut& bone, const Tray& tray, const PlannedBridges& bridges = {})
      : AttemptGeometry(std::span(&bone, 1), tray, bridges) {}

  /// Applies what the step gave out; events of a tick before its sample.
  void apply(const CutEvent& event);
  void apply(const ToolSample& sample);
  /// thread  worker, or the caller's in virtual time
  std::unique_ptr<JobResult> run(const JobRequest& request);

  /// What lies in the wound, as the last jobs of pieces left it; each fragment in its own frame.
  CutSolid solid() const;
  /// Of a fragment the pieces, under their numbers.
  const std::vector<PieceBody>& pieces(std::int32_t fragment = 0) const noexcept {
    return fragment_at(fragment).bone.pieces().pieces();
  }
  const KerfSet& kerfs() const noexcept { return kerfs_; }
  std::int32_t fragment_count() const noexcept {
    return static_cast<std::int32_t>(fragments_.size());
  }
  /// It was taken out of the wound.
  bool is_out(std::int32_t fragment) const noexcept { return fragment_at(fragment).is_out; }
  /// The number that all of a fragment has as a piece.
  std::int32_t own_piece(std::int32_t fragment) const noexcept {
    return fragment_at(fragment).bone.pieces().main();
  }
  /// In which a piece lies; -1: none.
  std::int32_t fragment_of_piece(std::int32_t piece) const noexcept;
  /// What a fragment was cut from since it is one, with its tree.
  SolidWithTree whole(std::int32_t fragment) { return fragment_at(fragment).bone.before(0); }
  /// Bodies that were taken out of a fragment since it is one; borrowed until it is divided.
  std::vector<const Bvh*> taken_out(std::int32_t fragment) const {
    return fragment_at(fragment).bone.pieces().taken_out();
  }
  /// Its fragment is a bone of which nothing but this kerf was opened, and nothing taken out or
  /// parted: without it the bone is whole.
  bool is_only_kerf(std::int32_t kerf) const;
  /// A fragment with all its kerfs opened as far as they are now but one (-1: but none), for a
  /// display that shows that one's cut on it. Nothing where a piece that was taken out would hang
  /// on it again.
  /// thread  the one that applies
  std::optional<CutSolid> solid_without(std::int32_t fragment, std::int32_t kerf);

 private:
  /// A fragment's solid with the kerfs that cut it since it is one.
  struct FragmentSolid {
    /// Null where it is borrowed, or the bone's own.
    std::shared_ptr<const WholeBone> own;
    CutBone bone;
    /// By their place in the order of cutting.
    std::vector<std::int32_t> kerfs;
    /// By the blade, before the fragment was what it is now; and since, as worked out last.
    double removed_before_mm3 = 0.0, removed_mm3 = 0.0;
    /// Taken out of the wound.
    bool is_out = false;
  };

  /// Of a fragment that is, or may soon be, divided.
  struct Halves {
    std::shared_ptr<const WholeBone> rest, parted;
  };

  FragmentSolid& fragment_at(std::int32_t fragment) noexcept {
    return fragments_[static_cast<std::size_t>(fragment)];
  }
  const FragmentSolid& fragment_at(std::int32_t fragment) const noexcept {
    return fragments_[static_cast<std::size_t>(fragment)];
  }
  std::int32_t place_of(std::int32_t kerf) const noexcept;
  void take_out(std::int32_t piece);
  void part(std::int32_t piece, std::int32_t parent);
  void divide(std::int32_t parent, Halves halves, std::int32_t piece);
  void run_section(JobResult& result);
  void run_pieces(JobResult& result);
  void run_hinge(JobResult& result);
  void run_grip(JobResult& result);
  std::vector<MetFragment> met_by(std::int32_t piece, std::int32_t fragment) const;
  /// Over a solid, the fragment's own one where it is that.
  std::shared_ptr<const Bvh> surface_over(const CutSolid& solid, std::int32_t fragment) const;
  /// What is left of a piece's fragment without it, and the piece; those that its grip was worked
  /// out with, where they still hold.
  Halves halves_of(const PieceBody& piece, std::int32_t fragment) const;
  /// Opens the fragments' kerfs as far as the fields are open now.
  void bring_up_to_date();

  KerfSet kerfs_;
  PlannedBridges bridges_;
  std::vector<FragmentSolid> fragments_;
  std::int32_t next_piece_ = 1;
  /// What the last hinge that closed is to leave; and its number as a piece.
  CutSolid fixed_, moved_;
  std::int32_t moved_piece_ = -1;
  /// Of the piece that was gripped last, where it was a part of another.
  Halves gripped_;
  /// Per kerf: its field rose since the bone was opened as far.
  std::vector<std::uint8_t> has_risen_;
};

}  // namespace hallux::simulator
