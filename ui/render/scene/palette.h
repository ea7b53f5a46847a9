/// The colours of the third dimension; those of the screens stand beside them in one table of
/// tokens.
#pragma once

#include "ui/render/scene/float_vector.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

struct Palette {
  Float3 ground_middle, ground_rim;
  /// By Ink.
  Float3 accent, reference, warn, harm, plain;
};

inline Palette palette_of(Ground ground) noexcept {
  if (ground == Ground::Dark) {
    return {colour_of(0x2B3A44), colour_of(0x0D1318), colour_of(0x2C9BEA), colour_of(0xE763AE),
            colour_of(0xE9A820), colour_of(0xEC6F33), colour_of(0xE9EFF3)};
  }
  return {colour_of(0xF2F6F8), colour_of(0xC3CFD8), colour_of(0x0067A8), colour_of(0xB03C86),
          colour_of(0xC88400), colour_of(0xD55E00), colour_of(0x14202A)};
}

inline Float3 colour_of(const Palette& palette, Ink ink) noexcept {
  switch (ink) {
    case Ink::Accent:
      return palette.accent;
    case Ink::Reference:
      return palette.reference;
    case Ink::Warn:
      return palette.warn;
    case Ink::Harm:
      return palette.harm;
    case Ink::Plain:
      return palette.plain;
  }
  return palette.plain;
}

/// The signed colour map, the same on both grounds.
inline constexpr Float3 map_low = colour_of(0x0072B2), map_middle = colour_of(0xF2F0E8),
                        map_high = colour_of(0xD55E00);

}  // namespace hallux::ui
