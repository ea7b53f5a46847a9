#include "ui/screens/pictures/cached_look.h"

#include <bit>
#include <optional>

#include "database/content/cached_bytes.h"
#include "database/store/database_error.h"
#include "simulator/base/digest.h"
#include "ui/jobs/files/byte_form.h"
#include "ui/screens/pictures/bone_viewport.h"

namespace hallux::ui {

namespace {

/// Another form of these bytes has another number.
constexpr std::int64_t form_version = 1;
constexpr std::uint64_t nodes_max = std::uint64_t{1} << 26U;

/// Of all that a look is made from.
Digest key_of(const Digest& bone) {
  Digester digester;
  digester.add_int(form_version);
  digester.add_int(look_version);
  digester.add_int(std::endian::native == std::endian::little ? 1 : 2);
  digester.add_digest(bone);
  return digester.finish();
}

std::vector<std::byte> bytes_of(const DepthVolume& depth) {
  ByteWriter writer;
  writer.add(depth.origin_in_bone_mm);
  writer.add(depth.spacing_mm);
  writer.add(depth.x_count);
  writer.add(depth.y_count);
  writer.add(depth.z_count);
  writer.add_bytes(std::as_bytes(std::span(depth.nodes)));
  return writer.take();
}

/// Nothing where the bytes are none.
std::optional<DepthVolume> depth_from(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  DepthVolume depth;
  if (!reader.take(depth.origin_in_bone_mm) || !reader.take(depth.spacing_mm) ||
      !reader.take(depth.x_count) || !reader.take(depth.y_count) || !reader.take(depth.z_count))
    return std::nullopt;
  const std::uint64_t row_count = std::uint64_t{depth.y_count} * depth.z_count;
  if (row_count > nodes_max || row_count * depth.x_count > nodes_max ||
      row_count * depth.x_count * sizeof(std::uint16_t) != reader.left())
    return std::nullopt;
  depth.nodes.resize(row_count * depth.x_count);
  if (!reader.take_all(std::span(depth.nodes))) return std::nullopt;
  return depth;
}

std::string name_of(const Digest& bone) { return hex_from_digest(bone) + ".look"; }

Digest digest_of_bone(const simulator::Bone& bone) {
  return digest_of(simulator::encode_bone(bone));
}

void keep(const std::filesystem::path& data_directory, const Digest& bone, const BoneLook& look) {
  try {
    database::store_cached(data_directory, name_of(bone), key_of(bone), bytes_of(look.depth));
  } catch (const database::DatabaseError& error) {
    if (!is_storage_failure(error.kind())) throw;
  }
}

}  // namespace

std::string cached_look_name(const simulator::Bone& bone) { return name_of(digest_of_bone(bone)); }

BoneLook cached_look_of(const std::filesystem::path& data_directory, const simulator::Bone& bone,
                        const Progress& progress) {
  const Digest digest = digest_of_bone(bone);
  const std::uint64_t id = picture_id("look " + hex_from_digest(digest));
  if (const auto kept = database::load_cached(data_directory, name_of(digest), key_of(digest))) {
    if (std::optional<DepthVolume> depth = depth_from(*kept)) {
      if (progress) progress(1.0);
      return {id, *std::move(depth), bone.cortex};
    }
  }
  BoneLook look = look_of(id, bone, progress);
  keep(data_directory, digest, look);
  return look;
}

}  // namespace hallux::ui
