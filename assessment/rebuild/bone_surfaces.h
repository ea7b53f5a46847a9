/// The outsides of a patient's bones as they were. Inside this room only.
#pragma once

#include <memory>
#include <vector>

#include "simulator/mesh/bones.h"
#include "simulator/mesh/bvh.h"

namespace hallux::assessment {

class BoneSurfaces {
 public:
  explicit BoneSurfaces(const simulator::Bones& bones);
  /// known  of each bone, borrowed
  BoneSurfaces(const simulator::Bones& bones, std::vector<const simulator::Bvh*> known);

  /// In the frame of that bone.
  const simulator::Bvh& operator[](std::size_t bone) const noexcept { return *of_each_[bone]; }
  /// Of all of them together, in the frame of the first.
  const simulator::Bvh& together() const noexcept {
    return together_ == nullptr ? *of_each_.front() : *together_;
  }

 private:
  std::vector<std::unique_ptr<const simulator::Bvh>> own_;
  std::vector<const simulator::Bvh*> of_each_;
  /// Null where there is one.
  std::unique_ptr<const simulator::Bvh> together_;
};

}  // namespace hallux::assessment
