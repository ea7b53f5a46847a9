/// How every verb writes its one JSON value.
#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

namespace hallux::ui {

/// Writes the value and a line end. Bytes that are not UTF-8 (a file's name may hold any) become
/// U+FFFD.
void write_json(std::ostream& out, const nlohmann::ordered_json& value);

}  // namespace hallux::ui
