#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "simulator/mesh/bone.h"
#include "simulator/mesh/mesh_text.h"

/// The stored form of a bone. All little endian; a text is its length (32 bits) and its letters; a
/// mesh is its two counts (64 bits) and then points (three doubles) and triangles (three 32-bit
/// indices).
///
///     "HALLUXB1" | name | generator | credit | outer | canal | 0 or 1, cortex law | landmarks |
///     world_from_bone
///
/// Every bone has exactly one form and nothing may follow it, so the digest of the bytes names the
/// bone.
namespace hallux::simulator {

namespace {

constexpr std::string_view magic = "HALLUXB1";

class BoneWriter {
 public:
  void add_byte(std::uint8_t value) { bytes_.push_back(static_cast<std::byte>(value)); }
  template <typename Unsigned>
  void add_unsigned(Unsigned value) {
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
      add_byte(static_cast<std::uint8_t>((value >> (8U * i)) & 0xFFU));
    }
  }
  void add_real(double value) { add_unsigned(std::bit_cast<std::uint64_t>(value)); }
  void add_vector(const Vec3& value) {
    add_real(value.x);
    add_real(value.y);
    add_real(value.z);
  }
  void add_letters(std::string_view letters) {
    for (const char letter : letters) add_byte(static_cast<std::uint8_t>(letter));
  }
  void add_text(std::string_view text) {
    add_unsigned(static_cast<std::uint32_t>(text.size()));
    add_letters(text);
  }
  void add_mesh(const IndexedMesh& mesh) {
    bytes_.reserve(bytes_.size() + 24 * mesh.points_mm.size() + 12 * mesh.triangles.size() + 256);
    add_unsigned(std::uint64_t{mesh.points_mm.size()});
    add_unsigned(std::uint64_t{mesh.triangles.size()});
    for (const Vec3& point : mesh.points_mm) add_vector(point);
    for (const Triangle& triangle : mesh.triangles) {
      for (const std::uint32_t index : triangle) add_unsigned(index);
    }
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

[[noreturn]] void refuse_bone(const std::string& what) {
  refuse_mesh("stored bone", what + "; the store is damaged, restore it from a backup");
}

/// Takes values off the front; each is taken only where its bytes are there.
class BoneReader {
 public:
  explicit BoneReader(std::span<const std::byte> bytes) noexcept
      : rest_(bytes), size_(bytes.size()) {}

  std::uint8_t take_byte() { return take_unsigned<std::uint8_t>(); }
  template <typename Unsigned>
  Unsigned take_unsigned() {
    const std::span<const std::byte> part = take(sizeof(Unsigned));
    std::uint64_t value = 0;
    for (std::size_t i = sizeof(Unsigned); i-- > 0;) {
      value = (value << 8U) | static_cast<std::uint64_t>(part[i]);
    }
    return static_cast<Unsigned>(value);
  }
  double take_real() {
    const double value = std::bit_cast<double>(take_unsigned<std::uint64_t>());
    if (!std::isfinite(value)) refuse_bone("has a number that is not finite " + place());
    return value;
  }
  Vec3 take_vector() {
    const double x = take_real();
    const double y = take_real();
    const double z = take_real();
    return {x, y, z};
  }
  std::string take_letters(std::size_t count) {
    std::string letters;
    for (const std::byte letter : take(count)) letters.push_back(static_cast<char>(letter));
    return letters;
  }
  std::string take_text() { return take_letters(take_unsigned<std::uint32_t>()); }
  /// A count of things that take at least `least_bytes` each.
  template <typename Unsigned>
  std::size_t take_count(std::size_t least_bytes) {
    const Unsigned count = take_unsigned<Unsigned>();
    if (count > rest_.size() / least_bytes) refuse_bone("has a count beyond its bytes " + place());
    return static_cast<std::size_t>(count);
  }
  std::size_t left() const noexcept { return rest_.size(); }
  std::string place() const { return "(byte " + std::to_string(size_ - rest_.size()) + ")"; }

 private:
  std::span<const std::byte> take(std::size_t count) {
    if (count > rest_.size()) refuse_bone("is cut short " + place());
    const std::span<const std::byte> part = rest_.first(count);
    rest_ = rest_.subspan(count);
    return part;
  }

  std::span<const std::byte> rest_;
  std::size_t size_;
};

IndexedMesh take_mesh(BoneReader& reader) {
  constexpr std::size_t point_bytes = 24;
  constexpr std::size_t triangle_bytes = 12;
  const auto points = reader.take_count<std::uint64_t>(point_bytes);
  const auto triangles = reader.take_count<std::uint64_t>(triangle_bytes);
  if (points * point_bytes + triangles * triangle_bytes > reader.left()) {
    refuse_bone("has counts beyond its bytes " + reader.place());
  }
  IndexedMesh mesh;
  mesh.points_mm.reserve(points);
  for (std::size_t i = 0; i < points; ++i) mesh.points_mm.push_back(reader.take_vector());
  mesh.triangles.resize(triangles);
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& index : triangle) {
      index = reader.take_unsigned<std::uint32_t>();
      if (index >= points) refuse_bone("has a triangle without its point " + reader.place());
    }
  }
  return mesh;
}

CortexLaw take_cortex(BoneReader& reader) {
  CortexLaw law;
  law.mid_mm = reader.take_real();
  law.floor_mm = reader.take_real();
  law.length_mm = reader.take_real();
  return law;
}

std::vector<Landmark> take_landmarks(BoneReader& reader) {
  constexpr std::size_t least_bytes = 4 + 24;
  std::vector<Landmark> landmarks(reader.take_count<std::uint32_t>(least_bytes));
  for (Landmark& landmark : landmarks) {
    landmark.name = reader.take_text();
    landmark.point_in_bone_mm = reader.take_vector();
  }
  return landmarks;
}

RigidTransform take_transform(BoneReader& reader) {
  RigidTransform transform;
  transform.rotation.w = reader.take_real();
  transform.rotation.x = reader.take_real();
  transform.rotation.y = reader.take_real();
  transform.rotation.z = reader.take_real();
  transform.translation_mm = reader.take_vector();
  return transform;
}

}  // namespace

std::vector<std::byte> encode_bone(const Bone& bone) {
  BoneWriter writer;
  writer.add_letters(magic);
  writer.add_text(bone.name);
  writer.add_text(bone.generator);
  writer.add_text(bone.credit);
  writer.add_mesh(bone.outer);
  writer.add_mesh(bone.canal);
  writer.add_byte(bone.cortex ? 1 : 0);
  if (bone.cortex) {
    writer.add_vector({bone.cortex->mid_mm, bone.cortex->floor_mm, bone.cortex->length_mm});
  }
  writer.add_unsigned(static_cast<std::uint32_t>(bone.landmarks.size()));
  for (const Landmark& landmark : bone.landmarks) {
    writer.add_text(landmark.name);
    writer.add_vector(landmark.point_in_bone_mm);
  }
  const Quat& rotation = bone.world_from_bone.rotation;
  for (const double part : {rotation.w, rotation.x, rotation.y, rotation.z}) writer.add_real(part);
  writer.add_vector(bone.world_from_bone.translation_mm);
  return writer.take();
}

Bone decode_bone(std::span<const std::byte> bytes) {
  BoneReader reader{bytes};
  if (reader.take_letters(magic.size()) != magic) refuse_bone("does not begin as a bone (byte 0)");
  Bone bone;
  bone.name = reader.take_text();
  bone.generator = reader.take_text();
  bone.credit = reader.take_text();
  bone.outer = take_mesh(reader);
  bone.canal = take_mesh(reader);
  const std::uint8_t has_cortex = reader.take_byte();
  if (has_cortex > 1) refuse_bone("is damaged " + reader.place());
  if (has_cortex == 1) bone.cortex = take_cortex(reader);
  bone.landmarks = take_landmarks(reader);
  bone.world_from_bone = take_transform(reader);
  if (reader.left() != 0) refuse_bone("goes on after its end " + reader.place());
  return bone;
}

}  // namespace hallux::simulator
