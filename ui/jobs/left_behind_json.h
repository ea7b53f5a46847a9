/// What an attempt left behind, for other programs.
///
/// Nothing of ours reads it: it is made from what is sealed.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "ui/jobs/left_behind.h"

namespace hallux::ui {

inline constexpr const char* fragments_file_name = "fragments.json";
inline constexpr const char* implants_file_name = "implants.json";

/// In an export: "piece-1.ply".
std::string piece_file_name(std::size_t piece);
/// Of a body where a wedge was closed: its halves may be one piece, as they are scored, and are two
/// bodies. "body-1.ply".
std::string body_file_name(std::size_t piece);

/// Each body: where it went, how near to the plan, how it stands against the others. Metrics that
/// do not apply are null.
nlohmann::ordered_json fragments_json(const LeftBehind& left);
nlohmann::ordered_json implants_json(const LeftBehind& left);
/// input = pieces + removed + debris, but for the error; holes are in the pieces.
nlohmann::ordered_json balance_json(const LeftBehind& left);
/// The scenario's steps in their order, and whether each was done.
nlohmann::ordered_json steps_json(const LeftBehind& left, const scenarios::Scenario& scenario);

/// fragments.json and implants.json of an export.
/// name_of  of each body's file, by its place among the pieces
/// ensures  the same attempt gives the same bytes, UTF-8
std::string fragments_file(const LeftBehind& left, const simulator::Bones& bones,
                           std::string (*name_of)(std::size_t));
std::string implants_file(const LeftBehind& left);

}  // namespace hallux::ui
