/// A scenario, table or patient that cannot be used, said in one sentence: the file, the place and
/// the mend.
#pragma once

#include <stdexcept>

namespace hallux::scenarios {

class ScenarioError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace hallux::scenarios
