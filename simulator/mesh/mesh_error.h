/// A mesh that cannot be used, said in one sentence: the file, what is wrong with it, where, and
/// how to mend it.
#pragma once

#include <stdexcept>

namespace hallux::simulator {

class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace hallux::simulator
