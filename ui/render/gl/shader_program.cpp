// Shaders from embedded files. OpenGL knows no include: texts are joined here, with `#line`, so
// that what the driver says still names the file and its line. Places of uniforms are looked up
// once and kept by name; setting one that the driver left out does nothing.
#include "ui/render/gl/shader_program.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "simulator/base/check.h"
#include "ui/render/gl/graphics_error.h"
#include "ui/render/gl/shader_files.h"

namespace hallux::ui {

namespace {

constexpr std::string_view include_begin = "#include \"";

/// A shader's text with its includes in place; `#line` keeps the driver's line numbers true to the
/// files.
class ShaderSource {
 public:
  ShaderSource(std::span<const EmbeddedText> files, std::string_view main,
               std::string_view settings)
      : files_(files) {
    text_ = "#version 330 core\n";
    text_ += settings;
    add_file(main);
  }

  const std::string& text() const noexcept { return text_; }
  /// "bone_skin.frag (in what follows 0 is bone_skin.frag, 1 is light.glsl)".
  std::string legend() const {
    std::string words = names_.front() + " (in what follows";
    for (std::size_t i = 0; i < names_.size(); ++i) {
      words += (i == 0 ? " " : ", ") + std::to_string(i) + " is " + names_[i];
    }
    return words + ")";
  }

 private:
  void add_file(std::string_view name) {
    const auto file =
        std::find_if(files_.begin(), files_.end(), [&](const auto& f) { return f.name == name; });
    if (file == files_.end()) {
      throw GraphicsError("no shader file is called " + std::string(name) +
                          "; it is asked for by " +
                          (names_.empty() ? "the program" : names_.back()));
    }
    const std::size_t number = names_.size();
    names_.emplace_back(name);
    say_line(1, number);
    std::size_t line = 1;
    for (std::string_view rest = file->text; !rest.empty(); ++line) {
      const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
      add_line(rest.substr(0, end), line, number);
      rest.remove_prefix(end);
    }
  }

  void add_line(std::string_view words, std::size_t line, std::size_t number) {
    if (!words.starts_with(include_begin)) {
      text_ += words;
      return;
    }
    const std::string_view name = words.substr(include_begin.size());
    add_file(name.substr(0, name.find('"')));
    say_line(line + 1, number);
  }

  void say_line(std::size_t line, std::size_t number) {
    text_ += "\n#line " + std::to_string(line) + ' ' + std::to_string(number) + '\n';
  }

  std::span<const EmbeddedText> files_;
  std::string text_;
  std::vector<std::string> names_;
};

class Shader {
 public:
  Shader(unsigned kind, const ShaderSource& source) : name_(glCreateShader(kind)) {
    const char* text = source.text().c_str();
    glShaderSource(name_, 1, &text, nullptr);
    glCompileShader(name_);
    GLint is_compiled = 0;
    glGetShaderiv(name_, GL_COMPILE_STATUS, &is_compiled);
    if (is_compiled != 0) return;
    std::array<char, 2000> log{};
    glGetShaderInfoLog(name_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteShader(name_);
    throw GraphicsError("the graphics driver refuses the shader " + source.legend() + ": " +
                        log.data());
  }
  ~Shader() { glDeleteShader(name_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  unsigned name() const noexcept { return name_; }

 private:
  unsigned name_;
};

unsigned link(const Shader& vertex, const Shader& fragment, const std::string& what) {
  const unsigned program = glCreateProgram();
  glAttachShader(program, vertex.name());
  glAttachShader(program, fragment.name());
  glLinkProgram(program);
  glDetachShader(program, vertex.name());
  glDetachShader(program, fragment.name());
  GLint is_linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if (is_linked != 0) return program;
  std::array<char, 2000> log{};
  glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glDeleteProgram(program);
  throw GraphicsError("the graphics driver does not link the shaders " + what + ": " + log.data());
}

}  // namespace

ShaderProgram::ShaderProgram(std::string_view vertex_file, std::string_view fragment_file,
                             std::string_view settings)
    : ShaderProgram(shader_files(), vertex_file, fragment_file, settings) {}

ShaderProgram::ShaderProgram(std::span<const EmbeddedText> files, std::string_view vertex_file,
                             std::string_view fragment_file, std::string_view settings) {
  const Shader vertex(GL_VERTEX_SHADER, ShaderSource(files, vertex_file, settings));
  const Shader fragment(GL_FRAGMENT_SHADER, ShaderSource(files, fragment_file, settings));
  name_ = link(vertex, fragment, std::string(vertex_file) + " and " + std::string(fragment_file));
}

ShaderProgram::~ShaderProgram() {
  if (name_ != 0) glDeleteProgram(name_);
}

ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept
    : name_(std::exchange(other.name_, 0)), locations_(std::move(other.locations_)) {}

ShaderProgram& ShaderProgram::operator=(ShaderProgram&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(locations_, other.locations_);
  return *this;
}

void ShaderProgram::use() const { glUseProgram(name_); }

int ShaderProgram::location(std::string_view uniform) {
  const auto found = locations_.find(uniform);
  if (found != locations_.end()) return found->second;
  const std::string name(uniform);
  return locations_.emplace(name, glGetUniformLocation(name_, name.c_str())).first->second;
}

void ShaderProgram::set(std::string_view uniform, int value) {
  glUniform1i(location(uniform), value);
}

void ShaderProgram::set(std::string_view uniform, float value) {
  glUniform1f(location(uniform), value);
}

void ShaderProgram::set(std::string_view uniform, const Float2& value) {
  glUniform2f(location(uniform), value.x, value.y);
}

void ShaderProgram::set(std::string_view uniform, const Float3& value) {
  glUniform3f(location(uniform), value.x, value.y, value.z);
}

void ShaderProgram::set(std::string_view uniform, const Float4& value) {
  glUniform4f(location(uniform), value.x, value.y, value.z, value.w);
}

void ShaderProgram::set(std::string_view uniform, const Matrix4& value) {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, &value[0][0]);
}

void ShaderProgram::set(std::string_view uniform, std::span<const Float4> values) {
  if (values.empty()) return;
  glUniform4fv(location(uniform), static_cast<GLsizei>(values.size()), &values[0].x);
}

}  // namespace hallux::ui
