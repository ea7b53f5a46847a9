/// The bones of one patient: what an attempt is made on, and how they are stored as one.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "simulator/mesh/bone.h"

namespace hallux::simulator {

/// Borrows them; the first is the one that is operated on, wherever nothing else is said.
class Bones {
 public:
  Bones(const Bone& bone) noexcept : bones_(&bone, 1) {}
  Bones(const std::vector<Bone>& bones) noexcept : bones_(bones) {}
  Bones(std::span<const Bone> bones) noexcept : bones_(bones) {}

  const Bone& first() const noexcept { return bones_.front(); }
  const Bone& operator[](std::size_t bone) const noexcept { return bones_[bone]; }
  std::size_t size() const noexcept { return bones_.size(); }
  auto begin() const noexcept { return bones_.begin(); }
  auto end() const noexcept { return bones_.end(); }

 private:
  std::span<const Bone> bones_;
};

/// Of one bone the bytes of that bone, so that it has the same name in the store as ever.
/// needs   at least one
std::vector<std::byte> encode_patient(Bones bones);
/// errors  MeshError where the bytes are neither a bone nor bones: see decode_bone
std::vector<Bone> decode_patient(std::span<const std::byte> bytes);

/// From the frame of one of them to that of the first; of the first itself nothing is turned.
RigidTransform first_from(const Bones& bones, std::size_t bone) noexcept;

/// The outer surfaces of all of them, in the frame of the first.
IndexedMesh outsides_of(const Bones& bones);

}  // namespace hallux::simulator
