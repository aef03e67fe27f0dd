// SPDX-License-Identifier: Apache-2.0
#include "output/pdf/archive.hpp"

#include <cstddef>
#include <set>

#include "base/error.hpp"
#include "base/utf8.hpp"
#include "output/xml_text.hpp"

namespace epura::output {

namespace {

using Handle = QPDFObjectHandle;

Handle text(const std::string& words) { return Handle::newUnicodeString(valid_utf8(words)); }

// A list of alternatives with one, or of one author.
std::string container(const std::string& name, const std::string& kind, const std::string& item,
                      const std::string& words) {
  if (words.empty()) return "";
  std::string escaped;
  append_escaped(escaped, words);
  return "<" + name + "><rdf:" + kind + "><rdf:li" + item + ">" + escaped + "</rdf:li></rdf:" + kind + "></" + name +
         ">\n";
}

// PDF/A knows no other schemas than those of ISO 19005-3, 6.6.2.3, and those that a file describes.
constexpr const char* schema_of_pdfua =
    "<pdfaExtension:schemas><rdf:Bag><rdf:li rdf:parseType=\"Resource\">"
    "<pdfaSchema:schema>PDF/UA identification schema</pdfaSchema:schema>"
    "<pdfaSchema:namespaceURI>http://www.aiim.org/pdfua/ns/id/</pdfaSchema:namespaceURI>"
    "<pdfaSchema:prefix>pdfuaid</pdfaSchema:prefix><pdfaSchema:property><rdf:Seq><rdf:li rdf:parseType=\"Resource\">"
    "<pdfaProperty:name>part</pdfaProperty:name><pdfaProperty:valueType>Integer</pdfaProperty:valueType>"
    "<pdfaProperty:category>internal</pdfaProperty:category>"
    "<pdfaProperty:description>part of ISO 14289</pdfaProperty:description>"
    "</rdf:li></rdf:Seq></pdfaSchema:property></rdf:li></rdf:Bag></pdfaExtension:schemas>\n";

std::string metadata_of(const PdfDocument& document) {
  // The packet begins with the byte order mark (XMP part 1, 7.3.2).
  return "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
         "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
         "<rdf:Description rdf:about=\"\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\" "
         "xmlns:pdf=\"http://ns.adobe.com/pdf/1.3/\" xmlns:pdfaid=\"http://www.aiim.org/pdfa/ns/id/\" "
         "xmlns:pdfuaid=\"http://www.aiim.org/pdfua/ns/id/\">\n" +
         container("dc:title", "Alt", " xml:lang=\"x-default\"", document.title) +
         container("dc:creator", "Seq", "", document.author) +
         container("dc:description", "Alt", " xml:lang=\"x-default\"", document.subject) +
         "<pdf:Producer>epura</pdf:Producer>\n<pdfaid:part>3</pdfaid:part>\n"
         "<pdfaid:conformance>B</pdfaid:conformance>\n<pdfuaid:part>1</pdfuaid:part>\n</rdf:Description>\n"
         // By itself, as PDFBox finds it.
         "<rdf:Description rdf:about=\"\" xmlns:pdfaExtension=\"http://www.aiim.org/pdfa/ns/extension/\" "
         "xmlns:pdfaSchema=\"http://www.aiim.org/pdfa/ns/schema#\" "
         "xmlns:pdfaProperty=\"http://www.aiim.org/pdfa/ns/property#\">\n" +
         schema_of_pdfua + "</rdf:Description>\n</rdf:RDF></x:xmpmeta>\n<?xpacket end=\"r\"?>";
}

Handle dictionary(const std::string& type) {
  Handle made = Handle::newDictionary();
  made.replaceKey("/Type", Handle::newName(type));
  return made;
}

Handle output_intent(QPDF& pdf) {
  Handle profile = Handle::newStream(&pdf, srgb_profile());
  profile.getDict().replaceKey("/N", Handle::newInteger(3));
  Handle intent = dictionary("/OutputIntent");
  intent.replaceKey("/S", Handle::newName("/GTS_PDFA1"));
  intent.replaceKey("/OutputConditionIdentifier", Handle::newString("sRGB"));
  intent.replaceKey("/Info", Handle::newString("sRGB IEC61966-2.1"));
  intent.replaceKey("/DestOutputProfile", profile);
  return intent;
}

/// The elements of a page as objects, with what they contain.
struct StructurePage {
  std::vector<Handle> elements;
  std::vector<std::vector<Handle>> contents;  // of each: numbers of marks, then elements
  Handle parents = Handle::newArray();        // by number of a mark
};

StructurePage structure_of(QPDF& pdf, const PdfTags& tags, Handle page) {
  StructurePage made;
  for (const PdfElement& element : tags.elements) {
    Handle object = pdf.makeIndirectObject(dictionary("/StructElem"));
    object.replaceKey("/S", Handle::newName("/" + element.type));
    object.replaceKey("/Pg", page);
    if (!element.words.empty()) {
      object.replaceKey("/Alt", text(element.words));
      object.replaceKey("/Lang", text(tags.language));
    }
    Handle attributes = Handle::newDictionary();
    attributes.replaceKey("/O", Handle::newName("/Table"));
    if (element.type == "TH") attributes.replaceKey("/Scope", Handle::newName("/Column"));
    if (element.columns > 1) attributes.replaceKey("/ColSpan", Handle::newInteger(element.columns));
    if (element.type == "TH" || element.columns > 1) object.replaceKey("/A", attributes);
    made.elements.push_back(object);
  }
  made.contents.resize(tags.elements.size());
  int number = 0;
  for (const std::vector<PdfMark>& layer : tags.marks)
    for (const PdfMark& mark : layer) {
      if (mark.element < 0) continue;
      const auto element = static_cast<std::size_t>(mark.element);
      made.contents[element].push_back(Handle::newInteger(number++));
      made.parents.appendItem(made.elements[element]);
    }
  return made;
}

// Elements get their contents, the innermost first; those that have none and need none are left out.
std::vector<Handle> linked(StructurePage& made, const PdfTags& tags, Handle parent) {
  std::vector<Handle> top;
  for (std::size_t i = tags.elements.size(); i-- > 0;) {
    const PdfElement& element = tags.elements[i];
    const bool is_cell = element.type == "TD" || element.type == "TH";
    if (made.contents[i].empty() && !is_cell) continue;
    std::vector<Handle>& among = element.parent < 0 ? top : made.contents[static_cast<std::size_t>(element.parent)];
    if (!made.contents[i].empty()) made.elements[i].replaceKey("/K", Handle::newArray(made.contents[i]));
    made.elements[i].replaceKey("/P",
                                element.parent < 0 ? parent : made.elements[static_cast<std::size_t>(element.parent)]);
    std::size_t place = 0;  // behind the marks, before later elements
    while (place < among.size() && among[place].isInteger()) ++place;
    among.insert(among.begin() + static_cast<std::ptrdiff_t>(place), made.elements[i]);
  }
  return top;
}

// Cairo leaves out that glyphs have the numbers of their characters, which ISO 19005-3, 6.2.11.3.2 wants to be said.
void map_glyphs(Handle fonts) {
  for (const std::string& name : fonts.isDictionary() ? fonts.getKeys() : std::set<std::string>()) {
    Handle font = fonts.getKey(name).getKey("/DescendantFonts");
    if (!font.isArray()) continue;
    for (Handle inner : font.getArrayAsVector())
      if (inner.getKey("/Subtype").isNameAndEquals("/CIDFontType2") && !inner.hasKey("/CIDToGIDMap"))
        inner.replaceKey("/CIDToGIDMap", Handle::newName("/Identity"));
  }
}

}  // namespace

std::string with_marks(const std::string& content, const PdfTags& tags, std::size_t layer, int& first) {
  const std::vector<PdfMark>& marks = tags.marks[layer];
  // Texts have no line breaks, but long ones are written in several lines, each ending with a backslash.
  const std::string begin = "\n/" + std::string(mark_tag) + " << /MCID ", end = " >> BDC";
  std::string changed;
  std::size_t from = 0, number = 0;
  for (std::size_t at = 0; (at = content.find(begin, at)) != std::string::npos;) {
    const std::size_t close = content.find(end, at);
    const bool is_in_text = at > 0 && content[at - 1] == '\\';
    at += begin.size();
    if (is_in_text) continue;
    check(number < marks.size() && close != std::string::npos, "Cairo marks what it is told to mark");
    changed.append(content, from, at - begin.size() + 1 - from);
    from = close + end.size();
    const int element = marks[number++].element;
    changed += element < 0 ? "/Artifact BMC"
                           : "/" + tags.elements[static_cast<std::size_t>(element)].type + " <</MCID " +
                                 std::to_string(first++) + ">> BDC";
  }
  check(number == marks.size(), "Cairo leaves out no mark");
  return changed.append(content, from, std::string::npos);
}

void make_resources_archivable(Handle resources) {
  Handle pictures = resources.getKey("/XObject");
  for (const std::string& name : pictures.isDictionary() ? pictures.getKeys() : std::set<std::string>()) {
    Handle picture = pictures.getKey(name).getDict();
    picture.removeKey("/Interpolate");
    if (picture.getKey("/SMask").isStream()) picture.getKey("/SMask").getDict().removeKey("/Interpolate");
  }
  map_glyphs(resources.getKey("/Font"));
}

void add_structure(QPDF& pdf, const std::vector<PdfPage>& pages, const std::vector<Handle>& page_objects) {
  Handle root = pdf.makeIndirectObject(dictionary("/StructTreeRoot"));
  Handle document = pdf.makeIndirectObject(dictionary("/StructElem"));
  document.replaceKey("/S", Handle::newName("/Document"));
  document.replaceKey("/P", root);
  std::vector<Handle> all;
  Handle numbers = Handle::newArray();
  for (std::size_t i = 0; i < pages.size(); ++i) {
    Handle page = page_objects[i];
    StructurePage made = structure_of(pdf, pages[i].tags, page);
    const std::vector<Handle> top = linked(made, pages[i].tags, document);
    all.insert(all.end(), top.begin(), top.end());
    page.replaceKey("/StructParents", Handle::newInteger(static_cast<long long>(i)));
    numbers.appendItem(Handle::newInteger(static_cast<long long>(i)));
    numbers.appendItem(pdf.makeIndirectObject(made.parents));
  }
  document.replaceKey("/K", Handle::newArray(all));
  Handle tree = Handle::newDictionary();
  tree.replaceKey("/Nums", numbers);
  root.replaceKey("/K", document);
  root.replaceKey("/ParentTree", tree);
  root.replaceKey("/ParentTreeNextKey", Handle::newInteger(static_cast<long long>(pages.size())));
  pdf.getRoot().replaceKey("/StructTreeRoot", root);
}

void make_archive(QPDF& pdf, const PdfDocument& document) {
  Handle root = pdf.getRoot();
  Handle metadata = Handle::newStream(&pdf, metadata_of(document));
  metadata.getDict().replaceKey("/Type", Handle::newName("/Metadata"));
  metadata.getDict().replaceKey("/Subtype", Handle::newName("/XML"));
  root.replaceKey("/Metadata", metadata);
  root.replaceKey("/OutputIntents", Handle::newArray({output_intent(pdf)}));
  root.replaceKey("/Lang", text(document.language));
  Handle marked = Handle::newDictionary();
  marked.replaceKey("/Marked", Handle::newBool(true));
  root.replaceKey("/MarkInfo", marked);
  Handle preferences = Handle::newDictionary();
  preferences.replaceKey("/DisplayDocTitle", Handle::newBool(true));
  root.replaceKey("/ViewerPreferences", preferences);
  root.getKey("/OCProperties").getKey("/D").replaceKey("/Name", text("Layers"));
}

}  // namespace epura::output
