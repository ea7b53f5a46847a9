#include "database/recording/certificate_json.h"

#include <nlohmann/json.hpp>

#include "database/store/database_error.h"
#include "database/store/json_fields.h"

namespace hallux::database {

namespace {

using Json = nlohmann::ordered_json;

constexpr JsonBounds bounds{64 * 1024, 4};

bool is_true(const nlohmann::json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

/// The object that the text is; nothing where it is none.
std::optional<nlohmann::json> object_in(std::string_view text) {
  try {
    nlohmann::json found = parse_json("it", text, bounds);
    if (found.is_object()) return found;
  } catch (const DatabaseError&) {
    return std::nullopt;  // no JSON, or nested deeper than ours
  }
  return std::nullopt;
}

void take(const nlohmann::json& object, const char* name, std::int64_t& value) {
  if (object.contains(name)) value = integer_in(object, name);
}

void take(const nlohmann::json& object, const char* name, double& value) {
  if (object.contains(name)) value = number_in(object, name);
}

void take(const nlohmann::json& object, const char* name, bool& value) {
  if (object.contains(name)) value = flag_in(object, name);
}

void take_counts(const nlohmann::json& found, RecordingCertificate& certificate) {
  take(found, "gaps", certificate.gaps);
  take(found, "duplicates", certificate.duplicates);
  take(found, "missed_ticks", certificate.missed_ticks);
  take(found, "pauses", certificate.pauses);
  take(found, "unseen_us", certificate.unsampled_us);
  take(found, "clock_steps", certificate.clock_steps);
  take(found, "faulted_ticks", certificate.faulted_ticks);
}

void take_circumstances(const nlohmann::json& found, RecordingCertificate& certificate) {
  take(found, "late_p50_us", certificate.late_p50_us);
  take(found, "late_p99_us", certificate.late_p99_us);
  take(found, "late_max_us", certificate.late_max_us);
  take(found, "ring_share_max", certificate.ring_share_max);
  take(found, "priority", certificate.has_priority);
  take(found, "locked_memory", certificate.has_locked_memory);
}

}  // namespace

std::string json_from_certificate(const RecordingCertificate& certificate) {
  const Verdict verdict = verdict_of(certificate);
  Json reasons = Json::array();
  for (const Invalidity reason : verdict.reasons) reasons.push_back(name_of(reason));
  return Json{{"expected_samples", certificate.expected_samples},
              {"received_samples", certificate.received_samples},
              {"gaps", certificate.gaps},
              {"duplicates", certificate.duplicates},
              {"missed_ticks", certificate.missed_ticks},
              {"pauses", certificate.pauses},
              {"unseen_us", certificate.unsampled_us},
              {"clock_steps", certificate.clock_steps},
              {"faulted_ticks", certificate.faulted_ticks},
              {"late_p50_us", certificate.late_p50_us},
              {"late_p99_us", certificate.late_p99_us},
              {"late_max_us", certificate.late_max_us},
              {"ring_share_max", certificate.ring_share_max},
              {"priority", certificate.has_priority},
              {"locked_memory", certificate.has_locked_memory},
              {"complete", certificate.is_complete()},
              {"valid", verdict.is_valid()},
              {"not_valid_because", reasons}}
      .dump();
}

std::optional<RecordingCertificate> certificate_from_json(std::string_view json) {
  const auto found = object_in(json);
  if (!found) return std::nullopt;
  try {
    RecordingCertificate certificate;
    certificate.expected_samples = integer_in(*found, "expected_samples");
    certificate.received_samples = integer_in(*found, "received_samples");
    take_counts(*found, certificate);
    take_circumstances(*found, certificate);
    return certificate;
  } catch (const DatabaseError&) {
    return std::nullopt;  // a word where a number was expected: no object of ours
  }
}

bool is_valid_by(std::string_view quality_json) {
  const auto found = object_in(quality_json);
  if (!found) return false;
  return is_true(*found, found->contains("valid") ? "valid" : "complete");
}

}  // namespace hallux::database
