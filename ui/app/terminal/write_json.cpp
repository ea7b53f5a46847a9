#include "ui/app/terminal/write_json.h"

#include <nlohmann/json.hpp>
#include <ostream>

namespace hallux::ui {

void write_json(std::ostream& out, const nlohmann::ordered_json& value) {
  out << value.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
}

}  // namespace hallux::ui
