/// Reads the folder of an exported attempt, which nobody vouches for, and proves what can be
/// proven: the record, the bone, the scenario and the facts by chain and seal.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "database/exchange/manifest.h"
#include "database/exchange/record_tables.h"
#include "simulator/record/display_fact.h"

namespace hallux::database {

struct ImportedAttempt {
  /// What is taken of the one that was read.
  Manifest manifest;
  /// Why not all of it is taken; empty where it is.
  std::string why_not_all = {};
  /// As it was read: kept, so that it can be exported again as it came.
  std::string manifest_text;
  std::vector<std::byte> bone;
  ReadTables tables;
  /// Outside the seal; none of an older export.
  std::vector<simulator::DisplayFact> display_facts;
};

/// Reads a folder that export_attempt wrote.
/// ensures every file that is there has the digest its manifest says; links and seal fit the tables
/// errors  DatabaseError: BadInput naming file and place; Newer; InputOutput
ImportedAttempt read_exported(const std::filesystem::path& folder);

/// The folders of exported attempts in `folder`, by name: itself, or those right below it.
/// errors  DatabaseError BadInput where there is none
std::vector<std::filesystem::path> find_exported(const std::filesystem::path& folder);

}  // namespace hallux::database
