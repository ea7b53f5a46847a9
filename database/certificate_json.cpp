#include "database/certificate_json.h"

#include <nlohmann/json.hpp>

namespace hallux::database {

namespace {

using Json = nlohmann::ordered_json;

bool is_true(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

template <typename Value>
void take(const Json& object, const char* name, Value& value) {
  value = object.value(name, value);
}

void take_counts(const Json& found, RecordingCertificate& certificate) {
  take(found, "gaps", certificate.gaps);
  take(found, "duplicates", certificate.duplicates);
  take(found, "missed_ticks", certificate.missed_ticks);
  take(found, "pauses", certificate.pauses);
  take(found, "unseen_us", certificate.unseen_us);
  take(found, "clock_steps", certificate.clock_steps);
  take(found, "faulted_ticks", certificate.faulted_ticks);
}

void take_circumstances(const Json& found, RecordingCertificate& certificate) {
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
              {"unseen_us", certificate.unseen_us},
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
  const Json found = Json::parse(json, nullptr, false);
  if (!found.is_object()) return std::nullopt;
  try {
    RecordingCertificate certificate;
    found.at("expected_samples").get_to(certificate.expected_samples);
    found.at("received_samples").get_to(certificate.received_samples);
    take_counts(found, certificate);
    take_circumstances(found, certificate);
    return certificate;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // a word where a number was expected: no object of ours
  }
}

bool is_valid_by(std::string_view quality_json) {
  const Json found = Json::parse(quality_json, nullptr, false);
  if (!found.is_object()) return false;
  return is_true(found, found.contains("valid") ? "valid" : "complete");
}

}  // namespace hallux::database
