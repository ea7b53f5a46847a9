/// The answer to a report: a table of plain values. Inside this room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace hallux::database {

/// Nothing stands for NULL; a blob is told from a text by its type.
using ReportCell =
    std::variant<std::monostate, std::int64_t, double, std::string, std::vector<std::byte>>;

struct Report {
  std::vector<std::string> columns;
  std::vector<std::vector<ReportCell>> rows;
};

}  // namespace hallux::database
