/// The tray of an operation and what is shifted and fixed with it, in words.
/// Inside this corner only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scenario.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {

/// A name and what is so; the name is borrowed from the texts.
struct Fact {
  std::string_view name;
  std::string words;
};

struct FactBlock {
  /// Of its control.
  std::string id;
  /// Empty where the group's says all.
  std::string title;
  /// "Step 11", which it is about; may be empty.
  std::string step;
  std::vector<Fact> facts;
};

struct FactGroup {
  std::string_view title;
  std::vector<FactBlock> blocks;
};

/// More than one saw is laid out, or something is shifted or fixed.
bool has_tray(const scenarios::Scenario& scenario) noexcept;

/// What lies on the tray; each shift of a fragment; each planned wire and screw with its size, the
/// tools that fit, what it holds and which joint it keeps clear of.
/// needs   has_tray(scenario)
std::vector<FactGroup> tray_facts(const Texts& texts, const scenarios::Scenario& scenario);

}  // namespace hallux::ui
