// SPDX-License-Identifier: Apache-2.0
#include "output/pdf/contents.hpp"

#include <charconv>
#include <exception>
#include <map>
#include <optional>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QUtil.hh>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "output/pdf/packing.hpp"

namespace epura::output {

namespace {

using Handle = QPDFObjectHandle;

// qpdf's own conversion depends on the locale.
double number_of(Handle object) {
  const std::string text = object.isInteger() ? std::to_string(object.getIntValue()) : object.getRealValue();
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// The widths of glyphs by their codes: one list for simple fonts; for others, lists that each begin at a code. ISO
// 32000-1, 9.6.2 and 9.7.4.3.
std::map<std::size_t, double> widths_of(Handle font, bool is_simple) {
  std::map<std::size_t, double> widths;
  const auto add = [&widths](std::size_t first, Handle list) {
    for (int i = 0; list.isArray() && i < list.getArrayNItems(); ++i)
      widths[first + static_cast<std::size_t>(i)] = number_of(list.getArrayItem(i));
  };
  if (is_simple) {
    add(static_cast<std::size_t>(number_of(font.getKey("/FirstChar"))), font.getKey("/Widths"));
    return widths;
  }
  Handle lists = font.getKey("/DescendantFonts").getArrayItem(0).getKey("/W");
  for (int i = 0; lists.isArray() && i + 1 < lists.getArrayNItems(); i += 2)
    add(static_cast<std::size_t>(number_of(lists.getArrayItem(i))), lists.getArrayItem(i + 1));
  return widths;
}

// The next <...> of a map of characters, as bytes; nothing after the last one.
std::optional<std::string> next_code(const std::string& map, std::size_t& at) {
  const std::size_t begin = map.find('<', at), end = map.find('>', begin);
  if (end == std::string::npos) return std::nullopt;
  at = end + 1;
  return QUtil::hex_decode(map.substr(begin + 1, end - begin - 1));
}

// Each glyph of a font has its line between beginbfchar and endbfchar. ISO 32000-1, 9.10.3.
PdfFont font_of(Handle font, UnpackRoom& room) {
  const bool is_simple = !font.getKey("/Subtype").isNameAndEquals("/Type0");
  PdfFont read;
  read.bytes = is_simple ? 1 : 2;
  if (!font.getKey("/ToUnicode").isStream()) return read;
  const std::map<std::size_t, double> widths = widths_of(font, is_simple);
  const std::string map = room.unpack(font.getKey("/ToUnicode"));
  for (std::size_t begin = map.find("beginbfchar"); begin != std::string::npos;
       begin = map.find("beginbfchar", begin + 1)) {
    const std::string lines = map.substr(begin, map.find("endbfchar", begin) - begin);
    std::size_t at = 0;
    while (const std::optional<std::string> code = next_code(lines, at)) {
      std::size_t number = 0;
      for (const char byte : *code) number = 256 * number + static_cast<unsigned char>(byte);
      const auto width = widths.find(number);
      read.glyphs[*code] = {QUtil::utf16_to_utf8(next_code(lines, at).value_or("")),
                            width == widths.end() ? 0 : width->second};
    }
  }
  return read;
}

PdfContent content_of(Handle page, UnpackRoom& room) {
  PdfContent content;
  Handle box = page.getKey("/MediaBox");
  content.width = number_of(box.getArrayItem(2)) - number_of(box.getArrayItem(0));
  content.height = number_of(box.getArrayItem(3)) - number_of(box.getArrayItem(1));
  Handle resources = page.getKey("/Resources"), streams = page.getKey("/Contents");
  // Every second stream of a page is a layer; earlier versions had form XObjects instead.
  if (!streams.isArray()) content.page = room.unpack(streams);
  for (int i = 0; streams.isArray() && i < streams.getArrayNItems(); ++i) {
    const std::string name = "/layer" + std::to_string(i / 2);
    std::string part = room.unpack(streams.getArrayItem(i));
    const bool is_layer = i % 2 != 0;
    content.page += is_layer ? "\n" + name + " Do\n" : part;
    if (is_layer) content.forms[name] = std::move(part);
  }
  Handle layers = resources.getKey("/Properties"), forms = resources.getKey("/XObject");
  for (const std::string& name : layers.getKeys())
    content.layers[name] = layers.getKey(name).getKey("/Name").getUTF8Value();
  for (const std::string& name : streams.isArray() ? std::set<std::string>() : forms.getKeys())
    content.forms[name] = room.unpack(forms.getKey(name));
  Handle fonts = resources.getKey("/Font");
  for (const std::string& name : fonts.isDictionary() ? fonts.getKeys() : std::set<std::string>())
    content.fonts[name] = font_of(fonts.getKey(name), room);
  return content;
}

void expect_ours(QPDF& pdf, const std::string& where) {
  Handle information = pdf.getTrailer().getKey("/Info");
  const bool ours = information.isDictionary() && information.getKey("/Producer").isString() &&
                    information.getKey("/Producer").getUTF8Value() == "epura";
  if (!ours)
    throw Error(ErrorKind::input, where, "was not written by epura",
                "epura compares only PDF files that it wrote itself");
}

Attachment attachment_of(Handle place, UnpackRoom& room) {
  Handle file = place.getKey("/EF").getKey("/UF");
  const bool is_source = place.getKey("/AFRelationship").isNameAndEquals("/Source");
  return {place.getKey("/UF").getUTF8Value(), file.getDict().getKey("/Subtype").getName().substr(1),
          place.getKey("/Desc").getUTF8Value(), is_source ? Relation::source : Relation::data, room.unpack(file)};
}

// Calls `read(pdf, room)` for a file that epura wrote.
template <class Read>
void read_ours(const std::string& bytes, const std::string& where, const Read& read) {
  try {
    check_packing(bytes, where);
    QPDF pdf;
    pdf.setSuppressWarnings(true);
    pdf.setAttemptRecovery(false);  // recovery would guess the positions of objects
    pdf.processMemoryFile(where.c_str(), bytes.data(), bytes.size());
    check_object_streams(pdf, bytes.size(), where);
    expect_ours(pdf, where);
    UnpackRoom room(64'000'000 + 16 * bytes.size(), where);
    read(pdf, room);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& kind) {
    throw Error(ErrorKind::input, where, std::string("is not a readable PDF: ") + kind.what());
  }
}

}  // namespace

std::vector<PdfContent> read_pdf_contents(const std::string& bytes, const std::string& where) {
  std::vector<PdfContent> pages;
  read_ours(bytes, where, [&](QPDF& pdf, UnpackRoom& room) {
    for (Handle page : pdf.getRoot().getKey("/Pages").getKey("/Kids").getArrayAsVector()) {
      if (page.hasKey("/Kids"))
        throw Error(ErrorKind::input, where, "has nested page groups",
                    "epura compares only PDF files that it wrote itself");
      pages.push_back(content_of(page, room));
    }
  });
  return pages;
}

std::vector<Attachment> read_pdf_attachments(const std::string& bytes, const std::string& where) {
  std::vector<Attachment> attachments;
  read_ours(bytes, where, [&](QPDF& pdf, UnpackRoom& room) {
    Handle associated = pdf.getRoot().getKey("/AF");
    if (!associated.isArray()) return;
    for (Handle place : associated.getArrayAsVector()) attachments.push_back(attachment_of(place, room));
  });
  return attachments;
}

}  // namespace epura::output
