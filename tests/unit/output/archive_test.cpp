// SPDX-License-Identifier: Apache-2.0
// PDF for archives and screen readers: what ISO 19005-3 (PDF/A-3b) and ISO 14289-1 (PDF/UA-1) ask of its structure.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "output/write.hpp"
#include "pdf_reader.hpp"
#include "support.hpp"

namespace epura::archive_test {
namespace {

std::string archive_of(const std::vector<const sheet::Sheet*>& pages) {
  output::VectorOptions options;
  options.pdf = output::PdfKind::archive;
  return output::to_pdf(pages, {}, options);
}

sheet::Text text(const std::string& words, const Vec2& at, const std::string& role = "label") {
  return {words, at, 3.5, 0, sheet::Align::left, role};
}

/// A frame with its grid and a title; a view with two lines, a hidden one, two dimensions, of which one has two texts,
/// a note, and a table of a title and two columns.
sheet::Sheet small_sheet() {
  sheet::Sheet sheet{200, 100, "A plate", {}};
  sheet.views = {{"front", "front", "1:2", {10, 10}, {90, 60}}};
  sheet.facts = {{"language", "de"}, {"author", "N. N."}};
  sheet.summaries = {{"de", {"Das Blatt zeigt ein Teil.", "Ende."}}, {"en", {"The sheet shows a part."}}};
  const auto line = [](const Vec2& from, const Vec2& to, std::optional<EdgeKind> kind) {
    sheet::Stroke stroke{{from, to}};
    stroke.kind = kind;
    return stroke;
  };
  sheet::Layer frame{"sheet/frame", {"frame", 0.7}, {line({5, 5}, {195, 5}, {})}};
  sheet::Layer words{"sheet/text", {"text", 0.35}, {}};
  words.texts = {text("A", {1, 50}, "grid-reference"), text("A plate", {150, 10}, "title"), text(" ", {150, 20})};
  sheet::Layer hidden{"front/hidden", {"hidden", 0.25, {3, 0.75}}, {line({10, 30}, {50, 30}, EdgeKind::crease)}};
  sheet::Layer visible{"front/visible", {"visible", 0.5}, {}};
  visible.strokes = {line({10, 10}, {50, 10}, EdgeKind::crease), line({10, 50}, {50, 50}, EdgeKind::crease)};
  sheet::Layer sizes{"front/dimensions", {"dimension", 0.25}, {line({10, 5}, {50, 5}, {})}};
  sizes.texts = {
      text("80", {30, 6}),      text("⌀8", {60, 30}), text("H7", {66, 30}), text("deburr /NonStruct", {60, 20}),
      text("Holes", {101, 91}), text("X", {101, 85}), text("Y", {121, 85}), text("7", {101, 79}),
      text("9", {121, 79})};
  sheet::DimensionObject length{sheet::DimensionShape::linear, {}}, diameter{sheet::DimensionShape::diameter, {}};
  length.text = "80", length.texts = {0, 1};
  diameter.text = "⌀8 H7", diameter.texts = {1, 3};
  sizes.dimensions = {length, diameter};
  sheet::LeaderObject note{{}, LeaderEnd::arrow, 3, {"deburr /NonStruct"}};
  note.texts = {3, 4};
  sizes.leaders = {note};
  sheet::TableObject table{{100, 96}, {20, 20}, 6, 3.5, 1, {{{"Holes"}}, {{"X"}, {"Y"}}, {{"7"}, {"9"}}}};
  table.texts = {4, 9};
  sizes.tables = {table};
  sheet.layers = {frame, words, hidden, visible, sizes};
  return sheet;
}

/// The content of a page, stream by stream.
std::vector<std::string> streams_of(const PdfObject& page) {
  std::vector<std::string> streams;
  for (int i = 0; i < page["/Contents"].size(); ++i) streams.push_back(page["/Contents"][i].stream());
  return streams;
}

/// Paints outside of any mark, and the numbers of marks in their order.
struct Marks {
  int unmarked = 0;
  std::vector<int> numbers{};
};

Marks marks_of(const std::vector<std::string>& streams) {
  Marks marks;
  std::vector<bool> open;  // whether a mark says what is in it, from outside
  std::string content, word, last;
  for (const std::string& stream : streams) content += stream + "\n";
  std::istringstream words(content);
  std::vector<std::string> before;
  while (words >> word) {
    if (word == "BMC") open.push_back(true);
    if (word == "BDC") {
      const bool has_number = before.size() > 1 && before[before.size() - 2] == "<</MCID";
      if (has_number) marks.numbers.push_back(std::stoi(before.back()));
      open.push_back(has_number);
    }
    if (word == "EMC") open.pop_back();
    const bool paints = word == "S" || word == "f" || word == "f*" || word.ends_with("Tj") || word.ends_with("TJ");
    if (paints && std::find(open.begin(), open.end(), true) == open.end()) ++marks.unmarked;
    before.push_back(word);
  }
  EXPECT_TRUE(open.empty());
  return marks;
}

/// "Sect(P Figure[words] ...)": an element with its elements, and how many marks each has.
std::string structure_of(const PdfObject& element) {
  std::string text = element["/S"].name().substr(1);
  if (element.has("/Alt")) text += "[" + element["/Alt"].text() + "]";
  std::string inner;
  int marks = 0;
  for (int i = 0; element.has("/K") && i < element["/K"].size(); ++i) {
    if (element["/K"][i].is_dictionary())
      inner += (inner.empty() ? "" : " ") + structure_of(element["/K"][i]);
    else
      ++marks;
  }
  if (marks > 0) text += std::to_string(marks);
  return inner.empty() ? text : text + "(" + inner + ")";
}

TEST(Archive, IsReadInOrderWithWordsForWhatIsNoText) {
  const sheet::Sheet sheet = small_sheet();
  const std::string bytes = archive_of({&sheet});
  const PdfReader pdf(bytes);
  EXPECT_EQ(structure_of(pdf.root()["/StructTreeRoot"]["/K"]),
            "Document(Sect(P1) Sect(Figure[Ansicht front (Vorderansicht), Maßstab 1:2: 2 sichtbare "
            "Linien, 1 verdeckte Linie. Das Blatt zeigt ein Teil. Ende.]3 "
            "Span[Länge 80]1 Span[Durchmesser ⌀8 H7]1 P1 "
            "Table[Tabelle Holes, 2 Zeilen](TR(TD1) TR(TH1 TH1) TR(TD1 TD1))))");
  EXPECT_FALSE(pdf.has_trouble());
}

// ISO 19005-3, 6.1.7.1: an end of line before `endstream` that is no byte of the stream.
TEST(Archive, EndsALineBeforeTheEndOfEachStream) {
  const sheet::Sheet sheet = small_sheet();
  const std::string bytes = archive_of({&sheet});
  const std::string begin = ">>\nstream\n", length = "/Length ";
  int streams = 0;
  for (std::size_t at = bytes.find(begin); at != bytes.npos; at = bytes.find(begin, at + 1)) {
    const std::size_t digits = bytes.rfind(length, at) + length.size();
    EXPECT_EQ(bytes.substr(at + begin.size() + std::stoul(bytes.substr(digits, 9)), 10), "\nendstream");
    ++streams;
  }
  EXPECT_GE(streams, 5);
}

TEST(Archive, MarksAllInkOnceAndFindsItsElements) {
  const sheet::Sheet sheet = small_sheet(), other = random_sheet(100, 100);
  const std::string bytes = archive_of({&sheet, &other});
  const PdfReader pdf(bytes);
  const PdfObject parents = pdf.root()["/StructTreeRoot"]["/ParentTree"]["/Nums"];
  ASSERT_EQ(parents.size(), 4);
  for (int page = 0; page < 2; ++page) {
    const Marks marks = marks_of(streams_of(pdf.page(static_cast<std::size_t>(page))));
    EXPECT_EQ(marks.unmarked, 0);
    EXPECT_EQ(pdf.page(static_cast<std::size_t>(page))["/StructParents"].number(), page);
    ASSERT_EQ(static_cast<int>(marks.numbers.size()), parents[2 * page + 1].size());
    for (int i = 0; i < parents[2 * page + 1].size(); ++i) {
      EXPECT_EQ(marks.numbers[static_cast<std::size_t>(i)], i);
      const PdfObject contents = parents[2 * page + 1][i]["/K"];
      int times = 0;
      for (int k = 0; k < contents.size(); ++k)
        if (!contents[k].is_dictionary() && contents[k].number() == i) ++times;
      EXPECT_EQ(times, 1);
    }
  }
}

// Without its marks, a layer is that of a plain file.
TEST(Archive, LeavesLayersAsTheyAre) {
  const sheet::Sheet sheet = small_sheet();
  const std::string archive = archive_of({&sheet}), plain = output::to_pdf({&sheet});
  const PdfReader marked(archive), usual(plain);
  const std::vector<std::string> streams = streams_of(marked.page()), others = streams_of(usual.page());
  // Lines and letters. A plain file has texts on one base line in one list, with the distances between them.
  const auto ink = [](const std::string& stream) {
    std::istringstream words(stream);
    std::string word, shown;
    while (words >> word) {
      bool is_open = false;
      for (const char c : word) {
        if (c == '(' || c == ')')
          is_open = c == '(';
        else if (is_open && (word.ends_with("Tj") || word.ends_with("TJ")))
          shown += c;
      }
      if (word == "S" || word == "l") shown += "\n" + word + "\n";
    }
    return shown;
  };
  ASSERT_EQ(streams.size(), others.size());
  for (std::size_t i = 0; i < streams.size(); ++i) EXPECT_EQ(ink(streams[i]), ink(others[i])) << i;
  EXPECT_EQ(marked.root()["/OCProperties"]["/OCGs"].size(), usual.root()["/OCProperties"]["/OCGs"].size());
}

TEST(Archive, HasWhatTheStandardsAskOfADocument) {
  sheet::Sheet sheet = small_sheet();
  const std::string bytes = archive_of({&sheet});
  const PdfReader pdf(bytes);
  const PdfObject root = pdf.root();
  EXPECT_EQ(root["/Lang"].text(), "de");
  EXPECT_TRUE(root["/MarkInfo"].has("/Marked"));
  EXPECT_TRUE(root["/ViewerPreferences"].has("/DisplayDocTitle"));
  EXPECT_EQ(root["/OCProperties"]["/D"]["/Name"].text(), "Layers");
  EXPECT_FALSE(root["/Metadata"].has("/Filter"));
  const std::string metadata = root["/Metadata"].stream();
  for (const char* words :
       {"<pdfaid:part>3</pdfaid:part>", "<pdfaid:conformance>B</pdfaid:conformance>", "<pdfuaid:part>1</pdfuaid:part>",
        "<rdf:li xml:lang=\"x-default\">A plate</rdf:li>", "<rdf:li>N. N.</rdf:li>"})
    EXPECT_NE(metadata.find(words), metadata.npos) << words;
  const PdfObject intent = root["/OutputIntents"][0];
  EXPECT_EQ(intent["/S"].name(), "/GTS_PDFA1");
  EXPECT_EQ(intent["/DestOutputProfile"]["/N"].number(), 3);
  EXPECT_EQ(archive_of({&sheet}), bytes);
  sheet.title.clear();
  const std::string untitled = archive_of({&sheet});
  EXPECT_NE(PdfReader(untitled).root()["/Metadata"].stream().find("Drawing</rdf:li>"), std::string::npos);
}

// ICC.1:2010, 7.2 and 7.3.
TEST(Archive, HasAProfileOfItsColours) {
  const sheet::Sheet sheet = small_sheet();
  const std::string bytes = archive_of({&sheet});
  const std::string profile = PdfReader(bytes).root()["/OutputIntents"][0]["/DestOutputProfile"].stream();
  const auto number = [&](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(profile.at(i));
    return value;
  };
  EXPECT_EQ(number(0), profile.size());
  EXPECT_EQ(profile.substr(12, 12), "mntrRGB XYZ ");
  EXPECT_EQ(profile.substr(36, 4), "acsp");
  // The colorants of red, green and blue together are the white of the connection space.
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < number(128); ++i) {
    const std::string tag = profile.substr(132 + 12 * i, 4);
    const std::size_t begin = number(136 + 12 * i), size = number(140 + 12 * i);
    ASSERT_LE(begin + size, profile.size());
    if (tag == "rXYZ" || tag == "gXYZ" || tag == "bXYZ")
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum[axis] += static_cast<double>(number(begin + 8 + 4 * axis)) / 65536;
  }
  EXPECT_NEAR(sum[0], 0.9642, 3e-4);
  EXPECT_NEAR(sum[1], 1, 3e-4);
  EXPECT_NEAR(sum[2], 0.8249, 3e-4);
}

}  // namespace
}  // namespace epura::archive_test
