#include "database/recording/chain.h"

namespace hallux::database {

namespace {

/// Nothing for an attempt without one, as before there was guidance.
void add_guidance(Digester& digester, simulator::Guidance guidance) noexcept {
  if (guidance != simulator::Guidance::None) digester.add_text(name_of(guidance));
}

}  // namespace

Digest link_of(const Digest& before, const AttemptId& attempt, const ChunkPlace& place,
               std::span<const std::byte> payload) noexcept {
  Digester digester;
  digester.add_digest(before);
  digester.add_text(attempt.text);
  digester.add_int(static_cast<std::int64_t>(place.stream));
  digester.add_int(place.seq);
  digester.add_int(place.first_tick);
  digester.add_int(place.row_count);
  digester.add_bytes(payload);
  return digester.finish();
}

namespace {

Digest seal_in_form(SealForm form, const Digest& last_link, const AttemptHeader& header) noexcept {
  Digester digester;
  digester.add_digest(last_link);
  digester.add_text(header.id.text);
  digester.add_digest(header.scenario_digest);
  digester.add_text(header.begun.hand);
  digester.add_int(static_cast<std::int64_t>(header.begun.seed));
  digester.add_text(header.begun.device_class);
  digester.add_text(header.begun.pacing);
  digester.add_text(header.begun.stereo_mode);
  digester.add_digest(header.begun.bone);
  digester.add_int(header.begun.engine);
  digester.add_text(header.started_utc);
  digester.add_int(header.duration_ticks.value_or(0));
  digester.add_text(header.quality_json);
  if (form == SealForm::WithoutPurpose) {
    add_guidance(digester, header.begun.guidance);
  } else {
    digester.add_text(name_of(header.begun.guidance));
    digester.add_text(name_of(header.begun.kind));
    digester.add_int(header.is_simulated ? 1 : 0);
  }
  return digester.finish();
}

}  // namespace

Digest seal_of(const Digest& last_link, const AttemptHeader& header) noexcept {
  return seal_in_form(SealForm::All, last_link, header);
}

std::optional<SealForm> seal_form(const Digest& last_link, const AttemptHeader& header) noexcept {
  for (const SealForm form : {SealForm::All, SealForm::WithoutPurpose}) {
    if (header.seal == seal_in_form(form, last_link, header)) return form;
  }
  return std::nullopt;
}

Digest purpose_digest(AttemptKind kind, bool is_simulated, simulator::Guidance guidance) noexcept {
  Digester digester;
  digester.add_text(name_of(kind));
  digester.add_int(is_simulated ? 1 : 0);
  add_guidance(digester, guidance);
  return digester.finish();
}

}  // namespace hallux::database
