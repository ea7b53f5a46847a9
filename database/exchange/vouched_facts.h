/// Facts of an exported attempt that its seal does not hold, and what is taken of them where
/// nothing vouches for them. Inside this corner only.
///
/// A seal is no signature: who makes a manifest can make all of it. That the origin is one's own is
/// vouched for by who accepts it, and by an anchor.
#pragma once

#include <string>

#include "database/exchange/manifest.h"

namespace hallux::database {

/// BLAKE2b-256 of: the act's link and number, uuid, number of the person (0: the robot's), how many
/// decisions, and of each kind, score it is about (-1: none), thousandths (-1: none), who decided
/// and when.
/// needs   the manifest has an act
Digest facts_of(const Manifest& manifest) noexcept;

/// What is taken of a manifest: all, or where an older program sealed or exported it a practice
/// without decisions.
struct TakenManifest {
  Manifest manifest;
  /// Why not all; empty where it is.
  std::string why_not_all;
};
/// needs   the seal fits the last link, where there is one
TakenManifest taken_of(const Manifest& manifest);

}  // namespace hallux::database
