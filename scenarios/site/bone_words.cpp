#include "scenarios/site/bone_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hallux::scenarios {

std::string direction_text(const Vec3& direction_in_bone) {
  const std::array<double, 3> parts{direction_in_bone.y, direction_in_bone.z, direction_in_bone.x};
  constexpr std::array<const char*, 3> positive{"dorsal", "lateral", "distal"};
  constexpr std::array<const char*, 3> negative{"plantar", "medial", "proximal"};
  double greatest = 0.0;
  for (const double part : parts) greatest = std::max(greatest, std::abs(part));
  if (greatest == 0.0) return "";
  std::vector<std::size_t> named;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::abs(parts[axis]) >= 0.5 * greatest) named.push_back(axis);
  }
  if (named.size() == 3) {  // three words help nobody: the smallest is left out
    named.erase(std::min_element(named.begin(), named.end(), [&](std::size_t a, std::size_t b) {
      return std::abs(parts[a]) < std::abs(parts[b]);
    }));
  }
  std::string words;
  for (const std::size_t axis : named) {
    if (!words.empty()) words += "-";
    words += parts[axis] > 0.0 ? positive[axis] : negative[axis];
  }
  return words;
}

}  // namespace hallux::scenarios
