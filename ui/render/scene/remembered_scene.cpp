#include "ui/render/scene/remembered_scene.h"

namespace hallux::ui {

RememberedScene::RememberedScene(const Scene& scene) : scene_(scene) {
  for (const BoneInScene& bone : scene.bones) {
    ids_.push_back(bone.mesh->id);
    ids_.push_back(bone.look->id);
  }
  for (const FreePiece& piece : scene.free_pieces) ids_.push_back(piece.mesh->id);
}

}  // namespace hallux::ui
