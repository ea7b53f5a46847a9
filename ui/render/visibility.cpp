// The id picture is what the renderer draws first anyway: the shapes of bones with their depth, and
// in the stencil which bone is where; blade and handpiece are added with ids of their own, tips and
// handles of other tools with the same. A sample is held against the depth at its pixel, with some
// room: a kerf's rim lies on the bone that could hide it, and a tooth in the blade.
#include "ui/render/visibility.h"

#include <epoxy/gl.h>

#include <cmath>
#include <cstdint>
#include <optional>

#include "ui/render/painters/bone_painter.h"
#include "ui/render/painters/hand_tool_painter.h"
#include "ui/render/painters/saw_painter.h"

namespace hallux::ui {

namespace {

/// Ids in the stencil above those of bones.
constexpr unsigned handpiece_id = 254, blade_id = 255;
/// What lies nearer to the eye by less hides nothing.
constexpr double room_mm = 0.8;

/// Depth and id of each pixel, rows from below.
struct IdPicture {
  PixelSize size;
  std::vector<std::uint32_t> depth_and_id;

  double depth(std::size_t pixel) const noexcept {
    return static_cast<double>(depth_and_id[pixel] >> 8U) / 16777215.0;
  }
  unsigned id(std::size_t pixel) const noexcept { return depth_and_id[pixel] & 0xffU; }
};

/// Nothing: seen. Else the id of what hides the place; 0: the picture's edge.
std::optional<unsigned> hider_of(const IdPicture& picture, const EyeView& view,
                                 const Vec3& place_mm) {
  const Vec3 place = place_in_picture(view, place_mm);
  const int x = static_cast<int>(std::floor(place.x * picture.size.width));
  const int y = static_cast<int>(std::floor((1.0 - place.y) * picture.size.height));
  if (!(std::abs(place.z) < 1.0) || x < 0 || y < 0 || x >= picture.size.width ||
      y >= picture.size.height)
    return 0;
  const std::size_t pixel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
      static_cast<std::size_t>(x);
  if (picture.id(pixel) == 0) return std::nullopt;
  const Vec3 before_mm = point_at(view, Vec3(place.x, place.y, 2.0 * picture.depth(pixel) - 1.0));
  const double nearer_mm =
      glm::length(place_mm - view.eye_in_world_mm) - glm::length(before_mm - view.eye_in_world_mm);
  return nearer_mm <= room_mm ? std::nullopt : std::optional(picture.id(pixel));
}

}  // namespace

struct SightMeter::Parts {
  PictureBuffers buffers;
  NoiseTextures noise;
  BonePainter bones{noise};
  PartPainter parts{noise};
  SawPainter saw{noise, parts};
  HandToolPainter hand_tools{parts};
  std::uint64_t picture = 0;
  Hiders hiders;

  explicit Parts(PixelSize size) : buffers(size) {}

  IdPicture draw(const Frame& frame);
  void draw_tools(const Frame& frame);
  void count(unsigned hider);
  double seen_share(const IdPicture& ids, const EyeView& view,
                    const std::vector<SightPlace>& places);
};

IdPicture SightMeter::Parts::draw(const Frame& frame) {
  bones.show(frame.scene, ++picture);
  begin_drawing(frame.target.size);
  glBindFramebuffer(GL_FRAMEBUFFER, buffers.shapes());
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  bones.draw_shapes(frame, all_of(frame.target.size));
  glBindFramebuffer(GL_FRAMEBUFFER, buffers.still().framebuffer);
  draw_tools(frame);
  IdPicture ids{frame.target.size, {}};
  ids.depth_and_id.resize(pixel_count(all_of(ids.size)));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, ids.size.width, ids.size.height, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
               ids.depth_and_id.data());
  end_drawing();
  bones.forget_before(picture);
  return ids;
}

void SightMeter::Parts::draw_tools(const Frame& frame) {
  glEnable(GL_STENCIL_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glStencilFunc(GL_ALWAYS, handpiece_id, 0xff);
  if (frame.scene.saw) saw.draw_handpiece(frame, HandlePart::MostlyThere);
  hand_tools.draw_handles(frame, HandlePart::MostlyThere);
  glStencilFunc(GL_ALWAYS, blade_id, 0xff);
  if (frame.scene.saw) saw.draw_blade(frame);
  hand_tools.draw_tips(frame, HandlePart::MostlyThere);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glDisable(GL_STENCIL_TEST);
}

void SightMeter::Parts::count(unsigned hider) {
  if (hider == 0) ++hiders.outside_picture;
  if (hider == blade_id) ++hiders.blade;
  if (hider == handpiece_id) ++hiders.handpiece;
  if (hider > 0 && hider < handpiece_id) ++hiders.bone;
}

double SightMeter::Parts::seen_share(const IdPicture& ids, const EyeView& view,
                                     const std::vector<SightPlace>& places) {
  if (places.empty()) return 1.0;
  std::size_t seen = 0;
  for (const SightPlace& place : places) {
    const auto first = hider_of(ids, view, place[0]), second = hider_of(ids, view, place[1]);
    if (!first || !second) {
      ++seen;
      continue;
    }
    const bool is_first_nearer =
        glm::length(place[0] - view.eye_in_world_mm) < glm::length(place[1] - view.eye_in_world_mm);
    count(is_first_nearer ? *first : *second);
  }
  return static_cast<double>(seen) / static_cast<double>(places.size());
}

SightMeter::SightMeter(PixelSize size) : parts_(std::make_unique<Parts>(at_least_one(size))) {}
SightMeter::~SightMeter() = default;

const Hiders& SightMeter::hiders() const noexcept { return parts_->hiders; }
PixelSize SightMeter::size() const noexcept { return parts_->buffers.size(); }

Visibility SightMeter::measure(const Scene& scene, const EyeView& view,
                               const SightSamples& samples) {
  const IdPicture ids = parts_->draw(frame_of(scene, view, parts_->buffers, 1.0));
  parts_->hiders = {};
  return {parts_->seen_share(ids, view, samples.teeth_mm),
          parts_->seen_share(ids, view, samples.kerf_mm)};
}

}  // namespace hallux::ui
