// A corner of the field: nodes, the blade at two poses and the hull of both, crossings and the
// straightened outline.
#include "simulator/cutting/field/outline_tile.h"
#include "tests/screenshots/kernel_pictures.h"
#include "tests/screenshots/plane_view.h"

namespace hallux::tests {

using namespace simulator;

namespace {

const Blade blade{10.0, 20.0, 0.5};

struct StampedCorner {
  PlanarPose from{Vec2(0.0, 0.0), Vec2(1.0, 0.0)};
  PlanarPose to{Vec2(0.27, -0.11), Vec2(0.9992009587217894, -0.03996803834887158)};  // slope 1 / 25
  KerfField field{FieldGrid{Vec2(-0.42, 4.43), 0.05, 25, 17}};

  StampedCorner() {
    FieldWindow changed;
    field.stamp(blade, from, to, changed);
  }
};

void draw_grid(SvgPage& page, const PlaneView& view, const KerfField& field) {
  const FieldGrid& grid = field.grid();
  const auto node = [&](std::int32_t u, std::int32_t v) {
    return view.page(grid.origin_mm + grid.spacing_mm * Vec2(u, v));
  };
  for (std::int32_t u = 0; u < grid.u_count; ++u) {
    page.line(node(u, 0), node(u, grid.v_count - 1), "grid");
  }
  for (std::int32_t v = 0; v < grid.v_count; ++v) {
    page.line(node(0, v), node(grid.u_count - 1, v), "grid");
  }
}

void draw_nodes(SvgPage& page, const PlaneView& view, const KerfField& field) {
  const FieldGrid& grid = field.grid();
  const auto limit_mm = static_cast<float>(grid.spacing_mm);
  for (std::int32_t u = 0; u < grid.u_count; ++u) {
    for (std::int32_t v = 0; v < grid.v_count; ++v) {
      const float inside_mm = field.at(u, v);
      const char* css_class = inside_mm >= limit_mm ? "deepnode"
                              : inside_mm > 0.0F    ? "opennode"
                                                    : "node";
      page.dot(view.page(grid.origin_mm + grid.spacing_mm * Vec2(u, v)), 3.4, css_class);
    }
  }
}

/// What of the outline the grid's border cuts off is left out: there the field ends, not the blade.
bool is_within(const FieldGrid& grid, const Vec2& place_mm) {
  const Vec2 low = grid.origin_mm;
  const Vec2 high = low + grid.spacing_mm * Vec2(grid.u_count - 1, grid.v_count - 1);
  return place_mm.x > low.x && place_mm.y > low.y && place_mm.x < high.x && place_mm.y < high.y;
}

void draw_outline(SvgPage& page, const PlaneView& view, const KerfField& field) {
  const RegionOutline outline = outline_of(field);
  const std::size_t count = outline.corners_mm.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2& from = outline.corners_mm[i];
    const Vec2& to = outline.corners_mm[(i + 1) % count];
    const bool is_rim = !is_within(field.grid(), from) && !is_within(field.grid(), to);
    if (!is_rim) page.line(view.page(from), view.page(to), "cut");
  }
  OutlineTile tile;
  tile.contour(field, 0, 0);
  for (const Crossing& crossing : tile.crossings()) {
    if (is_within(field.grid(), crossing.at_mm)) {
      page.dot(view.page(crossing.at_mm), 2.4, "crossing");
    }
  }
  for (const Vec2& corner : outline.corners_mm) {
    if (is_within(field.grid(), corner)) page.dot(view.page(corner), 4.2, "corner");
  }
}

void draw_blades(SvgPage& page, const PlaneView& view, const StampedCorner& stamped) {
  const std::vector<Vec2> first = blade_corners_mm(blade, stamped.from);
  const std::vector<Vec2> second = blade_corners_mm(blade, stamped.to);
  std::vector<Vec2> both = first;
  both.insert(both.end(), second.begin(), second.end());
  page.polygon(view.pages(hull_of(both)), "hull");
  page.polygon(view.pages(first), "plan");
  page.polygon(view.pages(second), "axisline");
}

void draw_whole(SvgPage& page, const StampedCorner& stamped) {
  const PlaneView view{Vec2(-9.7, 0.0), Vec2(757.0, 122.0), 8.6};
  draw_blades(page, view, stamped);
  const FieldGrid& grid = stamped.field.grid();
  const Vec2 low = grid.origin_mm;
  const Vec2 high = low + grid.spacing_mm * Vec2(grid.u_count - 1, grid.v_count - 1);
  page.polygon(view.pages({low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)}), "wall");
  page.text(Vec2(757.0, 190.0), "the whole blade; this corner", "small", "middle");
  page.text(Vec2(757.0, 205.0), "is what is drawn large", "small", "middle");
}

void draw_keys(SvgPage& page) {
  const auto row = [&](double y, std::string_view words) {
    page.text(Vec2(682.0, y + 4.5), words);
  };
  page.dot(Vec2(664.0, 240.0), 3.4, "node");
  row(240.0, "closed node");
  page.dot(Vec2(664.0, 264.0), 3.4, "opennode");
  row(264.0, "open node");
  page.dot(Vec2(664.0, 288.0), 3.4, "deepnode");
  row(288.0, "open, and can rise no more");
  page.line(Vec2(652.0, 312.0), Vec2(676.0, 312.0), "plan");
  row(312.0, "  blade, first pose");
  page.line(Vec2(652.0, 336.0), Vec2(676.0, 336.0), "axisline");
  row(336.0, "  blade, second pose");
  page.key(Vec2(658.0, 354.0), "hullkey", "");
  row(360.0, "hull of both");
  page.dot(Vec2(664.0, 384.0), 2.4, "crossing");
  row(384.0, "crossing of a grid edge");
  page.line(Vec2(652.0, 408.0), Vec2(676.0, 408.0), "cut");
  page.dot(Vec2(664.0, 408.0), 4.2, "corner");
  row(408.0, "  outline, straightened");
}

}  // namespace

std::string draw_field() {
  const StampedCorner stamped;
  SvgPage page(Vec2(880.0, 440.0), "A corner of the field after one stamp");
  page.add_style("axisline", "fill:none;stroke:#2b2b2b;stroke-width:1.2");
  page.add_style("hullkey", "fill:#d55e00;fill-opacity:.12;stroke:#d9a37c;stroke-width:.6");
  const FieldGrid& grid = stamped.field.grid();
  const Vec2 size_mm = grid.spacing_mm * Vec2(grid.u_count - 1, grid.v_count - 1);
  const PlaneView view{grid.origin_mm + 0.5 * size_mm, Vec2(328.0, 220.0), 500.0};
  const Vec2 low(18.0, 10.0), size(620.0, 420.0);
  page.begin_window(low, size);
  draw_grid(page, view, stamped.field);
  draw_blades(page, view, stamped);
  draw_nodes(page, view, stamped.field);
  draw_outline(page, view, stamped.field);
  page.end_window();
  draw_whole(page, stamped);
  draw_keys(page);
  return page.take();
}

}  // namespace hallux::tests
