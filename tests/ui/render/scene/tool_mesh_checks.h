/// What holds of every tool's mesh.
#pragma once

#include <cstddef>
#include <string>

#include "ui/render/scene/tool_mesh.h"

namespace hallux::tests {

/// In words, empty where nothing is wrong: each edge joins two triangles, outside is where the
/// triangles run counter-clockwise, normals have length 1 and lean to the side of their triangle,
/// triangles are fewer than `most`.
std::string flaw_of(const ui::ToolMesh& mesh, std::size_t most = 6000);

}  // namespace hallux::tests
