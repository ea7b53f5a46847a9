/// Feeds any bytes to the reader of quality certificates: it must say no, or give one that is
/// written and read again.
#include "database/recording/certificate_json.h"
#include "simulator/base/check.h"
#include "tests/fuzz/text_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace hallux;
  const std::string_view text = tests::text_of(bytes, size);
  database::is_valid_by(text);
  if (const auto certificate = database::certificate_from_json(text)) {
    const std::string json = database::json_from_certificate(*certificate);
    const auto again = database::certificate_from_json(json);
    CHECK(again && database::json_from_certificate(*again) == json);
    CHECK(database::is_valid_by(json) == database::verdict_of(*certificate).is_valid());
  }
  return 0;
}
