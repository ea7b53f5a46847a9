/// A manifest comes from a stranger. Each field is read with bounds and a shape of its own, and
/// then all are held against each other: seal and duration, scores and decisions, state and last
/// decision. What passes here could have been written by this program; only the tables' digests and
/// the chain can say whether it was.
#include "database/exchange/read_manifest.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "database/exchange/vouched_facts.h"
#include "database/text/json_fields.h"

namespace hallux::database {

namespace {

using nlohmann::json;

constexpr std::size_t short_bytes_max = 255, quality_bytes_max = 64 * 1024;
constexpr std::size_t scenario_bytes_max = std::size_t{1} << 20U;
constexpr std::size_t scores_max = 1000, decisions_max = 1000, files_max = 300;
constexpr std::int64_t file_bytes_max = std::int64_t{4} << 30U;
constexpr std::int64_t duration_ticks_max = 86'400'000;
constexpr int depth_max = 12;

[[noreturn]] void refuse(const std::string& sentence) {
  throw DatabaseError{DatabaseErrorKind::BadInput, sentence};
}

/// A short text that may reach a terminal or a screen as it is.
std::string line_in(const json& object, const char* key) {
  std::string text = text_in(object, key, short_bytes_max);
  const bool is_clean = std::none_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
  });
  if (!is_clean) refuse("'" + std::string{key} + "' holds control characters");
  return text;
}

bool has_shape(std::string_view text, std::string_view shape) noexcept {
  if (text.size() != shape.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_digit = text[i] >= '0' && text[i] <= '9';
    const bool is_hex = is_digit || (text[i] >= 'a' && text[i] <= 'f');
    const bool fits = shape[i] == '0' ? is_digit : shape[i] == 'x' ? is_hex : text[i] == shape[i];
    if (!fits) return false;
  }
  return true;
}

std::string shaped_in(const json& object, const char* key, std::string_view shape) {
  std::string text = text_in(object, key, short_bytes_max);
  if (!has_shape(text, shape)) refuse("'" + std::string{key} + "' is not written as it must be");
  return text;
}

std::string time_in(const json& object, const char* key) {
  return shaped_in(object, key, "0000-00-00T00:00:00.000Z");
}

Digest digest_in(const json& object, const char* key) {
  const auto digest = digest_from_hex(text_in(object, key, short_bytes_max));
  if (!digest) refuse("'" + std::string{key} + "' is no digest");
  return *digest;
}

template <typename Number>
Number number_from(std::string_view text, const char* key) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) {
    refuse("'" + std::string{key} + "' holds no number");
  }
  return number;
}

std::optional<PersonId> person_in(const json& object, const char* key) {
  constexpr std::string_view start = "person-";
  if (field_in(object, key).is_null()) return std::nullopt;
  const std::string& text = text_in(object, key, short_bytes_max);
  if (!text.starts_with(start)) refuse("'" + std::string{key} + "' names no person");
  const auto number = number_from<std::int64_t>(std::string_view{text}.substr(start.size()), key);
  if (number < 1) refuse("'" + std::string{key} + "' names no person");
  return PersonId{number};
}

template <Named Enumeration>
void take_named(const json& object, const char* key, Enumeration& value) {
  const auto found = named<Enumeration>(text_in(object, key));
  if (!found) refuse("'" + std::string{key} + "' is none that this program knows");
  value = *found;
}

std::int32_t version_in(const json& object, const char* key) {
  return static_cast<std::int32_t>(
      integer_in(object, key, 1, std::numeric_limits<std::int32_t>::max()));
}

NewAttempt begun_in(const json& attempt) {
  NewAttempt begun;
  begun.person = person_in(attempt, "person");
  take_named(attempt, "kind", begun.kind);
  begun.hand = line_in(attempt, "hand");
  begun.seed = number_from<std::uint64_t>(text_in(attempt, "seed", short_bytes_max), "seed");
  begun.device_class = line_in(attempt, "device_class");
  begun.pacing = line_in(attempt, "pacing");
  begun.stereo_mode = line_in(attempt, "stereo_mode");
  take_named(attempt, "guidance", begun.guidance);
  begun.engine = version_in(attempt, "engine_version");
  begun.bone = digest_in(attempt, "bone");
  return begun;
}

AttemptHeader header_in(const json& attempt) {
  AttemptHeader header;
  header.id = {shaped_in(attempt, "uuid", "xxxxxxxx-xxxx-xxxx-xxxx-xxxxxxxxxxxx")};
  header.begun = begun_in(attempt);
  header.is_simulated = flag_in(attempt, "is_simulated");
  take_named(attempt, "state", header.state);
  header.started_utc = time_in(attempt, "started_utc");
  if (!field_in(attempt, "duration_ticks").is_null()) {
    header.duration_ticks = integer_in(attempt, "duration_ticks", 0, duration_ticks_max);
  }
  header.quality_json = text_in(attempt, "quality", quality_bytes_max);
  if (!field_in(attempt, "seal").is_null()) header.seal = digest_in(attempt, "seal");
  return header;
}

void check_header(const AttemptHeader& header) {
  const NewAttempt& begun = header.begun;
  const bool is_sealed = header.seal.has_value();
  if (header.state == AttemptState::Recording) refuse("it says that it is still being recorded");
  if (header.state == AttemptState::Closed && !is_sealed) refuse("it is closed and has no seal");
  if (header.state == AttemptState::Interrupted && is_sealed) {
    refuse("it was interrupted and has a seal");
  }
  if (is_sealed != header.duration_ticks.has_value() || is_sealed == header.quality_json.empty()) {
    refuse("a seal, a duration and a quality come together");
  }
  if (begun.person && !begun.hand.empty() && !header.is_simulated) {
    refuse("a scripted hand is no person's");
  }
  if (begun.kind == AttemptKind::Assessment && begun.guidance != simulator::Guidance::None) {
    refuse("an assessment is not guided");
  }
}

ScenarioText scenario_in(const json& object, Digest& digest) {
  digest = digest_in(object, "digest");
  ScenarioText text{line_in(object, "name"), version_in(object, "version"),
                    text_in(object, "text", scenario_bytes_max), flag_in(object, "is_reviewed")};
  if (digest_of(std::as_bytes(std::span{text.json.data(), text.json.size()})) != digest) {
    refuse("the scenario's text does not have its digest");
  }
  return text;
}

std::vector<ExportedScore> scores_in(const json& list) {
  std::vector<ExportedScore> scores;
  for (const json& entry : list) {
    scores.push_back({time_in(entry, "stored_utc"), flag_in(entry, "is_in_force"),
                      field_in(entry, "card").dump()});
  }
  const auto in_force = std::count_if(scores.begin(), scores.end(),
                                      [](const ExportedScore& score) { return score.is_in_force; });
  if (in_force > 1 || (!scores.empty() && !scores.back().is_in_force)) {
    refuse("of its scores not the last one is in force");
  }
  return scores;
}

ExportedDecision decision_in(const json& entry, std::size_t score_count) {
  ExportedDecision decision;
  take_named(entry, "kind", decision.kind);
  if (!field_in(entry, "about_score").is_null()) {
    decision.about = static_cast<std::size_t>(
        integer_in(entry, "about_score", 0, static_cast<std::int64_t>(score_count) - 1));
  }
  if (!field_in(entry, "score_milli").is_null()) {
    decision.score_milli = integer_in(entry, "score_milli", 0, 100'000);
  }
  const bool is_void = decision.kind == DecisionKind::Voided;
  if (is_void == decision.score_milli.has_value() || (!is_void && !decision.about)) {
    refuse("a decision has no score where it needs one, or one where it has none");
  }
  const auto by = person_in(entry, "decided_by");
  if (!by) refuse("a decision is nobody's");
  decision.decided_by = *by;
  decision.decided_utc = time_in(entry, "decided_utc");
  return decision;
}

std::vector<ExportedDecision> decisions_in(const json& list, const Manifest& manifest) {
  std::vector<ExportedDecision> decisions;
  std::size_t about = 0;
  for (const json& entry : list) {
    decisions.push_back(decision_in(entry, manifest.scores.size()));
    const std::size_t next = decisions.back().about.value_or(about);
    if (next < about) refuse("its decisions are not in their order");
    about = next;
  }
  const bool is_void = !decisions.empty() && decisions.back().kind == DecisionKind::Voided;
  if (is_void != (manifest.header.state == AttemptState::Void)) {
    refuse("its state is not what was decided");
  }
  return decisions;
}

std::vector<ExchangeFile> files_in(const json& list) {
  std::vector<ExchangeFile> files;
  for (const json& entry : list) {
    files.push_back({text_in(entry, "name", short_bytes_max),
                     integer_in(entry, "bytes", 0, file_bytes_max),
                     digest_in(entry, "blake2b_256")});
    if (!is_exchange_name(files.back().name) || files.back().name == manifest_name) {
      refuse("it names a file that no export holds");
    }
    if (files.size() > 1 && !(files[files.size() - 2].name < files.back().name)) {
      refuse("its files are not in the order of their names");
    }
  }
  return files;
}

ExportedAct act_in(const json& object) {
  return {integer_in(object, "number", 1), digest_in(object, "link"), digest_in(object, "facts")};
}

Manifest manifest_in(const json& document) {
  if (text_in(document, "format") != "hallux-attempt") refuse("it is no exported attempt");
  const std::int64_t format = integer_in(document, "format_version", 1);
  if (format > manifest_format) {
    throw DatabaseError{DatabaseErrorKind::Newer,
                        "it was exported by a newer version of this program; update this one"};
  }
  Manifest manifest;
  manifest.directory = {shaped_in(document, "directory", std::string(32, 'x'))};
  manifest.header = header_in(field_in(document, "attempt"));
  check_header(manifest.header);
  manifest.last_link = digest_in(document, "last_link");
  manifest.scenario = scenario_in(field_in(document, "scenario"), manifest.header.scenario_digest);
  manifest.header.scenario_name = manifest.scenario.name;
  manifest.header.scenario_version = manifest.scenario.version;
  manifest.scores = scores_in(list_in(document, "scores", scores_max));
  manifest.decisions = decisions_in(list_in(document, "decisions", decisions_max), manifest);
  manifest.files = files_in(list_in(document, "files", files_max));
  if (format == 1) return manifest;
  manifest.act = act_in(field_in(document, "audit"));
  if (manifest.act->facts != facts_of(manifest)) {
    refuse("its person or its decisions are not those of the act that it names");
  }
  return manifest;
}

}  // namespace

Manifest manifest_from_json(std::string_view text) {
  constexpr auto bytes_max = static_cast<std::size_t>(manifest_bytes_max);
  try {
    return manifest_in(parse_json("it", text, {bytes_max, depth_max}));
  } catch (const DatabaseError& error) {
    if (error.kind() != DatabaseErrorKind::Damaged) throw;
    throw DatabaseError{DatabaseErrorKind::BadInput, error.what()};
  }
}

}  // namespace hallux::database
