/// How people hold the saw: one row a person. Inside this room only.
#pragma once

#include "database/records/hand_settings.h"
#include "database/records/ids.h"
#include "database/store/connection.h"

namespace hallux::database {

/// Of somebody who never chose: right-handed, all else as the station.
HandSettings load_hand_settings(Database& database, PersonId person);

/// errors  DatabaseError BadInput for a scale or a share that cannot be
void store_hand_settings(Database& database, PersonId person, const HandSettings& settings);

}  // namespace hallux::database
