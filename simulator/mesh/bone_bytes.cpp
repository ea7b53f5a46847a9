#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "simulator/base/check.h"
#include "simulator/mesh/bones.h"
#include "simulator/mesh/mesh_text.h"

/// The stored form of a bone. All little endian; a text is its length (32 bits) and its letters; a
/// mesh is its two counts (64 bits) and then points (three doubles) and triangles (three 32-bit
/// indices).
///
///     "HALLUXB1" | name | generator | credit | outer | canal | 0 or 1, cortex law | landmarks |
///     world_from_bone
///
/// Several bones are one after the other, each whole and led by the length of its bytes (64 bits):
///
///     "HALLUXP1" | their count (32 bits), 2 at least | length | bone | length | bone ...
///
/// Every bone and every patient has exactly one form and nothing may follow it, so the digest of
/// the bytes names it. `pass` is the form of a bone: a writer and a reader go through the fields in
/// its order.
namespace hallux::simulator {

namespace {

constexpr std::string_view magic = "HALLUXB1", magic_of_several = "HALLUXP1";

/// More than any patient has; a count beyond it is damage.
constexpr std::uint32_t bones_at_most = 4;

class BoneWriter {
 public:
  template <typename Unsigned>
  void whole(Unsigned value) {
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
      bytes_.push_back(static_cast<std::byte>((value >> (8U * i)) & 0xFFU));
    }
  }
  void real(double value) { whole(std::bit_cast<std::uint64_t>(value)); }
  void letters(std::string_view letters) {
    for (const char letter : letters) whole(static_cast<std::uint8_t>(letter));
  }
  void bone(std::span<const std::byte> bytes) {
    whole(std::uint64_t{bytes.size()});
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  void text(std::string_view text) {
    whole(static_cast<std::uint32_t>(text.size()));
    letters(text);
  }
  void presence(const std::optional<CortexLaw>& law) { whole(std::uint8_t{law.has_value()}); }
  void count(const std::vector<Landmark>& landmarks) {
    whole(static_cast<std::uint32_t>(landmarks.size()));
  }
  void counts(const IndexedMesh& mesh) {
    bytes_.reserve(bytes_.size() + 24 * mesh.points_mm.size() + 12 * mesh.triangles.size() + 256);
    whole(std::uint64_t{mesh.points_mm.size()});
    whole(std::uint64_t{mesh.triangles.size()});
  }
  void index(std::uint32_t value, const IndexedMesh& /*mesh*/) { whole(value); }
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

  void real(double& value) {
    value = std::bit_cast<double>(taken<std::uint64_t>());
    if (!std::isfinite(value)) refuse_bone("has a number that is not finite " + place());
  }
  std::string letters(std::size_t count) {
    std::string letters;
    for (const std::byte letter : take(count)) letters.push_back(static_cast<char>(letter));
    return letters;
  }
  void text(std::string& text) { text = letters(taken<std::uint32_t>()); }
  std::uint32_t count_of_bones() { return taken<std::uint32_t>(); }
  /// The bytes of the next bone.
  std::span<const std::byte> bone() { return take(taken_count<std::uint64_t>(1)); }
  void presence(std::optional<CortexLaw>& law) {
    const auto is_there = taken<std::uint8_t>();
    if (is_there > 1) refuse_bone("is damaged " + place());
    if (is_there == 1) law.emplace();
  }
  void count(std::vector<Landmark>& landmarks) {
    constexpr std::size_t least_bytes = 4 + 24;
    landmarks.resize(taken_count<std::uint32_t>(least_bytes));
  }
  void counts(IndexedMesh& mesh) {
    constexpr std::size_t point_bytes = 24;
    constexpr std::size_t triangle_bytes = 12;
    const auto points = taken_count<std::uint64_t>(point_bytes);
    const auto triangles = taken_count<std::uint64_t>(triangle_bytes);
    if (points * point_bytes + triangles * triangle_bytes > left()) {
      refuse_bone("has counts beyond its bytes " + place());
    }
    mesh.points_mm.resize(points);
    mesh.triangles.resize(triangles);
  }
  void index(std::uint32_t& value, const IndexedMesh& mesh) {
    value = taken<std::uint32_t>();
    if (value >= mesh.points_mm.size()) {
      refuse_bone("has a triangle without its point " + place());
    }
  }
  std::size_t left() const noexcept { return rest_.size(); }
  std::string place() const { return "(byte " + std::to_string(size_ - rest_.size()) + ")"; }

 private:
  template <typename Unsigned>
  Unsigned taken() {
    const std::span<const std::byte> part = take(sizeof(Unsigned));
    std::uint64_t value = 0;
    for (std::size_t i = sizeof(Unsigned); i-- > 0;) {
      value = (value << 8U) | static_cast<std::uint64_t>(part[i]);
    }
    return static_cast<Unsigned>(value);
  }
  /// A count of things that take at least `least_bytes` each.
  template <typename Unsigned>
  std::size_t taken_count(std::size_t least_bytes) {
    const auto count = taken<Unsigned>();
    if (count > rest_.size() / least_bytes) refuse_bone("has a count beyond its bytes " + place());
    return static_cast<std::size_t>(count);
  }
  std::span<const std::byte> take(std::size_t count) {
    if (count > rest_.size()) refuse_bone("is cut short " + place());
    const std::span<const std::byte> part = rest_.first(count);
    rest_ = rest_.subspan(count);
    return part;
  }

  std::span<const std::byte> rest_;
  std::size_t size_;
};

void pass_vector(auto& port, auto& vector) {
  port.real(vector.x);
  port.real(vector.y);
  port.real(vector.z);
}

void pass_mesh(auto& port, auto& mesh) {
  port.counts(mesh);
  for (auto& point : mesh.points_mm) pass_vector(port, point);
  for (auto& triangle : mesh.triangles) {
    for (auto& index : triangle) port.index(index, mesh);
  }
}

void pass(auto& port, auto& bone) {
  port.text(bone.name);
  port.text(bone.generator);
  port.text(bone.credit);
  pass_mesh(port, bone.outer);
  pass_mesh(port, bone.canal);
  port.presence(bone.cortex);
  if (bone.cortex) {
    port.real(bone.cortex->mid_mm);
    port.real(bone.cortex->floor_mm);
    port.real(bone.cortex->length_mm);
  }
  port.count(bone.landmarks);
  for (auto& landmark : bone.landmarks) {
    port.text(landmark.name);
    pass_vector(port, landmark.point_in_bone_mm);
  }
  port.real(bone.world_from_bone.rotation.w);
  pass_vector(port, bone.world_from_bone.rotation);
  pass_vector(port, bone.world_from_bone.translation_mm);
}

}  // namespace

std::vector<std::byte> encode_bone(const Bone& bone) {
  BoneWriter writer;
  writer.letters(magic);
  pass(writer, bone);
  return writer.take();
}

Bone decode_bone(std::span<const std::byte> bytes) {
  BoneReader reader{bytes};
  if (reader.letters(magic.size()) != magic) refuse_bone("does not begin as a bone (byte 0)");
  Bone bone;
  pass(reader, bone);
  if (reader.left() != 0) refuse_bone("goes on after its end " + reader.place());
  return bone;
}

std::vector<std::byte> encode_patient(Bones bones) {
  CHECK(bones.size() > 0);
  if (bones.size() == 1) return encode_bone(bones.first());
  BoneWriter writer;
  writer.letters(magic_of_several);
  writer.whole(static_cast<std::uint32_t>(bones.size()));
  for (const Bone& bone : bones) writer.bone(encode_bone(bone));
  return writer.take();
}

std::vector<Bone> decode_patient(std::span<const std::byte> bytes) {
  BoneReader reader{bytes};
  std::vector<Bone> bones;
  if (bytes.size() < magic_of_several.size() ||
      reader.letters(magic_of_several.size()) != magic_of_several) {
    bones.push_back(decode_bone(bytes));
    return bones;
  }
  const std::uint32_t count = reader.count_of_bones();
  if (count < 2 || count > bones_at_most) refuse_bone("has a count of bones that none has");
  for (std::uint32_t i = 0; i < count; ++i) bones.push_back(decode_bone(reader.bone()));
  if (reader.left() != 0) refuse_bone("goes on after its end " + reader.place());
  return bones;
}

}  // namespace hallux::simulator
