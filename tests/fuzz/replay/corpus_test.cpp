// SPDX-License-Identifier: Apache-2.0
// Replays the corpora: the inputs by which the fuzzers reached all code that they know, and all that once failed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "targets.hpp"

namespace epura::fuzz {

void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

namespace {

std::vector<std::filesystem::path> corpus_of(const Target& target) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(EPURA_FUZZ_CORPORA "/" + std::string(target.name)))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Corpus : public testing::TestWithParam<Target> {};

// A corpus that is accepted or refused as a whole does not try what it is for.
TEST_P(Corpus, IsReadOrRefused) {
  int accepted = 0, refused = 0;
  for (const std::filesystem::path& file : corpus_of(GetParam())) {
    SCOPED_TRACE(file.filename().string());
    ++(run(GetParam(), bytes_of(file)) ? accepted : refused);
  }
  EXPECT_GT(accepted, 0);
  EXPECT_GT(refused, 0);
}

TEST(Corpora, AreSmall) {
  constexpr std::uintmax_t most = 5'000'000;  // bytes of all of them
  std::uintmax_t bytes = 0;
  for (const Target& target : all_targets())
    for (const std::filesystem::path& file : corpus_of(target)) bytes += std::filesystem::file_size(file);
  EXPECT_GT(bytes, 0U);
  EXPECT_LT(bytes, most);
}

std::string name_of(const testing::TestParamInfo<Target>& info) {
  std::string name(info.param.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(all_targets()), name_of);

}  // namespace
}  // namespace epura::fuzz
