/// A bone on the bench: kerfs are sawn into it one after another, each committed before the next.
///
/// What is left is the bone less the union of all kerfs, so their order is free. A plane that comes again opens the kerf
/// that is there: the solid is made anew without that kerf, which then comes last. Cutting beside its own walls would
/// leave slivers.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/cutting/slice/section.h"
#include "simulator/mesh/bvh.h"
#include "ui/jobs/kerf_frames.h"

namespace hallux::ui {

/// One kerf: the plane normal . p = offset in the mesh's millimetres is its middle.
struct CutGroup {
  Vec3 normal{0.0, 0.0, 1.0};  ///< of any length above 0; the offset is in the same measure
  double offset = 0.0;
  double kerf_mm = 0.5;
  std::optional<std::filesystem::path> sweep_file;  ///< absent: the cut goes all the way through
};

class SawnBone {
 public:
  explicit SawnBone(simulator::IndexedMesh mesh);

  /// Saws the next group.
  /// errors  CutInputError for the sweep; KernelRefusal; Cancelled
  GroupOutcome saw(const CutGroup& group, const Progress& progress);

  const simulator::CutSolid& whole() const noexcept { return whole_; }
  const simulator::CutSolid& solid() const noexcept { return solid_; }
  const std::vector<OpenedKerf>& kerfs() const noexcept { return kerfs_; }
  double removed_mm3() const noexcept;
  /// The uncut bone's section in a plane.
  simulator::Section section_of_whole(const simulator::KerfPlane& plane) const;

 private:
  std::optional<std::size_t> place_of_kerf_in(const simulator::KerfPlane& asked) const;
  bool begin_kerf(const CutGroup& group, const simulator::KerfPlane& asked);
  void reopen_kerf(std::size_t place);
  void open_last_kerf(const std::optional<BladePath>& path, const Progress& progress,
                      GroupOutcome& outcome);

  simulator::CutSolid whole_, solid_;
  simulator::Bvh whole_bvh_;
  Vec3 middle_mm_{0.0, 0.0, 0.0};
  std::vector<OpenedKerf> kerfs_;  ///< in the order in which the solid was cut
  std::size_t group_count_ = 0;
};

}  // namespace hallux::ui
