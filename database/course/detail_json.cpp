#include "database/course/detail_json.h"

namespace hallux::database {

std::string json_from_detail(const Detail& detail) {
  return detail == Detail{} ? std::string{} : json_of(detail).dump();
}

Detail detail_from_json(std::string_view text) {
  constexpr JsonBounds bounds{std::size_t{1} << 16U, 2};
  Detail detail;
  if (!text.empty()) read_json(parse_json("a detail", text, bounds), "a detail", detail);
  return detail;
}

}  // namespace hallux::database
