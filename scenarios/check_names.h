/// Words and small checks with which the parts of a scenario are held against each other. Inside
/// this room only.
/// Inside this corner only.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/json_node.h"

namespace hallux::scenarios {

/// "cuts[1].name".
inline std::string path_of(std::string_view list, std::size_t index, std::string_view key) {
  return std::string(list) + "[" + std::to_string(index) + "]." + std::string(key);
}

inline std::string is_text(std::string_view text) { return "is \"" + std::string(text) + "\""; }

/// errors  ScenarioError where two parts have the same name
template <typename Part>
void check_names(const std::vector<Part>& parts, std::string Part::*name, std::string_view list,
                 std::string_view key, std::string_view file) {
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (seen.insert(parts[i].*name).second) continue;
    refuse(file, path_of(list, i, key), is_text(parts[i].*name) + ", which is already taken",
           "give each its own");
  }
}

template <typename Part>
bool has_name(const std::vector<Part>& parts, std::string_view name) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const Part& part) { return part.name == name; });
}

/// errors  ScenarioError where no part has the name, with those that are there
template <typename Part>
void check_named(const std::vector<Part>& parts, std::string_view named, std::string_view what,
                 const std::string& path, std::string_view file) {
  if (has_name(parts, named)) return;
  std::string mend = "name one of the " + std::string(what) + "s:";
  for (const Part& known : parts) mend += " " + known.name;
  refuse(file, path,
         named.empty() ? "is missing" : is_text(named) + ", which is no " + std::string(what),
         mend);
}

/// errors  ScenarioError where something is named
inline void refuse_named(std::string_view named, std::string_view what, const std::string& path,
                         std::string_view file) {
  if (named.empty()) return;
  refuse(file, path, is_text(named), "remove it: this is not about one " + std::string(what));
}

}  // namespace hallux::scenarios
