#include "ui/app/window/window_preferences.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "simulator/base/json_depth.h"
#include "ui/jobs/files/output_file.h"
#include "ui/jobs/files/read_small_file.h"

namespace hallux::ui {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* file_name = "window.json";
constexpr const char* mend = "delete it and choose again";
constexpr int depth_max = 4;
constexpr std::size_t device_letters_max = 160;

bool flag(const ordered_json& kept, const char* key, bool usual) {
  const auto found = kept.find(key);
  return found != kept.end() && found->is_boolean() ? found->get<bool>() : usual;
}

/// The id of a device.
std::string device(const ordered_json& kept, const char* key, const std::string& usual) {
  const auto found = kept.find(key);
  if (found == kept.end() || !found->is_string()) return usual;
  std::string id = found->get<std::string>();
  return id.size() <= device_letters_max ? id : usual;
}

/// Ascending, each once; what is no number is left out.
std::vector<std::int64_t> numbers(const ordered_json& kept, const char* key) {
  std::vector<std::int64_t> found;
  const auto list = kept.find(key);
  if (list == kept.end() || !list->is_array()) return found;
  for (const ordered_json& entry : *list)
    if (entry.is_number_integer()) found.push_back(entry.get<std::int64_t>());
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

Preferences read_preferences(const fs::path& data_directory) {
  const fs::path file = data_directory / file_name;
  Preferences preferences;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return preferences;
  const std::string text = read_small_file(file, 1, mend);
  // Values are copied below, which goes as deep as they do.
  const ordered_json kept = json_depth(text) > depth_max
                                ? ordered_json()
                                : ordered_json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!kept.is_object())
    throw FileRefused(file.string() + ": is not what the window keeps there; " + mend);
  if (kept.value("theme", ordered_json()) == "light") preferences.theme = ThemeName::Light;
  const ordered_json scale = kept.value("scale", ordered_json());
  if (scale.is_number())
    preferences.scale = std::clamp(scale.get<float>(), smallest_scale, largest_scale);
  preferences.is_full_screen = flag(kept, "full_screen", preferences.is_full_screen);
  preferences.is_motion_reduced = flag(kept, "reduced_motion", preferences.is_motion_reduced);
  preferences.is_saw_heard = flag(kept, "saw_sound", preferences.is_saw_heard);
  preferences.captures_pointer = flag(kept, "captures_pointer", preferences.captures_pointer);
  preferences.device = device(kept, "device", preferences.device);
  preferences.second_device = device(kept, "second_device", preferences.second_device);
  preferences.offered_flight = numbers(kept, "offered_flight");
  return preferences;
}

void keep_preferences(const fs::path& data_directory, const Preferences& preferences) {
  std::error_code ignored;
  if (!fs::exists(data_directory / "hallux.db", ignored)) return;
  const ordered_json kept{{"theme", preferences.theme == ThemeName::Light ? "light" : "dark"},
                          {"scale", preferences.scale},
                          {"full_screen", preferences.is_full_screen},
                          {"reduced_motion", preferences.is_motion_reduced},
                          {"saw_sound", preferences.is_saw_heard},
                          {"captures_pointer", preferences.captures_pointer},
                          {"device", preferences.device},
                          {"second_device", preferences.second_device},
                          {"offered_flight", preferences.offered_flight}};
  replace_own_file(data_directory / file_name, kept.dump(1) + "\n");
}

PreferenceKeeper::PreferenceKeeper(const Texts& texts, fs::path data_directory, Shell& shell)
    : texts_(texts), data_directory_(std::move(data_directory)), shell_(shell) {
  try {
    wanted_ = written_ = read_preferences(data_directory_);
  } catch (const FileRefused& refused) {
    shell_.say({Meaning::Warn, std::string(texts_.text("preferences.unread")), refused.what()});
  }
  shell_.set_preferences(wanted_);
  shell_.on_preferences([this](const Preferences& chosen) { keep(chosen); });
}

PreferenceKeeper::~PreferenceKeeper() { shell_.on_preferences({}); }

/// One write at a time, the newest last.
void PreferenceKeeper::keep(const Preferences& preferences) {
  wanted_ = preferences;
  if (is_writing_ || wanted_ == written_) return;
  is_writing_ = true;
  shell_.background().start(
      {},
      [directory = data_directory_, chosen = wanted_](WorkReport&) {
        keep_preferences(directory, chosen);
      },
      [this, chosen = wanted_](WorkEnd end, const std::string& reason) {
        is_writing_ = false;
        written_ = chosen;
        if (end == WorkEnd::Failed)
          shell_.say({Meaning::Warn, std::string(texts_.text("preferences.unkept")), reason});
        keep(wanted_);
      });
}

}  // namespace hallux::ui
