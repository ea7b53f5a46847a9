// The mean is kept with 16 bits a colour: with 8 the rounding of 16 samples would be seen as bands.
// It is a running one, n-th sample over the mean of those before as its n-th part, so that what is
// shown has the brightness of one picture from the first on.
//
// The places are a search over groups of three at 120 degrees, the best for edges of every
// direction: of half planes that cross a pixel they have the coverage to 0.029 (root mean square),
// as a grid of 4 x 4 has, but edges along rows and columns have 16 steps instead of four.
#include "ui/render/refined_picture.h"

#include <epoxy/gl.h>

#include <array>

#include "simulator/base/check.h"
#include "ui/render/gl/headless_context.h"

namespace hallux::ui {

namespace {

constexpr std::array<std::array<double, 2>, samples_at_rest> places{{{0.0, 0.0},
                                                                     {0.463, 0.008},
                                                                     {-0.238, 0.397},
                                                                     {-0.225, -0.405},
                                                                     {-0.284, 0.076},
                                                                     {0.076, -0.284},
                                                                     {0.208, 0.208},
                                                                     {-0.461, -0.198},
                                                                     {0.402, -0.301},
                                                                     {0.059, 0.499},
                                                                     {0.052, -0.487},
                                                                     {0.396, 0.289},
                                                                     {-0.448, 0.198},
                                                                     {-0.052, 0.230},
                                                                     {-0.173, -0.160},
                                                                     {0.225, -0.070}}};

/// A third of a second of frames in which nothing changes: a sample takes a processor twice as long
/// as a frame in motion, and who moves the saw on is not to wait for one.
constexpr int waits_of_processor = 20;

}  // namespace

Vec2 sample_place(int number) noexcept {
  CHECK(number >= 0 && number < samples_at_rest);
  const auto& place = places[static_cast<std::size_t>(number)];
  return Vec2(place[0], place[1]);
}

RestPlan live_rest(const RenderQuality& quality) {
  const int of_one_picture = quality.supersampling * quality.supersampling;
  return {samples_at_rest / of_one_picture, is_software_renderer() ? waits_of_processor : 0};
}

SampleMixer::SampleMixer() : copy_("ground.vert", "copy.frag") {}

void SampleMixer::mix(unsigned texture, const DrawTarget& target, double share) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glViewport(target.left, target.bottom, target.size.width, target.size.height);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendColor(0.0F, 0.0F, 0.0F, static_cast<float>(share));
  glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  copy_.use();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture);
  copy_.set("picture_colours", 0);
  copy_.set("into_place", Float2(target.left, target.bottom));
  glBindVertexArray(no_attributes_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glUseProgram(0);
  glDisable(GL_BLEND);
}

RefinedPicture::Mean::Mean(PixelSize of) : size(of) {
  forget_graphics_errors();
  glBindTexture(GL_TEXTURE_2D, colour.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_SHORT,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const BoundFramebuffer bound(framebuffer.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour.name(), 0);
  check_framebuffer(size);
}

void RefinedPicture::begin(SampleMixer& mixer, const RenderTarget& sample) {
  if (!mean_ || mean_->size != sample.size()) {
    mean_.reset();
    mean_.emplace(sample.size());
  }
  mean_->samples = 0;
  add(mixer, sample);
}

void RefinedPicture::add(SampleMixer& mixer, const RenderTarget& sample) {
  CHECK(mean_ && mean_->size == sample.size());
  ++mean_->samples;
  mixer.mix(sample.texture(), mean_->target(), 1.0 / mean_->samples);
}

void RefinedPicture::show(const DrawTarget& target) const {
  CHECK(mean_.has_value());
  copy_picture(mean_->target(), target);
}

}  // namespace hallux::ui
