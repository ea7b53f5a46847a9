/// A header is believed only as far as its file goes: counts are compared with the bytes that
/// follow, by division, before any memory is taken for them. Elements and properties that nobody
/// here knows are kept, so that their numbers can be passed over.
#include "simulator/mesh/ply_header.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "simulator/mesh/mesh_text.h"

namespace hallux::simulator {

namespace {

// Real headers have a dozen lines; the bounds keep a hostile one from being a long walk.
constexpr std::size_t header_bytes_limit = std::size_t{64} << 10U;
constexpr std::size_t element_limit = 16;
constexpr std::size_t property_limit = 256;

std::optional<PlyType> type_named(std::string_view word) noexcept {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{{
      {"char", PlyType::Int8},
      {"int8", PlyType::Int8},
      {"uchar", PlyType::Uint8},
      {"uint8", PlyType::Uint8},
      {"short", PlyType::Int16},
      {"int16", PlyType::Int16},
      {"ushort", PlyType::Uint16},
      {"uint16", PlyType::Uint16},
      {"int", PlyType::Int32},
      {"int32", PlyType::Int32},
      {"uint", PlyType::Uint32},
      {"uint32", PlyType::Uint32},
      {"float", PlyType::Float32},
      {"float32", PlyType::Float32},
      {"double", PlyType::Float64},
      {"float64", PlyType::Float64},
  }};
  for (const auto& [name, type] : names) {
    if (name == word) return type;
  }
  return std::nullopt;
}

PlyType parse_type(TextCursor& cursor) {
  const std::string_view word = cursor.word_in_line();
  const std::optional<PlyType> type = type_named(word);
  if (!type) cursor.refuse(quoted(word) + " is no PLY number type; export the file again");
  return *type;
}

PlyStorage parse_storage(TextCursor& cursor) {
  const std::string_view word = cursor.word_in_line();
  const std::string_view version = cursor.word_in_line();
  if (version != "1.0") cursor.refuse("only PLY format 1.0 can be read; export the file again");
  if (word == "ascii") return PlyStorage::Text;
  if (word == "binary_little_endian") return PlyStorage::LittleEndian;
  if (word == "binary_big_endian") return PlyStorage::BigEndian;
  cursor.refuse(quoted(word) + " is no PLY format; export the file again");
}

PlyElement parse_element(TextCursor& cursor) {
  PlyElement element;
  element.name = cursor.word_in_line();
  const std::int64_t count = cursor.whole_number(cursor.word_in_line());
  if (count < 0) cursor.refuse("a count is negative; export the file again");
  element.count = static_cast<std::uint64_t>(count);
  return element;
}

PlyProperty parse_property(TextCursor& cursor) {
  PlyProperty property;
  const TextCursor before = cursor;
  if (cursor.word_in_line() == "list") {
    property.list_count = parse_type(cursor);
    if (!is_whole(*property.list_count)) {
      cursor.refuse("the length of a list must be a whole number; export the file again");
    }
  } else {
    cursor = before;
  }
  property.type = parse_type(cursor);
  property.name = cursor.word_in_line();
  if (property.name.empty()) cursor.refuse("a property has no name; export the file again");
  return property;
}

void add_element(TextCursor& cursor, PlyHeader& header) {
  if (header.elements.size() == element_limit) {
    cursor.refuse("more than 16 kinds of element; export the mesh again without extras");
  }
  header.elements.push_back(parse_element(cursor));
  const std::string_view name = header.elements.back().name;
  const auto is_same = [name](const PlyElement& element) { return element.name == name; };
  if (std::count_if(header.elements.begin(), header.elements.end(), is_same) > 1) {
    cursor.refuse("element " + quoted(name) + " is declared twice; export the file again");
  }
}

void add_property(TextCursor& cursor, PlyHeader& header) {
  if (header.elements.empty()) {
    cursor.refuse("a property stands before the first element; export the file again");
  }
  std::vector<PlyProperty>& properties = header.elements.back().properties;
  if (properties.size() == property_limit) {
    cursor.refuse("more than 256 properties; export the mesh again without extras");
  }
  properties.push_back(parse_property(cursor));
}

/// The fewest bytes that one element can take: in text a digit and a separator a number.
std::uint64_t least_bytes(const PlyElement& element, PlyStorage storage) noexcept {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    const PlyType type = property.list_count.value_or(property.type);
    bytes += storage == PlyStorage::Text ? 2 : bytes_of(type);
  }
  return bytes;
}

/// Compares the counts with the bytes that are there, by division: a product could overflow.
void check_counts(const MeshSource& source, const PlyHeader& header) {
  // The last number of a text may end with the file instead of a separator.
  std::uint64_t left = source.bytes.size() - header.bytes + 1;
  for (const PlyElement& element : header.elements) {
    if (element.count == 0) continue;
    const std::string what = std::to_string(element.count) + " of element " + quoted(element.name);
    const std::uint64_t least = least_bytes(element, header.storage);
    if (least == 0) {
      refuse_mesh(source.name, "declares " + what + " without properties; export the file again");
    }
    if (element.name == "face") check_triangle_count(source, element.count);
    if (element.name == "vertex") check_point_count(source, element.count);
    if (element.count > left / least) {
      refuse_mesh(source.name, "declares " + what + ", but only " + std::to_string(left - 1) +
                                   " bytes follow; it is cut short or damaged, export it again");
    }
    left -= element.count * least;
  }
}

}  // namespace

std::size_t bytes_of(PlyType type) noexcept {
  switch (type) {
    case PlyType::Int8:
    case PlyType::Uint8:
      return 1;
    case PlyType::Int16:
    case PlyType::Uint16:
      return 2;
    case PlyType::Float64:
      return 8;
    default:
      return 4;
  }
}

bool is_whole(PlyType type) noexcept {
  return type != PlyType::Float32 && type != PlyType::Float64;
}

PlyHeader parse_ply_header(const MeshSource& source) {
  const std::string_view text = source.text().substr(0, header_bytes_limit);
  TextCursor cursor{text, source.name};
  if (cursor.word_in_line() != "ply") {
    cursor.refuse("the file does not begin with 'ply'; export the mesh as PLY");
  }
  PlyHeader header;
  bool has_format = false;
  for (cursor.skip_line(); !cursor.at_end(); cursor.skip_line()) {
    const std::string_view keyword = cursor.word_in_line();
    if (keyword == "end_header") {
      cursor.skip_line();
      if (!has_format) cursor.refuse("the header names no format; export the file again");
      header.bytes = text.size() - cursor.bytes_left();
      header.lines = cursor.line() - 1;
      check_counts(source, header);
      return header;
    }
    if (keyword == "format") {
      header.storage = parse_storage(cursor);
      has_format = true;
    } else if (keyword == "element") {
      add_element(cursor, header);
    } else if (keyword == "property") {
      add_property(cursor, header);
    } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
      cursor.refuse(quoted(keyword) + " is no line of a PLY header; export the file again");
    }
  }
  cursor.refuse("the header has no end ('end_header'); the file is cut short, export it again");
}

}  // namespace hallux::simulator
