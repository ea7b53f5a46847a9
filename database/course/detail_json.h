/// JSON text of a measurement's detail, as it is stored with its row and with a score card.
/// Inside this room only.
#pragma once

#include <string>
#include <string_view>

#include "database/records/measurement.h"
#include "database/text/json_record.h"

namespace hallux::database {

template <>
inline constexpr std::tuple fields_of<Detail>{
    Field{"kind", &Detail::kind}, Field{"values", &Detail::values}, Field{"words", &Detail::words}};

/// Empty of a detail that says nothing.
std::string json_from_detail(const Detail& detail);

/// errors  DatabaseError Damaged where the text is no detail
Detail detail_from_json(std::string_view text);

}  // namespace hallux::database
