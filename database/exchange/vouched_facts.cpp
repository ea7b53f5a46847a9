#include "database/exchange/vouched_facts.h"

#include "database/recording/chain.h"

namespace hallux::database {

namespace {

/// An attempt without a seal is no assessment that could count.
bool has_sealed_purpose(const Manifest& manifest) {
  return manifest.header.seal && seal_form(manifest.last_link, manifest.header) == SealForm::All;
}

}  // namespace

Digest facts_of(const Manifest& manifest) noexcept {
  Digester digester;
  digester.add_digest(manifest.act->link);
  digester.add_int(manifest.act->number);
  digester.add_text(manifest.header.id.text);
  digester.add_int(manifest.header.begun.person.value_or(PersonId{}).number);
  digester.add_int(static_cast<std::int64_t>(manifest.decisions.size()));
  for (const ExportedDecision& decision : manifest.decisions) {
    digester.add_text(name_of(decision.kind));
    digester.add_int(decision.about ? static_cast<std::int64_t>(*decision.about) : -1);
    digester.add_int(decision.score_milli.value_or(-1));
    digester.add_int(decision.decided_by.number);
    digester.add_text(decision.decided_utc);
  }
  return digester.finish();
}

TakenManifest taken_of(const Manifest& manifest) {
  TakenManifest taken{manifest, {}};
  const bool is_sealed = has_sealed_purpose(manifest), has_act = manifest.act.has_value();
  if (!manifest.header.seal || (is_sealed && has_act)) return taken;
  const char* const why = has_act
                              ? "was sealed by an older program, which did not seal what it was for"
                              : "was exported by an older program, which bound nobody and no "
                                "decision to its audit";
  taken.why_not_all = "attempt " + manifest.header.id.text + " " + why +
                      ": it is taken as practice, and no decision about it is in force";
  taken.manifest.header.begun.kind = AttemptKind::Practice;
  taken.manifest.decisions.clear();
  taken.manifest.header.state = AttemptState::Closed;
  return taken;
}

}  // namespace hallux::database
