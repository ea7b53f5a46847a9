/// Looks for a secret in the memory of this process, as somebody with a core dump or the swap file
/// would.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace hallux {

/// A secret that is never spelled in memory by its keeper: the letters are kept backwards.
class PlantedSecret {
 public:
  PlantedSecret();
  /// Spells it once. The caller wipes what it is given.
  std::string spelled() const;
  std::size_t size() const noexcept { return backwards_.size(); }
  /// At how many places of the writable memory of this process it stands, spelled forwards.
  std::size_t places_in_memory() const;

 private:
  std::vector<char> backwards_;
};

}  // namespace hallux
