#include "database/recording/certificate_json.h"

#include "database/store/database_error.h"
#include "database/text/json_record.h"

namespace hallux::database {

template <>
inline constexpr std::tuple fields_of<RecordingCertificate>{
    Field{"expected_samples", &RecordingCertificate::expected_samples},
    Field{"received_samples", &RecordingCertificate::received_samples},
    Field{"gaps", &RecordingCertificate::gaps},
    Field{"duplicates", &RecordingCertificate::duplicates},
    Field{"missed_ticks", &RecordingCertificate::missed_ticks},
    Field{"pauses", &RecordingCertificate::pauses},
    Field{"unseen_us", &RecordingCertificate::unsampled_us},
    Field{"clock_steps", &RecordingCertificate::clock_steps},
    Field{"faulted_ticks", &RecordingCertificate::faulted_ticks},
    Field{"device_changed", &RecordingCertificate::has_changed_device},
    Field{"late_p50_us", &RecordingCertificate::late_p50_us},
    Field{"late_p99_us", &RecordingCertificate::late_p99_us},
    Field{"late_max_us", &RecordingCertificate::late_max_us},
    Field{"ring_share_max", &RecordingCertificate::ring_share_max},
    Field{"priority", &RecordingCertificate::has_priority},
    Field{"locked_memory", &RecordingCertificate::has_locked_memory}};

namespace {

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

}  // namespace

std::string json_from_certificate(const RecordingCertificate& certificate) {
  const Verdict verdict = verdict_of(certificate);
  auto json = json_of(certificate);
  json["complete"] = certificate.is_complete();
  json["valid"] = verdict.is_valid();
  json["not_valid_because"] = json_of(verdict.reasons);
  return json.dump();
}

std::optional<RecordingCertificate> certificate_from_json(std::string_view json) {
  const auto found = object_in(json);
  if (!found) return std::nullopt;
  try {
    RecordingCertificate certificate;
    for (const char* key : {"expected_samples", "received_samples"}) field_in(*found, key);
    // The others came one after another; what an older record does not have is 0 or false.
    visit_fields<RecordingCertificate>([&](const auto& field) {
      if (!found->contains(field.key)) return;
      read_json(found->at(field.key), field.key, certificate.*field.member);
    });
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
