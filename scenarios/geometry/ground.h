/// The names of a scenario on its patient: landmarks, axes, and the points and directions that the
/// scenario makes from them. Inside this corner only.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "scenarios/scenario.h"
#include "simulator/mesh/bones.h"

namespace hallux::scenarios {

/// Shorter than this a direction says nothing [mm, or the sine of an angle].
inline constexpr double direction_length_min = 1.0e-3;

/// A direction of unit length.
/// errors  ScenarioError "PATH: WHAT; MEND" where it is shorter than direction_length_min
Vec3 unit_or_refuse(const Vec3& direction, const std::string& path, std::string_view what,
                    std::string_view mend);

/// Borrows scenario and bones; both must outlive it.
class Ground {
 public:
  /// Lays all points and directions of the scenario.
  /// bones   in the order in which the scenario asks for them, as many
  /// errors  ScenarioError: another number of bones, a landmark that a bone lacks, points that
  ///         coincide, directions that are parallel, a ray that misses, a point that is named like
  ///         a landmark
  Ground(const Scenario& scenario, const simulator::Bones& bones);

  /// Of a part that names its bone; empty: the first.
  /// needs   the scenario was read, which refuses other names
  std::size_t bone_index(std::string_view name) const noexcept;
  const simulator::Bone& bone(std::size_t index) const noexcept { return bones_[index]; }
  std::size_t bone_count() const noexcept { return bones_.size(); }

  /// A named point, else a landmark of that bone [mm, in its frame]; `path` says who asks.
  /// errors  ScenarioError with the names that there are
  Vec3 point(const std::string& name, std::size_t bone, const std::string& path) const;
  /// A named direction, else an axis of that bone or of the foot, of unit length, in the bone's
  /// frame.
  Vec3 direction(const std::string& name, std::size_t bone, const std::string& path) const;

  /// Of one bone's frame as another says it.
  Vec3 moved_point(const Vec3& point_mm, std::size_t from_bone, std::size_t to_bone) const;
  Vec3 moved_direction(const Vec3& direction, std::size_t from_bone, std::size_t to_bone) const;

  /// What the plan finds later, a hinge's line: its name stands for a point and a direction.
  void add_line(const std::string& name, std::size_t bone, const Vec3& point_mm,
                const Vec3& direction);

 private:
  struct Laid {
    std::size_t bone = 0;
    Vec3 in_bone{0.0, 0.0, 0.0};
  };

  void lay(const NamedPoint& point, const std::string& path);
  void lay(const NamedDirection& direction, const std::string& path);
  Vec3 made(const NamedPoint& point, std::size_t bone, const std::string& path) const;
  Vec3 made(const NamedDirection& direction, std::size_t bone, const std::string& path) const;

  const Scenario& scenario_;
  simulator::Bones bones_;
  std::map<std::string, Laid, std::less<>> points_, directions_;
};

}  // namespace hallux::scenarios
