/// One plain sentence with numbers for each line of a ledger, and the three that matter most, made
/// when a card is shown. Their points are those that are shown, of 100 (see shown_points.h).
#pragma once

#include "database/records/score.h"

namespace hallux::assessment {

/// Fills the texts of ledger lines and gates, and the sentences; a card that brought words of its
/// own keeps them.
void say(database::ScoreCard& card);

}  // namespace hallux::assessment
