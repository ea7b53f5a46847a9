/// The pictures of docs/cutting.md, each computed by the kernel on a generated bone; the same bytes
/// each time.
#pragma once

#include <string>
#include <vector>

namespace hallux::tests {

struct Picture {
  /// Of the file, without folder and ending.
  std::string name;
  std::string svg;
};

std::string draw_kerf_frame();
std::string draw_field();
std::string draw_contact();
std::string draw_frames();
std::string draw_five_faces();
std::string draw_earlier_kerfs();
std::string draw_hinge();

/// All of them, in the order of the text.
std::vector<Picture> kernel_pictures();

}  // namespace hallux::tests
