/// JSON text of a score card, as it is stored with its score.
#pragma once

#include <string>
#include <string_view>

#include "database/records/score.h"

namespace hallux::database {

/// The same card gives the same bytes, and a card that was read those that it was read from.
/// Numbers that are not finite are written as null. Of a card that keeps facts no words are
/// written, and the other way round.
std::string json_from_card(const ScoreCard& card);

/// Words are no score: whether two cards differ in nothing but their sentences, or in what those
/// are made from.
bool is_same_score(const ScoreCard& one, const ScoreCard& other);

/// errors  DatabaseError Damaged where the text is not a card; null numbers become 0
ScoreCard card_from_json(std::string_view text);

}  // namespace hallux::database
