/// How a bone looks, kept in the data directory's cache: each showing of the same bone would
/// compute it again.
#pragma once

#include <filesystem>
#include <string>

#include "simulator/base/progress.h"
#include "ui/render/scene/bone_look.h"

namespace hallux::ui {

/// What is kept of this very bone, else computed now, and kept. Where it cannot be kept it is only
/// slower the next time. The same bone has the same look, with the same id, whoever shows it.
/// errors  whatever `progress` throws
/// thread  any; no graphics
BoneLook cached_look_of(const std::filesystem::path& data_directory, const simulator::Bone& bone,
                        const Progress& progress = {});

/// The name under which it is kept.
std::string cached_look_name(const simulator::Bone& bone);

}  // namespace hallux::ui
