/// Export of an attempt: a folder of files that other programs read and another directory imports.
/// Inside this room only.
///
///   UUID/manifest.json  facts, scenario, score cards, decisions, digests of what lies beside it
///   UUID/tape.csv, samples.csv, events.csv   the record as integers; chain and seal follow from
///                                            them
///   UUID/views.csv      what was on the screen, outside the seal; where anything was
///   UUID/score.csv      the ledger of the score in force
///   UUID/bone.bin       the bone, byte for byte
///   UUID/*.ply          made from these: the bone and the pieces it was left in
///   UUID/plan.json      made from these: the plan on this bone, for other programs only
///
/// The bytes depend on the attempt alone: not on the time, the machine or who exports it. An
/// imported attempt leaves as it came: its manifest was kept, and names its first origin.
#pragma once

#include <filesystem>

#include "database/exchange/derived_files.h"
#include "database/store/connection.h"

namespace hallux::database {

/// Writes `folder`/UUID. Derived files of an imported attempt that are not those its manifest names
/// (another version of this program makes others) are left out.
/// needs   `folder` is there
/// errors  DatabaseError: BadInput while it is being recorded or where its recording was erased;
///         Damaged; storage failures
void export_attempt(Database& database, const AttemptId& id, const std::filesystem::path& folder,
                    const MakeDerived& make_derived);

}  // namespace hallux::database
