/// A scene kept to tell whether the next one is the same picture.
#pragma once

#include <cstdint>
#include <vector>

#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// Meshes and looks are told by their ids, too: another may lie where one was that went.
class RememberedScene {
 public:
  explicit RememberedScene(const Scene& scene);

  friend bool operator==(const RememberedScene&, const RememberedScene&) = default;

 private:
  /// Its pointers are compared, never followed.
  Scene scene_;
  std::vector<std::uint64_t> ids_;
};

}  // namespace hallux::ui
