/// A bone on the bench: kerfs are sawn into it one after another, without force, feed or record.
///
/// What is left is the bone less the union of all kerfs, so their order is free. A plane that comes
/// again opens the kerf that is there, which then is the last to be cut: cutting beside its own
/// walls would leave slivers.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "simulator/bone/cut_bone.h"
#include "simulator/cutting/slice/section.h"

namespace hallux::simulator {

struct BegunKerf {
  /// The call of SawnBone::begin, from 0, that began it first: this one, or an earlier one in the
  /// same plane. Nothing where the plane misses the bone.
  std::optional<std::size_t> number;
  /// It is not through yet, and bone is left.
  bool can_open = false;
};

/// thread  one at a time; a job
class SawnBone {
 public:
  /// needs   the mesh is closed
  explicit SawnBone(IndexedMesh mesh);

  /// The plane normal . p = offset as that of a kerf, its frame's origin near the bone's middle.
  /// normal  of any length above 0; the offset is in the same measure
  KerfPlane plane_of(const Vec3& normal, double offset, double kerf_mm) const;
  /// The kerf that this plane opens again, by its place; nothing where it is another plane than all
  /// before.
  std::optional<std::size_t> find_kerf(const KerfPlane& asked) const;

  /// Begins a kerf, or takes up the one that is there; what can be opened becomes the last to be
  /// cut.
  /// is_swept  a blade will open it; else the cut goes all the way through
  /// errors    MeshError where a blade's field would be too wide; nothing changed then
  BegunKerf begin(const KerfPlane& asked, bool is_swept);
  /// What the others leave for the kerf that was begun.
  SolidWithTree stands();
  /// The kerf that was begun, opened as far as it was committed last.
  const OpenedKerf& begun() const noexcept { return bone_.kerf(last()); }
  /// Its field, for a blade to stamp.
  /// needs   begun by a blade, and not through since
  KerfField& field() noexcept { return *fields_.back(); }
  /// All of its plane; it is through from then on.
  RegionOutline open_all();
  /// Cuts it as far as it was opened.
  const KerfTally& commit(RegionOutline region);

  const CutSolid& whole() const noexcept { return bone_.whole(); }
  const CutSolid& solid() { return bone_.after_all(); }
  std::size_t kerf_count() const noexcept { return fields_.size(); }
  const OpenedKerf& kerf(std::size_t place) const noexcept {
    return bone_.kerf(static_cast<std::int32_t>(place));
  }
  /// The kerf of a BegunKerf; null where there is none.
  const OpenedKerf* find_number(std::size_t number) const noexcept;
  double removed_mm3();
  /// The number of a kerf for which the kernel would not build a closed solid: its own fault.
  std::optional<std::size_t> refused_kerf();
  /// The uncut bone's section in a plane.
  Section section_of_whole(const KerfPlane& plane);

 private:
  BegunKerf begin_new(std::size_t number, const KerfPlane& asked, bool is_swept);
  bool is_bone_left();
  std::int32_t last() const noexcept { return bone_.kerf_count() - 1; }

  CutBone bone_;
  Vec3 middle_mm_{0.0, 0.0, 0.0};
  /// Of each kerf in the order in which the bone is cut; absent where it goes all the way through.
  std::vector<std::optional<KerfField>> fields_;
  std::size_t begun_count_ = 0;
};

}  // namespace hallux::simulator
