// SPDX-License-Identifier: Apache-2.0
// Small files that stand for more than there is memory or time for, and places that no paper has: each is refused with
// a sentence.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "compare/read_pictures.hpp"
#include "errors.hpp"

namespace epura::test::picture_limits_test {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

std::string svg_with(const std::string& content) {
  return "<svg xmlns:inkscape='i' width='100mm' height='100mm' viewBox='0 0 100 100'>" + content + "</svg>";
}

std::string path(const std::string& data, const std::string& attributes = "") {
  return "<path stroke='#000' fill='none' " + attributes + " d='" + data + "'/>";
}

std::string refusal_of_svg(const std::string& content) {
  return error_of([&] { compare::picture_of_svg(svg_with(content), "test.svg"); }).what();
}

TEST(PictureLimits, PlacesBeyondAllPaper) {
  const std::string beyond = "outside any paper";
  for (const char* data : {"M0 0L1e300 1e300", "M0 0L1e7 1", "M0 0C0 0 1e300 1e300 9 9", "M0 0Q1e308 -1e308 9 9",
                           "M0 0A1e308 1 0 0 1 1e200 9", "M0 0h1e308h1e308"})
    EXPECT_TRUE(contains(refusal_of_svg(path(data)), beyond)) << data << refusal_of_svg(path(data));
  EXPECT_TRUE(contains(refusal_of_svg(path("M0 0h1", "transform='translate(1e300)'")), beyond));
  EXPECT_TRUE(contains(refusal_of_svg("<g aria-label='a'>" + path("M0 0h1e9") + "</g>"), beyond));
  const std::string json =
      R"({"epura":1,"sheet":{"size":[297,210]},"views":[{"name":"front","segments":[{"from":[0,0],"to":[1e300,10],)"
      R"("visible":true,"kind":"crease","model":0,"edge":[1,2]}]}]})";
  EXPECT_TRUE(contains(error_of([&] { compare::picture_of_json(json, "test.json"); }).what(), beyond));
  EXPECT_TRUE(contains(refusal_of_svg(path("M0 0h1", "stroke-width='nan'")), "not valid lengths"));
  EXPECT_TRUE(contains(refusal_of_svg(path("M0 0h1", "stroke-dasharray='1 1e300'")), "not valid lengths"));
}

TEST(PictureLimits, PiecesOfCurves) {
  const std::string many = "pieces of lines";
  for (const char* curve : {"c9e5 0 0 9e5 0 0", "q9e5 9e5 0 0", "a9e5 9e5 0 1 0 1 1"})
    EXPECT_TRUE(contains(refusal_of_svg(path("M0 0" + repeated(curve, 200))), many)) << curve;
  EXPECT_TRUE(contains(refusal_of_svg(repeated(path("M0 0c9e5 0 0 9e5 0 0"), 200)), many));
  EXPECT_TRUE(
      contains(refusal_of_svg("<g aria-label='a'>" + repeated(path("M0 0c9e5 0 0 9e5 0 0"), 200) + "</g>"), many));
  // As many as take 256 MB to be compared: a curve of 9e3 units stands for nearly 10 000 pieces.
  const auto curves = [](int count) { return svg_with(path("M0 0" + repeated("c0 9e3 9e3 0 0 0", count))); };
  EXPECT_NO_THROW(compare::picture_of_svg(curves(24), "test.svg"));
  EXPECT_TRUE(contains(error_of([&] { compare::picture_of_svg(curves(90), "test.svg"); }).what(), many));
  // Dashes of a group count for each of its looks.
  std::string lines;
  for (int i = 0; i < 150; ++i) lines += path("M0 0h1", "stroke-width='" + std::to_string(i) + "'");
  const std::string dashes = repeated("1 ", 10'000);
  EXPECT_TRUE(contains(refusal_of_svg("<g stroke-dasharray='" + dashes + "'>" + lines + "</g>"), many));
}

TEST(PictureLimits, NamesAndTexts) {
  std::string looks, views;
  for (int i = 0; i < 201; ++i) looks += path("M0 0h1", "stroke-width='" + std::to_string(i) + "'");
  for (int i = 0; i < 2001; ++i)
    views += "<g inkscape:label='" + std::to_string(i) + "'><g inkscape:label='visible'>" + path("M0 0h1") + "</g></g>";
  EXPECT_TRUE(contains(refusal_of_svg(looks), "more than 200 line styles"));
  EXPECT_TRUE(contains(refusal_of_svg(views), "more than 2000 views"));
  const std::string model = "data-model='" + std::string(1000, '1') + "' data-edge='1-2'";
  EXPECT_TRUE(contains(refusal_of_svg(path("M0 0h1", model)), "number is too long"));
  const std::string text = "<text x='1' y='1' font-size='3'>" + std::string(10'001, 'a') + "</text>";
  EXPECT_TRUE(contains(refusal_of_svg(text), "text of more than 10000 bytes"));
}

TEST(PictureLimits, GroupsInGroups) {
  const auto nested = [](int groups) { return repeated("<g>", groups) + path("M0 0h1") + repeated("</g>", groups); };
  EXPECT_NO_THROW(compare::picture_of_svg(svg_with(nested(90)), "test.svg"));
  EXPECT_TRUE(contains(refusal_of_svg(nested(110)), "too many nested groups"));
}

// Bits of Flate data, the lowest of each byte first. RFC 1951.
class Bits {
 public:
  void add(unsigned bits, int count) {
    for (int i = 0; i < count; ++i, ++filled_) {
      if (filled_ % 8 == 0) bytes_ += '\0';
      bytes_.back() = static_cast<char>(bytes_.back() | (bits >> i & 1U) << filled_ % 8);
    }
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t filled_ = 0;
};

// Blanks as Flate data of a 160th of their number: one, and copies of 258 by the fixed codes.
std::string packed_blanks(std::size_t count) {
  Bits bits;
  bits.add(0b011, 3);        // the last block, with fixed codes
  bits.add(0b0000'1010, 8);  // 0x20, whose code is 0x50, turned round
  for (std::size_t copied = 0; copied < count; copied += 258) {
    bits.add(0b1010'0011, 8);  // length 258, whose code is 0xC5, turned round
    bits.add(0, 5);            // distance 1
  }
  bits.add(0, 7);
  return "\x78\x9c" + bits.bytes();
}

// A PDF file of objects that are numbered from 1: catalogue, information, pages, page, its content, and what else.
struct PdfFile {
  std::string page = "/Resources<<>>", pages = "4 0 R";
  std::string content_keys{}, content{};
  std::vector<std::string> more{};

  [[nodiscard]] static std::string stream(const std::string& keys, const std::string& data) {
    return "<</Length " + std::to_string(data.size()) + keys + ">>stream\n" + data + "\nendstream";
  }

  [[nodiscard]] std::string bytes() const {
    std::vector<std::string> objects = {
        "<</Type/Catalog/Pages 3 0 R>>", "<</Producer(epura)>>", "<</Type/Pages/Kids[" + pages + "]/Count 1>>",
        "<</Type/Page/Parent 3 0 R/MediaBox[0 0 100 100]/Contents 5 0 R" + page + ">>", stream(content_keys, content)};
    objects.insert(objects.end(), more.begin(), more.end());
    std::string file = "%PDF-1.5\n", table = "0000000000 65535 f \n";
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const std::string place = std::to_string(file.size());
      table += std::string(10 - place.size(), '0') + place + " 00000 n \n";
      file += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
    }
    const std::string size = std::to_string(objects.size() + 1), start = std::to_string(file.size());
    return file + "xref\n0 " + size + "\n" + table + "trailer\n<</Size " + size +
           "/Root 1 0 R/Info 2 0 R>>\nstartxref\n" + start + "\n%%EOF\n";
  }
};

std::string refusal_of_pdf(const std::string& bytes) {
  return error_of([&] { compare::pictures_of_pdf(bytes, "test.pdf"); }).what();
}

PdfFile with_layer(const std::string& page_content, const std::string& layer) {
  PdfFile file;
  file.page = "/Resources<</XObject<</X 6 0 R>>/Properties<</P<</Name(a/visible)>>>>>>";
  file.content = page_content;
  file.more = {PdfFile::stream("/Type/XObject/Subtype/Form/BBox[0 0 9 9]", layer)};
  return file;
}

TEST(PictureLimits, PdfThatIsSound) {
  const std::string layer = "0.5 w [3 .75] 0 d 10 10 m % (\n20 10 l S [] 0 d 30 30 m 40 30 l S";
  const std::vector<compare::Picture> pictures =
      compare::pictures_of_pdf(with_layer("q /OC /P BDC /X Do EMC Q", layer).bytes(), "test.pdf");
  ASSERT_EQ(pictures.size(), 1U);
  ASSERT_EQ(pictures[0].pieces.size(), 2U);
  EXPECT_EQ(pictures[0].views, std::vector<std::string>{"a"});
  for (const std::size_t i : {0, 1}) {
    const compare::PictureLook& look = pictures[0].looks[static_cast<std::size_t>(pictures[0].pieces[i].look)];
    EXPECT_NEAR(look.width, 0.5 * 25.4 / 72, 1e-12);
    EXPECT_EQ(look.dashes.empty(), i == 1);
  }
}

TEST(PictureLimits, PdfThatUnpacksToTooMuch) {
  PdfFile bomb;
  bomb.content_keys = "/Filter/FlateDecode";
  bomb.content = packed_blanks(90'000'000);
  EXPECT_TRUE(contains(refusal_of_pdf(bomb.bytes()), "unpacks to more than 7"));
  PdfFile pages = bomb;  // the same page again and again
  pages.content = packed_blanks(20'000'000);
  pages.pages = repeated("4 0 R ", 6);
  EXPECT_TRUE(contains(refusal_of_pdf(pages.bytes()), "unpacks to more than 6")) << refusal_of_pdf(pages.bytes());
}

TEST(PictureLimits, PdfPackedInAnotherWay) {
  for (const char* keys :
       {"/Filter[/FlateDecode/FlateDecode]", "/Filter/LZWDecode", "/Filter/FlateDecode#58", "/F#69lter/LZWDecode",
        "/Filter 6 0 R", "/Filter/FlateDecode/DecodeParms<</Predictor 12/Columns 4000000000>>",
        "/Filter/FlateDecode/DecodeParms 6 0 R", "/Filter/FlateDecode/Decode#50arms<</Columns 99999>>",
        "/Filter/FlateDecode/DecodeParms<</Predictor 12/Colors 99>>", "/Length 6 0 R", "/Encrypt 6 0 R"}) {
    PdfFile file;
    file.content_keys = keys;
    EXPECT_TRUE(contains(refusal_of_pdf(file.bytes()), "packed in a way")) << keys;
  }
}

TEST(PictureLimits, PdfTablesAndObjects) {
  PdfFile table;
  const std::string bomb = packed_blanks(2'000'000);
  for (const char* type : {"/Type/XRef", "/Type /X#52ef"}) {
    table.more = {PdfFile::stream(std::string(type) + "/Filter/FlateDecode/W[1 1 1]/Size 9", bomb)};
    EXPECT_TRUE(contains(refusal_of_pdf(table.bytes()), "unpacks to more than 1")) << type;
  }
  // The catalogue in a stream of objects, and the table that says so.
  std::string file = "%PDF-1.5\n", entries;
  const auto add = [&](int type, std::size_t a, int b) {
    entries += static_cast<char>(type);
    for (const int shift : {24, 16, 8, 0}) entries += static_cast<char>(a >> shift & 0xFF);
    entries += static_cast<char>(b);
  };
  add(0, 0, 0);
  add(2, 2, 0);
  add(1, file.size(), 0);
  file += "2 0 obj\n" + PdfFile::stream("/Type/ObjStm/N 1/First 4/Filter/FlateDecode", packed_blanks(5'000'000)) +
          "\nendobj\n";
  const std::string start = std::to_string(file.size());
  add(1, file.size(), 0);
  file += "3 0 obj\n" + PdfFile::stream("/Type/XRef/W[1 4 1]/Size 4/Root 1 0 R", entries) + "\nendobj\nstartxref\n" +
          start + "\n%%EOF\n";
  EXPECT_TRUE(contains(refusal_of_pdf(file), "unpacks to more than 2 MB")) << refusal_of_pdf(file);
}

TEST(PictureLimits, PdfContent) {
  const auto refusal = [](const std::string& page, const std::string& layer) {
    return refusal_of_pdf(with_layer(page, layer).bytes());
  };
  const std::string draw = "/OC /P BDC /X Do ";
  EXPECT_TRUE(contains(refusal(draw + "/X Do", "0 0 m 1 1 l S"), "or a layer twice"));
  EXPECT_TRUE(contains(refusal(repeated("q ", 200), ""), "graphics states"));
  EXPECT_TRUE(contains(refusal(draw, repeated("q ", 200)), "graphics states"));
  EXPECT_TRUE(contains(refusal(draw, repeated("1 0 0 1 900000 0 cm ", 9) + "0 0 m 1 1 l S"), "outside any paper"));
  EXPECT_TRUE(contains(refusal(draw, "0 0 m " + repeated("900000 0 0 900000 0 0 c ", 200)), "stands for more than"));
  PdfFile grouped = with_layer(draw, "");
  grouped.page += "/Kids[4 0 R]";
  EXPECT_TRUE(contains(refusal_of_pdf(grouped.bytes()), "nested page groups"));
  EXPECT_TRUE(contains(refusal(draw, "BI /W 1 ID x EI"), "unsupported painting"));
}

}  // namespace
}  // namespace epura::test::picture_limits_test
