/// The files of shaders/, compiled in. Inside this corner only.
#pragma once

#include <span>

#include "simulator/base/embedded.h"

namespace hallux::ui {

std::span<const EmbeddedText> shader_files() noexcept;

}  // namespace hallux::ui
