// What lies behind two constants: from which distance on changes are sent apart, and what blanks
// cost when they are drawn.
#include <epoxy/gl.h>

#include <algorithm>
#include <string>
#include <vector>

#include "simulator/base/random.h"
#include "tests/benchmarks/display_buffers/sections.h"
#include "tests/benchmarks/display_buffers/workloads.h"
#include "tests/benchmarks/report/percentiles.h"
#include "ui/render/gl/display_buffer.h"
#include "ui/render/gl/render_target.h"
#include "ui/render/gl/shader_program.h"
#include "ui/render/painters/bone_view.h"

namespace hallux::benchmarks {

namespace {

using simulator::Triangle;
using ui::DisplayBuffer;

constexpr std::size_t changes = 400;

/// A frame that changes triangles here and there in the first quarter of the buffer.
Table joining_table(const BufferModel& model) {
  Table table{.name = "upload_joining",
              .title = "A frame's " + std::to_string(changes) + " scattered changes of " +
                       std::to_string(model.mesh.triangles.size()) + " triangles, joined over gaps",
              .columns = {"gap up to [bytes]", "processor us a frame", "ranges", "sent kB"},
              .rows = {},
              .notes = {}};
  for (const std::size_t join : {0UL, 64UL, 256UL, 1024UL, 2048UL, 4096UL, 16384UL, 1UL << 30U}) {
    ui::BufferPolicy policy;
    policy.join_bytes = join;
    DisplayBuffer<Triangle> buffer({}, policy);
    buffer.append(model.mesh.triangles);
    buffer.upload();
    glFinish();
    const ui::BufferCounts before = buffer.counts();
    Random random(5);
    std::vector<double> times_us;
    constexpr std::size_t frames = 60;
    for (std::uint32_t frame = 0; frame < frames; ++frame) {
      for (std::uint32_t i = 0; i < changes; ++i) {
        const double at = random.uniform() * 0.25 * static_cast<double>(buffer.size());
        buffer.write(static_cast<std::uint32_t>(at), {frame, i, 7});
      }
      const Stopwatch watch;
      buffer.upload();
      glFinish();
      times_us.push_back(1000.0 * watch.worked_milliseconds());
    }
    const ui::BufferCounts& after = buffer.counts();
    table.rows.push_back(
        {join > 1'000'000 ? Cell{std::string("all")} : Cell{static_cast<double>(join)},
         percentiles_of(times_us).median,
         static_cast<double>(after.uploads - before.uploads) / frames,
         static_cast<double>(after.uploaded_bytes - before.uploaded_bytes) / frames / 1000.0});
  }
  return table;
}

/// Draws the triangles into a small picture, so that what is measured is what each of them costs
/// before any pixel.
double draw_ms(const std::vector<ui::BoneVertex>& points, const std::vector<Triangle>& triangles) {
  DisplayBuffer<ui::BoneVertex> vertices;
  vertices.append(points);
  vertices.upload();
  DisplayBuffer<Triangle> indices;
  indices.append(triangles);
  indices.upload();
  const ui::GlVertexArray array;
  glBindVertexArray(array.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(ui::BoneVertex), nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
  ui::ShaderProgram program("ghost.vert", "ghost.frag");
  const ui::RenderTarget target({64, 64});
  glBindFramebuffer(GL_FRAMEBUFFER, target.target().framebuffer);
  glViewport(0, 0, 64, 64);
  program.use();
  program.set("ink", ui::Float4(1.0F));
  ui::Matrix4 scale(0.02F);
  scale[3][3] = 1.0F;
  program.set("clip_from_ghost", scale);
  std::vector<double> times_ms;
  for (int frame = 0; frame < 25; ++frame) {
    const Stopwatch watch;
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * triangles.size()), GL_UNSIGNED_INT,
                   nullptr);
    glFinish();
    times_ms.push_back(watch.worked_milliseconds());
  }
  return percentiles_of(times_ms).median;
}

/// Half of the triangles removed: as blanks among the others, and taken out.
Table blanks_table(const BufferModel& model) {
  std::vector<ui::BoneVertex> points;
  for (const Vec3& point_mm : model.mesh.points_mm) {
    ui::BoneVertex vertex;
    vertex.point_in_bone_mm = ui::to_float(point_mm);
    points.push_back(vertex);
  }
  std::vector<Triangle> with_blanks = model.mesh.triangles, packed;
  for (std::size_t i = 0; i < with_blanks.size(); ++i) {
    if (i % 2 == 0) {
      with_blanks[i] = {0, 0, 0};
    } else {
      packed.push_back(with_blanks[i]);
    }
  }
  return {
      .name = "drawing_blanks",
      .title = "Drawing " + std::to_string(with_blanks.size()) + " triangles, half of them removed",
      .columns = {"buffer", "processor ms a frame"},
      .rows = {{std::string("whole"), draw_ms(points, model.mesh.triangles)},
               {std::string("half are blanks"), draw_ms(points, with_blanks)},
               {std::string("half, packed"), draw_ms(points, packed)}},
      .notes = {"into 64 x 64 pixels"}};
}

}  // namespace

void measure_uploads(const BufferEffort& effort, BufferResults& results) {
  const BufferModel model = buffer_models(effort.is_quick).front();
  results.tables.push_back(joining_table(model));
  results.tables.push_back(blanks_table(model));
}

}  // namespace hallux::benchmarks
