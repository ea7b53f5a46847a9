/// The solids of a recording's fragments, from kerfs that are open as far as they ever were.
/// Inside this corner only.
///
/// A kerf grows no more once its fragment was parted: until then it cuts the fragment's solid, and
/// what it leaves is the solid of both sides.
///
///     bone --kerfs--> solid --FragmentParted--> the rest --kerfs--> ... pieces
///                                          '--> the parted piece --kerfs--> ... pieces
///
/// A piece that was taken out is no bone for the kerfs that were begun afterwards: they neither see
/// nor cut it. A kerf of before that goes on through the place may divide it: all of its parts were
/// taken out.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "assessment/rebuild/rebuild.h"
#include "simulator/bone/cut_bone.h"

namespace hallux::assessment {

class FragmentSolids {
 public:
  /// Fills in what the solids tell of `rebuilt`: borrowed, as is the rest.
  /// needs   its kerfs are frozen and open
  FragmentSolids(RebuiltBone& rebuilt, const simulator::Bones& bones, const ClosedHinges& hinges);

  /// Parts and cuts in the order of the events.
  /// done    told the share that is done; what it throws ends the work
  void follow(const simulator::Recording& recording, const std::function<void(double)>& done);

 private:
  /// A solid with the kerfs in it.
  struct Sawn {
    /// Null where nothing is known of it.
    std::unique_ptr<const simulator::WholeBone> own;
    std::unique_ptr<simulator::CutBone> bone;
  };
  /// A piece that was taken out of a fragment, and is in its solid still.
  struct TakenPiece {
    Vec3 inside_mm{0.0, 0.0, 0.0};
    /// Of the fragment's kerfs, those that were begun before.
    std::size_t kerf_count = 0;
    /// As it was, where a kerf of before goes on afterwards; else null.
    std::unique_ptr<const simulator::Bvh> body;
  };
  /// A fragment as it stands so far.
  struct Standing {
    /// With all its kerfs, as its hinge asks for them.
    Sawn whole;
    /// With the kerfs from `left_from` on; none while nothing was taken out before a kerf.
    Sawn left;
    std::size_t left_from = 0;
    /// By the order of cutting; those before `cut_count` are cut.
    std::vector<std::int32_t> kerfs;
    std::size_t cut_count = 0;
    /// By time.
    std::vector<TakenPiece> taken;
    std::int32_t piece = 0;
    /// Whose frame it has.
    std::size_t bone = 0;
    bool is_out = false;

    /// Which is cut.
    const Sawn& sawn() const noexcept { return left.bone != nullptr ? left : whole; }
  };

  void add(simulator::CutSolid solid, std::int32_t piece, std::size_t bone);
  void cut_kerfs(Standing& standing, const std::function<void()>& cut_one);
  void cut(Standing& standing, std::int32_t kerf);
  void part(const simulator::Recording& recording, std::size_t event);
  simulator::CutSolid part_at(const simulator::PlannedBridge& bridge, Standing& parent);
  simulator::CutSolid part_from(const Vec3& place_mm, Standing& parent);
  /// It is what was taken out, or a part of it.
  static bool is_of(const simulator::CutSolid& solid, const TakenPiece& taken);
  /// Takes them out of the solids.
  static std::vector<simulator::CutSolid> taken_from(std::vector<simulator::CutSolid>& solids,
                                                     std::span<const TakenPiece> taken);
  void leave_taken_before(Standing& standing);
  static Sawn sawn_from(simulator::CutSolid solid);
  static void stand_again(Standing& standing, simulator::CutSolid solid);
  void take_out(const simulator::Recording& recording, std::size_t event);
  std::unique_ptr<const simulator::Bvh> body_then(const Standing& standing,
                                                  const simulator::Recording& recording,
                                                  std::size_t event) const;
  void keep_pieces();
  void keep(std::vector<simulator::CutSolid> solids, std::size_t bone, bool are_out);
  /// They are pieces no more.
  void let_go(std::vector<simulator::CutSolid> gone, std::size_t bone);
  void mark_taken(const Standing& standing, std::size_t first);

  RebuiltBone& rebuilt_;
  const ClosedHinges& hinges_;
  simulator::Bones bones_;
  std::vector<Standing> standing_;
  /// By bone: pieces that were taken out of a fragment before it was sawn on or parted.
  std::vector<std::vector<simulator::CutSolid>> gone_;
};

}  // namespace hallux::assessment
