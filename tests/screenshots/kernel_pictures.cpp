#include "tests/screenshots/kernel_pictures.h"

namespace hallux::tests {

std::vector<Picture> kernel_pictures() {
  return {{"kerf_frame", draw_kerf_frame()},
          {"field", draw_field()},
          {"contact", draw_contact()},
          {"frames", draw_frames()},
          {"five_faces", draw_five_faces()},
          {"earlier_kerfs", draw_earlier_kerfs()},
          {"hinge", draw_hinge()}};
}

}  // namespace hallux::tests
