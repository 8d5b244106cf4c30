#include "render/embedded.h"

#include <cstddef>
#include <stdexcept>
#include <string>

// The assembler puts each file into a section of its own, as records of name, length and bytes.
// Records are one after another, each padded to eight bytes; the linker names the section's ends.
#define SECTILE_EMBED(name, path)           \
  __asm__(                                  \
      ".pushsection sectile_files, \"a\"\n" \
      ".balign 8\n"                         \
      ".quad 2f - 1f, 3f - 2f\n"            \
      "1: .ascii \"" name                   \
      "\"\n"                                \
      "2: .incbin \"" path                  \
      "\"\n"                                \
      "3: .balign 8\n"                      \
      ".popsection\n");
#include "embedded_files.inc"

extern "C" const char __start_sectile_files[];
extern "C" const char __stop_sectile_files[];

namespace sectile::viewer {

std::string_view embedded_file(std::string_view name) {
  struct Lengths {
    std::size_t name, bytes;
  };
  for (const char* record = __start_sectile_files; record < __stop_sectile_files;) {
    const auto& lengths = *reinterpret_cast<const Lengths*>(record);
    const char* text = record + sizeof(Lengths);
    if (std::string_view(text, lengths.name) == name) return {text + lengths.name, lengths.bytes};
    const std::size_t used = sizeof(Lengths) + lengths.name + lengths.bytes;
    record += (used + 7) / 8 * 8;
  }
  throw std::out_of_range("no file " + std::string(name) + " in the program");
}

}  // namespace sectile::viewer
