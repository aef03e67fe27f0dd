// SPDX-License-Identifier: Apache-2.0
// Texts that mean something in a format stay texts there. What may run in a browser is tested in tests/browser.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "dxf_reader.hpp"
#include "errors.hpp"
#include "output/write.hpp"
#include "pdf_reader.hpp"

namespace epura {

using test::contains;

namespace {

const std::vector<std::string> payloads{
    ")",
    "(((",
    "\\",
    "\\)",
    "\\) showpage (",
    ") /S /JavaScript /JS (app.alert\\(1\\)",
    ">> /OpenAction << /S /Launch /F (x) >> <<",
    "endstream endobj 9 0 obj << /S /JavaScript /JS (x) >> endobj",
    "\nendobj\n%%EOF\n",
    "%%EOF",
    "\n%%EOF\n%%BeginSetup\n(x) run\n",
    "\r%%BeginProlog\r(x) deletefile\r",
    "\n(x) (w) file quit\n",
    "<~ ~>",
    "\n  0\nSECTION\n",
    "\n0\nEOF\n",
    "\r\n  0\r\nINSERT\r\n  2\r\n*MODEL_SPACE\r\n",
    "\r0\rEOF\r",
    "%%u %%d %%c",
    "%<\\AcVar Filename>%",
    "{\\Fshx|c0;x}\\P",
    "\\U+000A0\\U+000AEOF",
    "\\M+1000A",
    "^J  0^JEOF^J",
    "\x1b[2J\x1b]0;title\a",
    "\x7f\b\b\b",
    "\xC2\x9B"
    "31m",
    "\xE2\x80\xA8\xE2\x80\xAE",
    std::string("a\0b", 3),
    "\xFF\xFE\xC0\x80",
};

/// The payload in every text of a sheet.
sheet::Sheet sheet_with(const std::string& text) {
  sheet::Sheet sheet{297, 210, text, {}};
  sheet::Layer& lines = sheet.layers.emplace_back();
  lines.name = text + "/visible";
  lines.style = {"visible", 0.5};
  lines.strokes.push_back({{{5, 5}, {290, 5}}});
  sheet::Layer& texts = sheet.layers.emplace_back();
  texts.name = "sheet/" + text;
  texts.style = {"grid", 0.35};
  texts.texts.push_back({text, {100, 100}, 3.5, 0, sheet::Align::left, "label"});
  sheet.facts = {{"author", text}, {"subject", text}, {"keywords", text}};
  return sheet;
}

class Injection : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Payloads, Injection, testing::ValuesIn(payloads),
                         [](const auto& payload) { return "number_" + std::to_string(payload.index); });

TEST_P(Injection, NothingRunsInPdf) {
  const sheet::Sheet sheet = sheet_with(GetParam());
  const std::string bytes = output::to_pdf({&sheet});
  const PdfReader pdf(bytes);
  EXPECT_FALSE(pdf.has_trouble());
  EXPECT_EQ(pdf.pages(), 1);
  for (const char* key : {"/OpenAction", "/AA", "/AcroForm", "/JavaScript"}) EXPECT_FALSE(pdf.root().has(key)) << key;
  EXPECT_FALSE(pdf.root()["/Names"].has("/JavaScript"));
  EXPECT_FALSE(pdf.page().has("/AA"));
  EXPECT_EQ(pdf.page()["/Annots"].size(), 0);
}

/// A PostScript file, taken apart as its readers do.
struct PostScript {
  std::multiset<std::string> structure;  ///< keywords of comments that structure it
  std::string program;                   ///< the rest, without strings
};

/// Strings are in parentheses; a backslash takes the meaning from the next character (PostScript Language Reference
/// 3.2.2).
std::string without_strings(const std::string& program) {
  std::string rest;
  int depth = 0;
  for (std::size_t i = 0; i < program.size(); ++i) {
    if (depth > 0 && program[i] == '\\') {
      ++i;
      continue;
    }
    if (program[i] == ')') --depth;
    if (depth == 0) rest += program[i];
    if (program[i] == '(') ++depth;
  }
  EXPECT_EQ(depth, 0);
  return rest;
}

PostScript read_ps(const std::string& bytes) {
  PostScript read;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find_first_of("\r\n", at), bytes.size());
    const std::string line = bytes.substr(at, end - at);
    // Which resources are there depends on which letters are.
    if (line.starts_with("%%") && !contains(line, "Resource"))
      read.structure.insert(line.substr(0, line.find_first_of(": ")));
    if (!line.starts_with("%")) read.program += line + "\n";
    at = end + 1;
  }
  read.program = without_strings(read.program);
  return read;
}

TEST_P(Injection, NothingRunsInPostScript) {
  const sheet::Sheet sheet = sheet_with(GetParam()), plain = sheet_with("x");
  for (const auto& encode : {+[](const sheet::Sheet& one) { return output::to_ps({&one}); },
                             +[](const sheet::Sheet& one) { return output::to_eps(one); }}) {
    const PostScript read = read_ps(encode(sheet));
    EXPECT_EQ(read.structure, read_ps(encode(plain)).structure);
    for (const char* word : {"deletefile", "() run", "() file"}) EXPECT_FALSE(contains(read.program, word)) << word;
  }
}

TEST_P(Injection, NothingIsAddedInDxf) {
  const std::string bytes = output::to_dxf(sheet_with(GetParam())), plain = output::to_dxf(sheet_with("x"));
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  EXPECT_EQ(lines(bytes), lines(plain));
  // A code and a value in turn, the codes as in the plain file.
  std::size_t at = 0, of_plain = 0;
  const auto next = [](const std::string& text, std::size_t& from) {
    const std::size_t begin = from, end = text.find('\n', from);
    from = end + 1;
    return text.substr(begin, end - begin);
  };
  while (of_plain < plain.size() && at < bytes.size()) {
    ASSERT_EQ(next(bytes, at), next(plain, of_plain));
    const std::string value = next(bytes, at);
    next(plain, of_plain);
    for (const char c : value) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) << value;
  }
}

}  // namespace
}  // namespace epura
