// SPDX-License-Identifier: Apache-2.0
// Writes large scenes for benchmarks as binary PLY:  scenes KIND SIZE FILE
#include <cstdio>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "generators.hpp"

namespace {

using namespace epura;

int usage() {
  std::fputs("usage: scenes KIND N FILE\n", stderr);
  for (const bench::Generator& generator : bench::all_scenes())
    std::fprintf(stderr, "  %-8s %s\n", generator.name.data(), generator.summary.data());
  return static_cast<int>(ErrorKind::input);
}

int write_scene(std::string_view kind, std::string_view size, const char* file) {
  const auto n = parse_integer(size);
  for (const bench::Generator& generator : bench::all_scenes())
    if (generator.name == kind && n && *n > 0 && *n <= 100'000'000) {
      write_file(file, bench::ply_bytes(generator.make(static_cast<int>(*n))));
      return 0;
    }
  return usage();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return argc == 4 ? write_scene(argv[1], argv[2], argv[3]) : usage();
  } catch (const Error& error) {
    std::fprintf(stderr, "scenes: %s\n", error.what());
    return static_cast<int>(error.kind());
  }
}
