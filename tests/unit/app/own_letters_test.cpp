// SPDX-License-Identifier: Apache-2.0
// What epura writes on sheets by itself, in all its languages, has glyphs in the lettering font.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "base/text.hpp"
#include "base/utf8.hpp"
#include "errors.hpp"
#include "program.hpp"
#include "sheet/lettering.hpp"
#include "sheet/text_runs.hpp"

namespace epura::test::own_letters_test {
namespace {

// The letters beyond ASCII of all texts in a source.
std::set<char32_t> letters_of(const std::filesystem::path& source) {
  static const std::regex text("\"(?:[^\"\\\\]|\\\\.)*\"");
  std::set<char32_t> letters;
  const std::string whole = read_file(source);
  for (const std::string_view line : split(whole, '\n')) {
    const std::string code(line);
    if (code.find_first_not_of(' ') == code.find("//")) continue;
    for (std::sregex_iterator one(code.begin(), code.end(), text), end; one != end; ++one)
      for (const char32_t letter : characters(one->str()))
        if (letter > 0x7f) letters.insert(letter);
  }
  return letters;
}

// Chinese, Japanese and Korean have fonts of their own; a minus and primes are read; the cap stands for an arc in fonts
// without its sign. Reports of comparisons are no sheets.
TEST(OwnLetters, AreInTheLetteringFont) {
  const sheet::Lettering lettering;
  const std::set<char32_t> others{U'−', U'′', U'″', U'∩'};
  std::set<char32_t> known;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root() / "src")) {
    const std::filesystem::path& source = entry.path();
    const bool is_source = source.extension() == ".cpp" || source.extension() == ".hpp";
    if (!is_source || source.parent_path().filename() == "compare") continue;
    for (const char32_t letter : letters_of(source)) {
      if (sheet::is_ideographic(letter) || others.contains(letter)) continue;
      EXPECT_TRUE(lettering.covers(utf8(letter))) << utf8(letter) << " in " << source;
      known.insert(letter);
    }
  }
  EXPECT_TRUE(known.contains(U'⌀') && known.contains(U'±') && known.contains(U'é'));
}

}  // namespace
}  // namespace epura::test::own_letters_test
