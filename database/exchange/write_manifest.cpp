#include "database/exchange/write_manifest.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "database/course/score_json.h"

namespace hallux::database {

namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::optional<Digest>& digest) {
  return digest ? Json(hex_from_digest(*digest)) : Json(nullptr);
}

Json person_text(const std::optional<PersonId>& person) {
  return person ? Json("person-" + std::to_string(person->number)) : Json(nullptr);
}

template <typename Number>
Json number_or_null(const std::optional<Number>& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json attempt_json(const AttemptHeader& header) {
  const NewAttempt& begun = header.begun;
  return {{"uuid", header.id.text},
          {"person", person_text(begun.person)},
          {"kind", name_of(begun.kind)},
          {"is_simulated", header.is_simulated},
          {"state", name_of(header.state)},
          {"started_utc", header.started_utc},
          {"duration_ticks", number_or_null(header.duration_ticks)},
          {"hand", begun.hand},
          {"seed", std::to_string(begun.seed)},
          {"device_class", begun.device_class},
          {"pacing", begun.pacing},
          {"stereo_mode", begun.stereo_mode},
          {"guidance", name_of(begun.guidance)},
          {"engine_version", begun.engine},
          {"bone", hex_from_digest(begun.bone)},
          {"quality", header.quality_json},
          {"seal", text_or_null(header.seal)}};
}

Json scenario_json(const Manifest& manifest) {
  return {{"name", manifest.scenario.name},
          {"version", manifest.scenario.version},
          {"is_reviewed", manifest.scenario.is_reviewed},
          {"digest", hex_from_digest(manifest.header.scenario_digest)},
          {"text", manifest.scenario.json}};
}

Json scores_json(const std::vector<ExportedScore>& scores) {
  Json list = Json::array();
  for (const ExportedScore& score : scores) {
    list.push_back({{"stored_utc", score.stored_utc},
                    {"is_in_force", score.is_in_force},
                    {"card", Json::parse(score.card_json)}});
  }
  return list;
}

Json decisions_json(const std::vector<ExportedDecision>& decisions) {
  Json list = Json::array();
  for (const ExportedDecision& decision : decisions) {
    list.push_back({{"kind", name_of(decision.kind)},
                    {"about_score", number_or_null(decision.about)},
                    {"score_milli", number_or_null(decision.score_milli)},
                    {"decided_by", person_text(decision.decided_by)},
                    {"decided_utc", decision.decided_utc}});
  }
  return list;
}

Json act_json(const ExportedAct& act) {
  return {{"number", act.number},
          {"link", hex_from_digest(act.link)},
          {"facts", hex_from_digest(act.facts)}};
}

Json files_json(const std::vector<ExchangeFile>& files) {
  Json list = Json::array();
  for (const ExchangeFile& file : files) {
    list.push_back({{"name", file.name},
                    {"bytes", file.bytes},
                    {"blake2b_256", hex_from_digest(file.digest)}});
  }
  return list;
}

}  // namespace

std::string json_from_manifest(const Manifest& manifest) {
  try {
    Json json{{"format", "hallux-attempt"},
              {"format_version", manifest.act ? manifest_format : 1},
              {"directory", manifest.directory.text},
              {"attempt", attempt_json(manifest.header)},
              {"last_link", hex_from_digest(manifest.last_link)},
              {"scenario", scenario_json(manifest)},
              {"scores", scores_json(manifest.scores)},
              {"decisions", decisions_json(manifest.decisions)}};
    if (manifest.act) json["audit"] = act_json(*manifest.act);
    json["files"] = files_json(manifest.files);
    return json.dump(1) + "\n";
  } catch (const Json::exception& error) {
    throw DatabaseError{
        DatabaseErrorKind::Damaged,
        "attempt " + manifest.header.id.text + " holds a text that is none: " + error.what()};
  }
}

}  // namespace hallux::database
