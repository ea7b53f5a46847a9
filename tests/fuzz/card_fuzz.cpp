/// Feeds any bytes to the reader of score cards: it must throw DatabaseError, or give a card that
/// is written and read again, and can be put into words.
#include "assessment/sentences.h"
#include "database/course/score_json.h"
#include "database/store/database_error.h"
#include "simulator/base/check.h"
#include "tests/fuzz/text_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace hallux;
  try {
    database::ScoreCard card = database::card_from_json(tests::text_of(bytes, size));
    const std::string json = database::json_from_card(card);
    CHECK(database::json_from_card(database::card_from_json(json)) == json);
    assessment::say(card);
  } catch (const database::DatabaseError&) {
  }
  return 0;
}
