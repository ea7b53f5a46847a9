/// Hash chain of an attempt's chunks and the seal that closes it. Inside this room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "database/recording/chunk_codec.h"
#include "database/records/attempt.h"
#include "simulator/base/digest.h"

namespace hallux::database {

/// Where a chunk stands in the record.
struct ChunkPlace {
  Stream stream = Stream::Tape;
  /// Number of the half-second window.
  std::int64_t seq = 0;
  /// Of its first row.
  std::int64_t first_tick = 0;
  std::int64_t row_count = 0;
};

/// BLAKE2b-256 of the link before (zeros for the first), the attempt, the place and the payload.
Digest link_of(const Digest& before, const AttemptId& attempt, const ChunkPlace& place,
               std::span<const std::byte> payload) noexcept;

/// BLAKE2b-256 of the last link and of every fact in the header except the person, whose name may
/// be erased and whose number the audit chain holds.
/// needs   duration_ticks is known
Digest seal_of(const Digest& last_link, const AttemptHeader& header) noexcept;

/// What a seal is of.
enum class SealForm {
  /// As seal_of makes it.
  All,
  /// As older programs made it: without the kind of the attempt and whether it is simulated.
  WithoutPurpose
};
/// Nothing where the header's seal fits neither.
/// needs   the header has a seal
std::optional<SealForm> seal_form(const Digest& last_link, const AttemptHeader& header) noexcept;

/// Binds what an attempt is for to the audit row of its beginning: BLAKE2b-256 of the name of the
/// kind, 1 or 0, and the name of the guidance where there is one.
Digest purpose_digest(AttemptKind kind, bool is_simulated, simulator::Guidance guidance) noexcept;

}  // namespace hallux::database
