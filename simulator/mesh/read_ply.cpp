#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>

#include "simulator/mesh/mesh_text.h"
#include "simulator/mesh/parse_mesh.h"
#include "simulator/mesh/ply_header.h"

/// PLY: a header that declares elements, then their numbers as text or binary. Only the elements
/// `vertex` (x, y, z) and `face` (the list of its corners, as a fan) are kept; everything else is
/// walked over. A number is read only where it is there, so a list that lies about its length ends
/// in a sentence and not beyond the bytes.
namespace hallux::simulator {

namespace {

/// The numbers after the header, one after the other, in either form.
class PlyNumbers {
 public:
  PlyNumbers(const MeshSource& source, const PlyHeader& header)
      : storage_(header.storage),
        name_(source.name),
        rest_(source.bytes.subspan(header.bytes)),
        text_(source.text().substr(header.bytes), source.name, header.lines + 1) {}

  double real(PlyType type) {
    if (storage_ == PlyStorage::Text) return text_.number();
    if (is_whole(type)) return static_cast<double>(whole_from_bytes(type));
    const double value =
        type == PlyType::Float32
            ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(take_bits(4))))
            : std::bit_cast<double>(take_bits(8));
    return value;
  }
  std::int64_t whole(PlyType type) {
    if (storage_ == PlyStorage::Text) return text_.whole_number(text_.word());
    return whole_from_bytes(type);
  }
  /// Passes over `count` numbers in a single step where they are binary.
  void skip(PlyType type, std::uint64_t count) {
    if (storage_ == PlyStorage::Text) {
      for (std::uint64_t i = 0; i < count; ++i) {
        if (text_.word().empty()) refuse_end();
      }
      return;
    }
    if (count > rest_.size() / bytes_of(type)) refuse_end();
    rest_ = rest_.subspan(static_cast<std::size_t>(count) * bytes_of(type));
  }

 private:
  [[noreturn]] void refuse_end() const {
    refuse_mesh(name_,
                "ends in the middle of its numbers; it is cut short or damaged, export it again");
  }
  std::uint64_t take_bits(std::size_t size) {
    if (rest_.size() < size) refuse_end();
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t at = storage_ == PlyStorage::LittleEndian ? size - 1 - i : i;
      bits = (bits << 8U) | static_cast<std::uint64_t>(rest_[at]);
    }
    rest_ = rest_.subspan(size);
    return bits;
  }
  std::int64_t whole_from_bytes(PlyType type) {
    const std::uint64_t bits = take_bits(bytes_of(type));
    switch (type) {
      case PlyType::Int8:
        return static_cast<std::int8_t>(bits);
      case PlyType::Int16:
        return static_cast<std::int16_t>(bits);
      case PlyType::Int32:
        return static_cast<std::int32_t>(bits);
      default:
        return static_cast<std::int64_t>(bits);
    }
  }

  PlyStorage storage_;
  std::string_view name_;
  std::span<const std::byte> rest_;
  TextCursor text_;
};

/// The length of a list.
std::uint64_t take_length(const MeshSource& source, const PlyProperty& list, PlyNumbers& numbers) {
  const std::int64_t length = numbers.whole(*list.list_count);
  if (length < 0) {
    refuse_mesh(source.name,
                "a list " + quoted(list.name) + " has a negative length; export the file again");
  }
  return static_cast<std::uint64_t>(length);
}

void skip_property(const MeshSource& source, const PlyProperty& property, PlyNumbers& numbers) {
  numbers.skip(property.type, property.list_count ? take_length(source, property, numbers) : 1);
}

void read_vertices(const MeshSource& source, const PlyElement& element, PlyNumbers& numbers,
                   IndexedMesh& mesh) {
  constexpr std::string_view axes = "xyz";
  for (const char axis : axes) {
    const auto is_axis = [axis](const PlyProperty& property) {
      return property.name == std::string_view{&axis, 1} && !property.list_count;
    };
    if (std::none_of(element.properties.begin(), element.properties.end(), is_axis)) {
      refuse_mesh(source.name,
                  "its points have no " + std::string(1, axis) + "; export the file again");
    }
  }
  mesh.points_mm.reserve(static_cast<std::size_t>(element.count));
  for (std::uint64_t i = 0; i < element.count; ++i) {
    Vec3 point{0.0, 0.0, 0.0};
    for (const PlyProperty& property : element.properties) {
      const std::size_t axis = property.name.size() == 1 ? axes.find(property.name) : axes.npos;
      if (axis == axes.npos || property.list_count) {
        skip_property(source, property, numbers);
      } else {
        point[static_cast<glm::length_t>(axis)] = numbers.real(property.type);
      }
    }
    if (!is_finite(point)) refuse_not_finite(source.name, "point " + std::to_string(i + 1));
    mesh.points_mm.push_back(point);
  }
}

bool is_corner_list(const PlyProperty& property) noexcept {
  const bool is_named = property.name == "vertex_indices" || property.name == "vertex_index";
  return is_named && property.list_count && is_whole(property.type);
}

std::uint32_t take_corner(const MeshSource& source, std::uint64_t face, const PlyProperty& list,
                          PlyNumbers& numbers, std::uint64_t point_count) {
  const std::int64_t index = numbers.whole(list.type);
  if (index < 0 || static_cast<std::uint64_t>(index) >= point_count) {
    refuse_mesh(source.name, "face " + std::to_string(face + 1) + " names point " +
                                 std::to_string(index) + ", but there are " +
                                 std::to_string(point_count) +
                                 " counted from 0; the file is damaged, export it again");
  }
  return static_cast<std::uint32_t>(index);
}

void read_fan(const MeshSource& source, std::uint64_t face, const PlyProperty& list,
              PlyNumbers& numbers, std::uint64_t point_count, IndexedMesh& mesh) {
  const std::uint64_t corners = take_length(source, list, numbers);
  if (corners < 3) {
    refuse_mesh(source.name, "face " + std::to_string(face + 1) +
                                 " has fewer than 3 corners; export the file again");
  }
  Triangle fan{};
  fan[0] = take_corner(source, face, list, numbers, point_count);
  fan[2] = take_corner(source, face, list, numbers, point_count);
  for (std::uint64_t i = 2; i < corners; ++i) {
    fan[1] = fan[2];
    fan[2] = take_corner(source, face, list, numbers, point_count);
    mesh.triangles.push_back(fan);
    check_triangle_count(source, mesh.triangles.size());
  }
}

void read_faces(const MeshSource& source, const PlyElement& element, std::uint64_t point_count,
                PlyNumbers& numbers, IndexedMesh& mesh) {
  const auto corner_lists =
      std::count_if(element.properties.begin(), element.properties.end(), is_corner_list);
  if (corner_lists != 1) {
    refuse_mesh(
        source.name,
        "its faces have no list 'vertex_indices' of whole numbers (or two); export the file again");
  }
  mesh.triangles.reserve(static_cast<std::size_t>(element.count));
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (const PlyProperty& property : element.properties) {
      if (is_corner_list(property)) {
        read_fan(source, i, property, numbers, point_count, mesh);
      } else {
        skip_property(source, property, numbers);
      }
    }
  }
}

}  // namespace

IndexedMesh parse_ply(const MeshSource& source) {
  const PlyHeader header = parse_ply_header(source);
  PlyNumbers numbers{source, header};
  IndexedMesh mesh;
  std::uint64_t point_count = 0;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") point_count = element.count;
  }
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      read_vertices(source, element, numbers, mesh);
    } else if (element.name == "face") {
      read_faces(source, element, point_count, numbers, mesh);
    } else {
      for (std::uint64_t i = 0; i < element.count; ++i) {
        for (const PlyProperty& property : element.properties) {
          skip_property(source, property, numbers);
        }
      }
    }
  }
  return mesh;
}

}  // namespace hallux::simulator
