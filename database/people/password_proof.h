/// Proof to a desk that its holder has just given their password again. Inside this room only.
#pragma once

#include "database/records/ids.h"

namespace hallux::database {

/// Made by Session::prove alone; for what a passer-by at a window left open must not be able to do.
class PasswordProof {
 public:
  PersonId person() const noexcept { return person_; }

 private:
  friend class Session;
  explicit PasswordProof(PersonId person) : person_(person) {}
  PersonId person_;
};

}  // namespace hallux::database
