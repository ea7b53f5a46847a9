#include "tests/database/some_exchange.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream content;
  content << in.rdbuf();
  return content.str();
}

void write_over(const fs::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
}

}  // namespace

std::vector<DerivedFile> some_derived(const ExportMaterial& material) {
  return {
      {"bone.ply", "made of " + std::to_string(material.bone.size()) + " bytes\n"},
      {"piece-1.ply", "made of " + std::to_string(material.recording.samples.size()) + " rows\n"}};
}

std::map<std::string, std::string> bytes_below(const fs::path& folder) {
  std::map<std::string, std::string> bytes;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) {
      bytes[fs::relative(entry.path(), folder).string()] = content_of(entry.path());
    }
  }
  return bytes;
}

void alter_alone(const fs::path& file, const std::string& old_text, const std::string& new_text) {
  std::string content = content_of(file);
  const std::size_t at = content.find(old_text);
  if (at == std::string::npos) throw std::runtime_error{old_text + " is not in " + file.string()};
  write_over(file, content.replace(at, old_text.size(), new_text));
}

void alter(const fs::path& folder, const std::string& name, const std::string& old_text,
           const std::string& new_text) {
  alter_alone(folder / name, old_text, new_text);
  const std::string content = content_of(folder / name);
  auto manifest = nlohmann::ordered_json::parse(content_of(folder / manifest_name));
  for (auto& file : manifest["files"]) {
    if (file["name"] != name) continue;
    file["bytes"] = content.size();
    file["blake2b_256"] =
        hex_from_digest(digest_of(std::as_bytes(std::span{content.data(), content.size()})));
  }
  write_over(folder / manifest_name, manifest.dump(1) + "\n");
}

TwoDirectories::TwoDirectories() : there_(Database::open(temporary_.data())) {
  OpenHouse::enter(there_)->add_first_administrator({"chief", "", true}, secret(good_password),
                                                    cheap);
}

AdministratorDesk TwoDirectories::administrator_there() {
  return *sign_in(there_, "chief", secret(good_password), cheap).administrator();
}

fs::path TwoDirectories::exported(const AttemptId& id) {
  export_attempt(course_.database(), id, out(), some_derived);
  return out() / id.text;
}

bool TwoDirectories::import(const fs::path& folder) {
  const ImportedAttempt attempt = read_exported(folder);
  std::optional<ScoreCard> rescored;
  if (attempt.manifest.header.seal) rescored = card_worth(12'345);
  return administrator_there().import_attempt(attempt, rescored);
}

}  // namespace hallux::database
