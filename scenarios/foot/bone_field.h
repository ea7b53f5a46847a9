/// The signed field of one patient's bone: the table's loft with its features, eminence and relief,
/// sized. Inside this corner only.
#pragma once

#include <vector>

#include "scenarios/foot/bone_loft.h"
#include "scenarios/foot/bone_table.h"

namespace hallux::scenarios {

class BoneField {
 public:
  /// length_mm stretches x only; eminence_mm 0 keeps the table's own bump.
  /// needs   the table has an eminence, or eminence_mm is 0
  BoneField(const BoneTable& table, double length_mm, double eminence_mm);

  /// Below zero inside; near the surface a distance within about a factor 1.5, its gradient within
  /// about a third.
  /// thread  any; allocates nothing
  Dual at(const Vec3& point_in_bone_mm) const noexcept;
  bool is_head_cartilage(const Vec3& point_in_bone_mm) const noexcept;
  /// The nearest point of the surface by Newton's steps along the gradient.
  Vec3 onto_surface(const Vec3& point_in_bone_mm) const noexcept;
  /// A point of the table, stretched as the bone is.
  Vec3 stretched(const Vec3& point_in_table_mm) const noexcept;
  /// The bottom of the groove beside a grown eminence, in the table's millimetres; empty where none
  /// has grown.
  const std::vector<Vec3>& sulcus_bottom_mm() const noexcept { return sulcus_bottom_mm_; }
  /// A box that holds the surface with room around it.
  Vec3 low_mm() const noexcept { return low_mm_; }
  Vec3 high_mm() const noexcept { return high_mm_; }

 private:
  void lay_sulcus();
  Dual body(const Vec3& point_mm, const LoftDistances& parts) const noexcept;
  Dual featured(const Vec3& point_mm) const noexcept;
  Dual with_eminence(const Dual& distance, const Vec3& point_mm) const noexcept;
  double roughness(const Vec3& point_mm, const LoftDistances& parts) const noexcept;

  BoneTable table_;
  BoneLoft loft_;
  /// Bone millimetres per table millimetre along x.
  double stretch_;
  double eminence_mm_;
  std::vector<Vec3> sulcus_line_mm_;
  std::vector<Vec3> sulcus_bottom_mm_;
  Vec3 low_mm_{0.0, 0.0, 0.0};
  Vec3 high_mm_{0.0, 0.0, 0.0};
};

}  // namespace hallux::scenarios
