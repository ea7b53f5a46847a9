// Section, polar about its centre, angle phi from z towards y less the twist:
//   rho(phi) = (|cos phi / (a (1 + e sin phi))|^n + |sin phi / b|^n)^(-1/n)
//              (1 + c3 cos 3 phi + s3 sin 3 phi)
// Side A = (u - 1) / |grad u| with u = r / rho.
// Cap B = the quadric's height, x never past either end.
// Join: ((A+R)^p + (B+R)^p)^(1/p) - R where both terms are positive, else the greater of A and B.
// Source: docs/foot.md, sections "The field" and "Why planes across the chord".
#include "scenarios/foot/bone_loft.h"

namespace hallux::scenarios {
namespace {

/// How softly a cap is kept from passing the ends of the bone.
constexpr double end_blend_mm = 2.0;
/// Over which length past the first and the last station the sections come to rest.
constexpr double fade_out_mm = 1.5;

/// (u - 1) / |grad u|: the gradient's own slope is left out, which is exact on the surface.
Dual normalised_gauge(const Dual& u) {
  const double steepness = length_of(u.slope);
  return {(u.value - 1.0) / steepness, u.slope / steepness};
}

/// x of the cap's surface over (y, z).
Dual cap_height(const EndCap& cap, const Vec3& point_mm) {
  const double y = point_mm.y - cap.y_mm;
  const double z = point_mm.z - cap.z_mm;
  const double q = cap.tilt_y * y + cap.tilt_z * z + cap.curve_yy_per_mm * y * y +
                   cap.curve_zz_per_mm * z * z + cap.curve_yz_per_mm * y * z;
  return {cap.x_mm + q,
          {0.0, cap.tilt_y + 2.0 * cap.curve_yy_per_mm * y + cap.curve_yz_per_mm * z,
           cap.tilt_z + 2.0 * cap.curve_zz_per_mm * z + cap.curve_yz_per_mm * y}};
}

/// Distance beyond the cap along +x or -x, not past `end_x_mm`. The steepness is the quadric's own,
/// also where the end limits it: so the rim stays round where the cap runs off to the side.
Dual beyond(const EndCap& cap, double end_x_mm, double direction, const Vec3& point_mm) {
  const Dual quadric = cap_height(cap, point_mm);
  const Dual limited = smooth_min(quadric * direction, Dual{end_x_mm * direction}, end_blend_mm);
  const double steepness = std::sqrt(1.0 + squared_length(quadric.slope));
  return {(point_mm.x * direction - limited.value) / steepness,
          (Vec3{direction, 0.0, 0.0} - limited.slope) / steepness};
}

Dual join(const Dual& side, const Dual& cap, const EndCap& shape) {
  const double radius = shape.rim_radius_mm;
  const Dual a = side + radius;
  const Dual b = cap + radius;
  if (!(a.value > 0.0) || !(b.value > 0.0)) return max(side, cap);
  const Dual p{shape.rim_exponent};
  const Dual inverse_p{1.0 / shape.rim_exponent};
  // Scaled by the greater term, so that far away nothing overflows.
  const double scale = std::max(a.value, b.value);
  const Dual sum = pow(a * (1.0 / scale), p) + pow(b * (1.0 / scale), p);
  return pow(sum, inverse_p) * scale - radius;
}

Dual abs(const Dual& a) { return a.value < 0.0 ? -a : a; }

/// r / rho for the point `across`, `up` of the twisted section.
Dual gauge(const Dual& across, const Dual& up, const std::array<Dual, 9>& section) {
  const Dual& n = section[4];
  const Dual radius = sqrt(across * across + up * up + 1e-12);
  const Dual c = across / radius;
  const Dual s = up / radius;
  const Dual width = section[2] * (section[8] * s + 1.0);
  const Dual sum = pow(abs(across / width), n) + pow(abs(up / section[3]), n);
  const Dual cos3 = c * (c * c * 4.0 - 3.0);
  const Dual sin3 = s * (-(s * s * 4.0) + 3.0);
  const Dual harmonic = section[6] * cos3 + section[7] * sin3 + 1.0;
  return pow(sum, Dual{1.0} / n) / harmonic;
}

}  // namespace

BoneLoft::BoneLoft(const BoneTable& table)
    : length_mm_(table.length_mm), base_(table.base), head_(table.head) {
  for (const Station& s : table.stations) {
    Knot knot;
    knot.x_mm = s.position * table.length_mm;
    knot.value = {s.centre_y_mm, s.centre_z_mm, s.half_width_mm, s.half_height_mm, s.exponent,
                  s.twist_rad,   s.cos3,        s.sin3,          s.dorsal_widening};
    knots_.push_back(knot);
  }
  for (std::size_t c = 0; c < channel_count; ++c) set_slopes(c);
}

void BoneLoft::set_slopes(std::size_t channel) {
  const std::size_t last = knots_.size() - 1;
  const auto width = [this](std::size_t i) { return knots_[i + 1].x_mm - knots_[i].x_mm; };
  const auto secant = [this, channel, width](std::size_t i) {
    return (knots_[i + 1].value[channel] - knots_[i].value[channel]) / width(i);
  };
  knots_[0].slope_per_mm[channel] = secant(0);
  knots_[last].slope_per_mm[channel] = secant(last - 1);
  for (std::size_t i = 1; i < last; ++i) {
    // The slope of the parabola through three knots.
    const double before = width(i - 1);
    const double after = width(i);
    knots_[i].slope_per_mm[channel] =
        (secant(i - 1) * after + secant(i) * before) / (before + after);
  }
}

std::array<Dual, BoneLoft::channel_count> BoneLoft::section_past(const Knot& end,
                                                                 double x_mm) const noexcept {
  // The slope fades as (1 - t)^2. Cut off at once, it would leave a step in the rim, because the
  // side's distance is divided by its gradient.
  const double t = std::min(std::abs(x_mm - end.x_mm) / fade_out_mm, 1.0);
  const double left = (1.0 - t) * (1.0 - t);
  const double run_mm =
      (x_mm < end.x_mm ? -1.0 : 1.0) * fade_out_mm * (1.0 - left * (1.0 - t)) / 3.0;
  std::array<Dual, channel_count> section;
  for (std::size_t c = 0; c < channel_count; ++c) {
    const double slope = end.slope_per_mm[c];
    section[c] = {end.value[c] + slope * run_mm, {slope * left, 0.0, 0.0}};
  }
  return section;
}

std::array<Dual, BoneLoft::channel_count> BoneLoft::section_at(double x_mm) const noexcept {
  std::array<Dual, channel_count> section;
  if (x_mm <= knots_.front().x_mm) return section_past(knots_.front(), x_mm);
  if (x_mm >= knots_.back().x_mm) return section_past(knots_.back(), x_mm);
  std::size_t i = 0;
  while (knots_[i + 1].x_mm < x_mm) ++i;
  const Knot& from = knots_[i];
  const Knot& to = knots_[i + 1];
  const double h = to.x_mm - from.x_mm;
  const double t = (x_mm - from.x_mm) / h;
  for (std::size_t c = 0; c < channel_count; ++c) {
    // Cubic Hermite as a polynomial in t.
    const double d0 = from.slope_per_mm[c] * h;
    const double d1 = to.slope_per_mm[c] * h;
    const double rise = to.value[c] - from.value[c];
    const double c2 = 3.0 * rise - 2.0 * d0 - d1;
    const double c3 = d0 + d1 - 2.0 * rise;
    section[c] = {from.value[c] + t * (d0 + t * (c2 + t * c3)),
                  {(d0 + t * (2.0 * c2 + t * 3.0 * c3)) / h, 0.0, 0.0}};
  }
  return section;
}

LoftDistances BoneLoft::parts_at(const Vec3& point_mm) const noexcept {
  const auto section = section_at(point_mm.x);
  const Dual y = Dual{point_mm.y, {0.0, 1.0, 0.0}} - section[0];
  const Dual z = Dual{point_mm.z, {0.0, 0.0, 1.0}} - section[1];
  const double sin_twist = elementary::sin(section[5].value);
  const double cos_twist = elementary::cos(section[5].value);
  const Dual sine{sin_twist, section[5].slope * cos_twist};
  const Dual cosine{cos_twist, section[5].slope * -sin_twist};
  const Dual across = z * cosine + y * sine;
  const Dual up = y * cosine - z * sine;

  return {normalised_gauge(gauge(across, up, section)), beyond(base_, 0.0, -1.0, point_mm),
          beyond(head_, length_mm_, 1.0, point_mm)};
}

Dual BoneLoft::joined(const LoftDistances& parts) const noexcept {
  return join(join(parts.side, parts.base, base_), parts.head, head_);
}

}  // namespace hallux::scenarios
