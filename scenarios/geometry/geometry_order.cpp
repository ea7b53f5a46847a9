// Each list refers to its own earlier entries only, so the two need no search: whichever list's
// next entry has all that it is made from is laid next, and where neither has, the two lists wait
// for each other, or for a name that is nowhere.
#include "scenarios/geometry/geometry_order.h"

#include <algorithm>
#include <array>
#include <set>

#include "scenarios/json_node.h"

namespace hallux::scenarios {
namespace {

constexpr std::array<std::string_view, 12> axes{
    "distal",      "proximal",      "dorsal",      "plantar",      "medial",      "lateral",
    "foot_distal", "foot_proximal", "foot_dorsal", "foot_plantar", "foot_medial", "foot_lateral"};

/// Where in the file a name is asked for, and what for.
struct Asking {
  std::string path;
  std::string name;
  bool wants_point = false;
};

std::vector<Asking> asked_by(const NamedPoint& point, std::size_t index) {
  const std::string path = "points[" + std::to_string(index) + "]";
  std::vector<Asking> asked;
  switch (point.kind) {
    case PointKind::Moved:
      asked.push_back({path + ".at", point.from, true});
      for (std::size_t i = 0; i < point.moves.size(); ++i)
        asked.push_back({path + ".move[" + std::to_string(i) + "].along", point.moves[i].along});
      break;
    case PointKind::Between:
      asked.push_back({path + ".between[0]", point.from, true});
      asked.push_back({path + ".between[1]", point.to, true});
      break;
    case PointKind::OnSurface:
      asked.push_back({path + ".on_surface.from", point.from, true});
      asked.push_back({path + ".on_surface.along", point.along});
      break;
  }
  return asked;
}

std::vector<Asking> asked_by(const NamedDirection& direction, std::size_t index) {
  const std::string path = "directions[" + std::to_string(index) + "]";
  switch (direction.kind) {
    case DirectionKind::Between:
      return {{path + ".from", direction.first, true}, {path + ".to", direction.second, true}};
    case DirectionKind::SquareToBoth:
      return {{path + ".square_to_both[0]", direction.first},
              {path + ".square_to_both[1]", direction.second}};
    case DirectionKind::Turned:
      return {{path + ".turn", direction.first}, {path + ".about", direction.second}};
    case DirectionKind::LaidSquare:
      return {{path + ".lay", direction.first}, {path + ".square_to", direction.second}};
  }
  return {};
}

template <typename Entry>
bool has_entry(const std::vector<Entry>& entries, std::string_view name) {
  return std::ranges::any_of(entries, [&](const Entry& entry) { return entry.name == name; });
}

/// Lays one entry after another.
class Orderer {
 public:
  Orderer(const NamedGeometry& geometry, std::string_view file)
      : geometry_(geometry), file_(file) {}

  std::vector<GeometryEntry> ordered() {
    while (takes(geometry_.points, points_, true) ||
           takes(geometry_.directions, directions_, false)) {
    }
    refuse_stuck();
    return std::move(order_);
  }

 private:
  bool is_known(const Asking& asking) const {
    if (asking.wants_point)
      return points_.contains(asking.name) || !has_entry(geometry_.points, asking.name);
    return directions_.contains(asking.name) || is_axis_name(asking.name);
  }

  template <typename Entry>
  bool takes(const std::vector<Entry>& entries, std::set<std::string_view>& taken, bool is_point) {
    const std::size_t next = taken.size();
    if (next == entries.size()) return false;
    for (const Asking& asking : asked_by(entries[next], next)) {
      if (!is_known(asking)) return false;
    }
    taken.insert(entries[next].name);
    order_.push_back({is_point, next});
    return true;
  }

  std::string known_directions() const {
    std::string known;
    for (const std::string_view axis : axes) known.append(known.empty() ? "" : ", ").append(axis);
    for (const NamedDirection& direction : geometry_.directions) known += ", " + direction.name;
    return known;
  }

  /// Where one list waits for an entry of the other, the other is at fault, unless both wait.
  void refuse_stuck() const {
    std::vector<Asking> stuck;
    if (points_.size() < geometry_.points.size())
      stuck.push_back(unknown_of(geometry_.points, points_.size()));
    if (directions_.size() < geometry_.directions.size())
      stuck.push_back(unknown_of(geometry_.directions, directions_.size()));
    if (stuck.empty()) return;
    const bool is_first_waiting = stuck.size() == 2 && !stuck[0].wants_point &&
                                  !stuck[1].wants_point &&
                                  has_entry(geometry_.directions, stuck[0].name);
    refuse_asking(stuck[is_first_waiting ? 1 : 0]);
  }

  /// What an entry waits for.
  template <typename Entry>
  Asking unknown_of(const std::vector<Entry>& entries, std::size_t next) const {
    const std::vector<Asking> asked = asked_by(entries[next], next);
    return *std::ranges::find_if(asked, [&](const Asking& asking) { return !is_known(asking); });
  }

  [[noreturn]] void refuse_asking(const Asking& asking) const {
    const std::string what = "is \"" + asking.name + "\"";
    if (!asking.wants_point && !has_entry(geometry_.directions, asking.name))
      refuse(file_, asking.path, what + ", which is no direction",
             "use one of: " + known_directions());
    refuse(file_, asking.path, what + ", which stands later or is made from this one",
           "name what stands before it, and let none refer back");
  }

  NamedGeometry geometry_;
  std::string_view file_;
  std::set<std::string_view> points_, directions_;
  std::vector<GeometryEntry> order_;
};

}  // namespace

std::span<const std::string_view> axis_names() noexcept { return axes; }

bool is_axis_name(std::string_view name) noexcept {
  return std::ranges::find(axes, name) != axes.end();
}

std::vector<GeometryEntry> geometry_order(const NamedGeometry& geometry, std::string_view file) {
  return Orderer(geometry, file).ordered();
}

}  // namespace hallux::scenarios
