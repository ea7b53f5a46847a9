/// The solids of a recording's fragments, from kerfs that are open as far as they ever were.
/// Inside this corner only.
///
/// A kerf grows no more once its fragment was parted: until then it cuts the fragment's solid, and
/// what it leaves is the solid of both sides.
///
///     bone --kerfs--> solid --FragmentParted--> the rest --kerfs--> ... pieces
///                                          '--> the parted piece --kerfs--> ... pieces
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "assessment/rebuild/rebuild.h"
#include "simulator/bone/cut_bone.h"

namespace hallux::assessment {

class FragmentSolids {
 public:
  /// Fills in what the solids tell of `rebuilt`: borrowed, as is the rest.
  /// needs   its kerfs are frozen and open
  FragmentSolids(RebuiltBone& rebuilt, const simulator::Bone& bone, const ClosedHinges& hinges);

  /// Parts and cuts in the order of the events.
  /// done    told the share that is done; what it throws ends the work
  void follow(const simulator::Recording& recording, const std::function<void(double)>& done);

 private:
  /// A fragment as it stands so far.
  struct Standing {
    // Null where nothing is known of it.
    std::unique_ptr<const simulator::WholeBone> own;
    std::unique_ptr<simulator::CutBone> bone;
    /// By the order of cutting; those before `cut_count` are cut.
    std::vector<std::int32_t> kerfs;
    std::size_t cut_count = 0;
    std::int32_t piece = 0;
    bool is_out = false;
  };

  void add(simulator::CutSolid solid, std::int32_t piece);
  void cut_kerfs(Standing& standing, const std::function<void()>& cut_one);
  void cut(Standing& standing, std::int32_t kerf);
  void part(const simulator::Recording& recording, std::size_t event);
  simulator::CutSolid part_at(const simulator::PlannedBridge& bridge, Standing& parent);
  simulator::CutSolid part_from(const Vec3& place_mm, Standing& parent);
  void take_gone_from(std::vector<simulator::CutSolid>& solids);
  static void stand_again(Standing& standing, simulator::CutSolid solid);
  void take_out(const simulator::CutEvent& event, std::int32_t engine);
  void keep_pieces();
  void keep(std::vector<simulator::CutSolid> solids, bool are_out);
  void mark_pieces_out(std::size_t first);

  RebuiltBone& rebuilt_;
  const ClosedHinges& hinges_;
  std::vector<Standing> standing_;
  /// Pieces that were taken out of a fragment before it was parted.
  std::vector<simulator::CutSolid> gone_;
  /// Where pieces lie that were taken out so far; none of before engine 7, which told no place.
  std::vector<Vec3> gone_places_mm_;
};

}  // namespace hallux::assessment
