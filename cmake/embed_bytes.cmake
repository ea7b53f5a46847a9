# Writes OUTPUT: a function NAMESPACE::FUNCTION() returning the bytes of the FILES ('|' between them) as {name, text}. The
# assembler takes them as they are: in a source they would be five times as long and take the compiler a minute.
string(REPLACE "|" ";" files "${FILES}")
set(rows "")
set(symbols "")
set(declared "")
set(count 0)
foreach(file IN LISTS files)
  get_filename_component(name "${file}" NAME)
  set(symbol "hallux_${FUNCTION}_${count}")
  string(APPEND symbols "asm(\".section .rodata\\n.balign 16\\n${symbol}:\\n.incbin \\\"${file}\\\"\\n${symbol}_end:\\n.previous\\n\");\n")
  string(APPEND declared "extern const char ${symbol}[], ${symbol}_end[];\n")
  string(APPEND rows "      {\"${name}\", {${symbol}, static_cast<std::size_t>(${symbol}_end - ${symbol})}},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE "${OUTPUT}.new" "#include \"simulator/base/embedded.h\"\n\n#include <array>\n\n${symbols}
extern \"C\" {\n${declared}}\n\nnamespace ${NAMESPACE} {\n
std::span<const hallux::EmbeddedText> ${FUNCTION}() noexcept {
  static const std::array<hallux::EmbeddedText, ${count}> files{{\n${rows}  }};\n  return files;\n}\n\n}  // namespace ${NAMESPACE}\n")
file(COPY_FILE "${OUTPUT}.new" "${OUTPUT}" ONLY_IF_DIFFERENT)
