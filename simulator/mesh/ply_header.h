/// What a PLY file says about itself before its numbers. Inside this corner only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "simulator/mesh/parse_mesh.h"

namespace hallux::simulator {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };
enum class PlyStorage { Text, LittleEndian, BigEndian };

std::size_t bytes_of(PlyType type) noexcept;
bool is_whole(PlyType type) noexcept;

struct PlyProperty {
  std::string_view name;
  PlyType type = PlyType::Float32;
  /// The type of the length; absent: a single number.
  std::optional<PlyType> list_count;
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyStorage storage = PlyStorage::Text;
  std::vector<PlyElement> elements;
  /// Where the numbers begin.
  std::size_t bytes = 0;
  std::size_t lines = 0;
};

/// The names point into the source.
/// ensures every count is possible: the bytes after the header can hold that many elements
/// errors  MeshError
PlyHeader parse_ply_header(const MeshSource& source);

}  // namespace hallux::simulator
