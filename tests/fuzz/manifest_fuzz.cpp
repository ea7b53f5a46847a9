/// Feeds any bytes to the reader of manifests: it must throw DatabaseError, or give one that is
/// written and read again.
#include "database/course/score_json.h"
#include "database/exchange/read_manifest.h"
#include "database/exchange/write_manifest.h"
#include "simulator/base/check.h"
#include "tests/fuzz/text_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace hallux;
  try {
    const database::Manifest manifest = database::manifest_from_json(tests::text_of(bytes, size));
    const std::string json = database::json_from_manifest(manifest);
    CHECK(database::json_from_manifest(database::manifest_from_json(json)) == json);
    for (const database::ExportedScore& score : manifest.scores) {
      database::card_from_json(score.card_json);
    }
  } catch (const database::DatabaseError&) {
  }
  return 0;
}
