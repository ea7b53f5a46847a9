/// Anchors taken from an audit, and an audit held against them. Reads nothing of anybody.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "database/records/anchor.h"
#include "database/store/connection.h"

namespace hallux::database {

/// "hallux-anchor DIRECTORY ACTS HEAD TIME"
std::string text_of(const Anchor& anchor);

/// Of the audit as it is now.
/// errors  DatabaseError
Anchor take_anchor(Database& database);

/// Those in a text, one a line; other lines are passed over, so that a printed report may be given.
/// errors  DatabaseError BadInput where there is none, or one that is none
std::vector<Anchor> anchors_in(std::string_view text);

/// errors  DatabaseError: Damaged where the audit does not hold that act with that link; BadInput
///         where the anchor is of another directory
void check_anchor(Database& database, const Anchor& anchor);

}  // namespace hallux::database
