/// A vertex and a fragment shader linked into a program.
///
/// Shaders are files in shaders/, compiled into the program. A line `#include "name.glsl"` takes in
/// another of them.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "simulator/base/embedded.h"
#include "ui/render/scene/float_vector.h"

namespace hallux::ui {

class ShaderProgram {
 public:
  /// Of the embedded files. `settings` are lines that are put before both, "#define LINES 2\n": a
  /// program for each case runs faster than one that asks at every pixel.
  /// errors  GraphicsError naming the shader, the line and what the driver says
  ShaderProgram(std::string_view vertex_file, std::string_view fragment_file,
                std::string_view settings = {});
  /// Of other texts; includes are looked for there, too.
  ShaderProgram(std::span<const EmbeddedText> files, std::string_view vertex_file,
                std::string_view fragment_file, std::string_view settings = {});
  ~ShaderProgram();
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&& other) noexcept;

  unsigned name() const noexcept { return name_; }
  /// Makes it the current program.
  void use() const;

  /// Sets a uniform of the current program. Names that the linker dropped are passed over.
  /// needs   use() was called last on this program
  void set(std::string_view uniform, int value);
  void set(std::string_view uniform, float value);
  void set(std::string_view uniform, const Float2& value);
  void set(std::string_view uniform, const Float3& value);
  void set(std::string_view uniform, const Float4& value);
  void set(std::string_view uniform, const Matrix4& value);
  void set(std::string_view uniform, std::span<const Float4> values);

 private:
  int location(std::string_view uniform);

  unsigned name_ = 0;
  std::map<std::string, int, std::less<>> locations_;
};

}  // namespace hallux::ui
