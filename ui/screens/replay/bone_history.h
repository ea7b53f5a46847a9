/// The bone at every moment of an attempt, so that any of them can be shown at once.
///
/// What the blade opened is kept as one field a kerf with the tick at which each node opened: the kerf of a moment is a
/// threshold of it. In a stretch of time in which only one kerf grows the others stand still: they are cut into a mesh that
/// is made once, and the one that grows is a patch on it, built from the outline of the moment:
///
///     time       ---- kerf 0 grows ----|---- kerf 1 grows ----|-- kerf 0 again --
///     mesh       the whole bone         bone less kerf 0       bone less kerf 1
///     patch      kerf 0, by outline     kerf 1, by outline     kerf 0, by outline
///
/// A piece that is taken out is left out of the picture from then on; a closed hinge shows its two halves.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/plan.h"
#include "simulator/base/progress.h"
#include "simulator/cutting/field/opened_field.h"
#include "simulator/cutting/slice/kerf_contact.h"
#include "simulator/cutting/solid/solid_patch.h"
#include "simulator/mesh/bone.h"
#include "simulator/record/record.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// What an attempt was made on and with.
struct HistoryRequest {
  const simulator::Bone& bone;
  const scenarios::Plan& plan;
  const simulator::Recording& recording;
  std::vector<simulator::OpenedField> opened;  ///< of the recording, one per kerf
  BoneLook look;                               ///< of the bone
  std::string name;  ///< another attempt, or another length of it, has another
};

/// What a kerf opened, and when.
struct KerfGrowth {
  simulator::OpenedField opened;
  std::vector<std::int32_t> ticks;  ///< at which something opened, ascending

  /// How many of them are not after this tick: the kerf looks the same wherever that is the same.
  std::size_t grown_at(std::int64_t tick) const noexcept;
};

/// A stretch of time in which at most one kerf grows.
struct BoneStretch {
  std::int64_t from_tick = 0;
  std::int32_t growing = -1;                              ///< that kerf; -1: none ever does
  BoneMesh mesh;                                          ///< with the other kerfs as they are
  std::unique_ptr<const simulator::KerfContact> contact;  ///< of the growing one; null for none
  /// Per piece that is taken out its triangles of the mesh, ascending; empty where it is taken out later.
  std::vector<std::vector<std::uint32_t>> of_piece;
};

struct TakenPiece {
  std::int64_t tick = 0;
  std::unique_ptr<const simulator::Bvh> body;
};

/// The two halves after a hinge was closed.
struct ClosedHalves {
  std::int64_t tick = 0;
  BoneMesh fixed, moved;
  RigidTransform bone_from_moved;
};

/// Never changes once it was built.
struct BoneHistory {
  BoneLook look;
  std::vector<KerfGrowth> kerfs;
  std::vector<BoneStretch> stretches;  ///< by time, the first from the beginning
  std::vector<TakenPiece> taken;       ///< by time
  std::optional<ClosedHalves> closed;

  std::size_t stretch_at(std::int64_t tick) const noexcept;
};

/// `progress` is told the fraction done and may throw to stop it.
/// errors  whatever `progress` throws
/// thread  work's; seconds
std::shared_ptr<const BoneHistory> build_history(HistoryRequest request,
                                                 const Progress& progress = {});

/// The bone of one moment after the other, as the renderer takes it. Borrows the history.
class BoneMoment {
 public:
  explicit BoneMoment(const BoneHistory& history) : history_(history) {}

  /// Makes the bone stand as it did after this tick. Milliseconds at most; nothing where nothing changed.
  void move_to(std::int64_t tick);
  /// Another after each change.
  std::uint64_t revision() const noexcept { return revision_; }
  /// The pieces as bones of a scene, `world_from_bone` being the bone's place; they borrow this and the history.
  std::vector<BoneInScene> bones(const RigidTransform& world_from_bone) const;

  /// Where a ray first meets what stands, in the frame of the bone before anything moved; nothing where it misses.
  /// needs   direction has length 1
  std::optional<Vec3> first_hit(const Vec3& from_in_bone_mm, const Vec3& direction) const;
  /// Where a point of the bone before anything moved is now, in the bone's frame.
  Vec3 moved_place(const Vec3& point_in_bone_mm) const;

 private:
  void build_patch();
  const simulator::RegionOutline& outline_of_growing(std::int32_t kerf);
  void leave_out_taken();
  bool is_closed() const noexcept { return history_.closed && tick_ >= history_.closed->tick; }

  const BoneHistory& history_;
  std::int64_t tick_ = -1;
  std::optional<std::size_t> stretch_;
  std::size_t grown_ = 0;  ///< of the kerf that grows in the stretch
  std::size_t taken_ = 0;  ///< how many pieces are out
  bool was_closed_ = false;
  std::unique_ptr<simulator::PatchBuilder> builder_;  ///< of the stretch
  std::int32_t kerf_ = -1;                            ///< whose moment that is:
  std::unique_ptr<simulator::OpenedMoment> opened_;
  simulator::SolidPatch patch_;
  std::uint64_t revision_ = 0;
};

}  // namespace hallux::ui
