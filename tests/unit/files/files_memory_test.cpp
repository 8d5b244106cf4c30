// Small files that promise much must not be given much.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <new>

#include "file_samples.h"

namespace {
std::size_t largest = 0;
}

void* operator new(std::size_t size) {
  largest = std::max(largest, size);
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
// Not inlined: a compiler that sees only this half takes the pair for mismatched.
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace sectile::test {
namespace {

constexpr std::size_t enough = std::size_t{4} << 20;

void expect_frugal(const std::string& content, FileFormat format) {
  largest = 0;
  EXPECT_NE(refusal(content, format), "") << content;
  EXPECT_GT(largest, 0u);
  EXPECT_LT(largest, enough) << content;
}

TEST(FilesMemory, PromisesAreNotBelieved) {
  for (const char* number : {"4294967295", "1000000000", "4611686018427387904"}) {
    const std::string n = number;
    expect_frugal("OFF\n" + n + " 1 0\n0 0 0\n", FileFormat::off);
    expect_frugal("OFF\n1 " + n + " 0\n0 0 0\n", FileFormat::off);
    expect_frugal("OFF\n1 1 0\n0 0 0\n" + n + " 0 0 0\n", FileFormat::off);
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
      const std::string start = "ply\nformat " + std::string(format) + " 1.0\nelement vertex ";
      const std::string properties = "\nproperty float x\nproperty float y\nproperty float z\n";
      expect_frugal(start + n + properties + "end_header\n0 0 0\n", FileFormat::ply_text);
      expect_frugal(start + "1" + properties + "element face " + n +
                        "\nproperty list uint uint vertex_indices\nend_header\n0 0 0\n",
                    FileFormat::ply_text);
    }
    expect_frugal(
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uint uint vertex_indices\n"
        "end_header\n0 0 0\n" +
            n + " 0 0 0\n",
        FileFormat::ply_text);
  }
  expect_frugal(
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\n"
      "property list uint uint vertex_indices\nend_header\n\xff\xff\xff\xff",
      FileFormat::ply_binary);
  expect_frugal(std::string(80, ' ') + "\xff\xff\xff\xff" + std::string(50, '\0'),
                FileFormat::stl_binary);
}

}  // namespace
}  // namespace sectile::test
