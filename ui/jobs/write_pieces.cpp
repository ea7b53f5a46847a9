#include "ui/jobs/write_pieces.h"

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <vector>

#include "database/store/output_place.h"
#include "simulator/mesh/mesh_error.h"
#include "simulator/mesh/write_ply.h"
#include "ui/jobs/files/output_error.h"
#include "ui/jobs/files/output_file.h"

namespace hallux::ui {

namespace {

namespace fs = std::filesystem;

/// A folder of its own within the output folder, so that no file there is in the way; gone at the
/// end.
class PendingFolder {
 public:
  explicit PendingFolder(const fs::path& folder) {
    std::string name = (folder / ".pieces-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw output_error(folder, errno);
    folder_ = name;
  }
  ~PendingFolder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  PendingFolder(const PendingFolder&) = delete;
  PendingFolder& operator=(const PendingFolder&) = delete;
  const fs::path& path() const noexcept { return folder_; }

 private:
  fs::path folder_;
};

/// N of "piece-N.ply" as this program writes it, else 0.
std::size_t piece_number(const std::string& name) {
  constexpr std::string_view start = "piece-", end = ".ply";
  std::size_t number = 0;
  if (name.size() > start.size() + end.size()) {
    std::from_chars(name.data() + start.size(), name.data() + name.size() - end.size(), number);
  }
  return number > 0 && name == piece_file(number - 1) ? number : 0;
}

/// Pieces of an earlier cut that this one has no pieces for would be taken for its own.
void remove_stale_pieces(const fs::path& folder, std::size_t piece_count) {
  std::vector<fs::path> stale;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const bool is_stale = piece_number(entry.path().filename().string()) > piece_count;
    const bool is_ours = is_stale && entry.is_regular_file();
    if (is_ours && may_be_replaced(entry.path(), piece_mesh)) stale.push_back(entry.path());
  }
  for (const fs::path& file : stale) fs::remove(file);
}

}  // namespace

std::string piece_file(std::size_t index) { return "piece-" + std::to_string(index + 1) + ".ply"; }

void write_pieces(std::span<const simulator::IndexedMesh> meshes, const fs::path& folder,
                  const fs::path& data_directory) {
  database::check_outside(folder, data_directory);
  try {
    fs::create_directories(folder);
    const PendingFolder pending(folder);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      simulator::write_ply(meshes[i], pending.path() / piece_file(i));
    }
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      check_output(folder / piece_file(i), piece_mesh, data_directory);
    }
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      fs::rename(pending.path() / piece_file(i), folder / piece_file(i));
    }
    remove_stale_pieces(folder, meshes.size());
  } catch (const simulator::MeshError& error) {
    throw OutputError(OutputErrorKind::Storage, error.what());
  } catch (const fs::filesystem_error& error) {
    throw output_error(folder, error.code().value());
  }
}

}  // namespace hallux::ui
