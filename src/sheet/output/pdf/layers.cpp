// SPDX-License-Identifier: Apache-2.0
#include "output/pdf/layers.hpp"

#include <cstddef>
#include <memory>
#include <new>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFWriter.hh>
#include <set>

#include "base/error.hpp"
#include "base/utf8.hpp"
#include "output/pdf/archive.hpp"

namespace epura::output {

namespace {

using Handle = QPDFObjectHandle;

// qpdf makes a warning of its own lack of memory, and goes on without what it could not read. Nothing else is wrong
// with a file that Cairo wrote. Throws std::bad_alloc.
void expect_all_read(QPDF& pdf) {
  if (pdf.anyWarnings()) throw std::bad_alloc();
}

// The pages of a file of Cairo's. `drawn` must not outlive the bytes.
std::vector<Handle> pages_of(QPDF& drawn, const std::string& file) {
  drawn.setSuppressWarnings(true);
  drawn.setImmediateCopyFrom(true);
  drawn.processMemoryFile("layers", file.data(), file.size());
  std::vector<Handle> pages = drawn.getAllPages();
  expect_all_read(drawn);
  for (Handle& page : pages) {
    const bool is_whole = page.getKey("/Contents").isStream() && page.getKey("/Resources").isDictionary();
    expect_all_read(drawn);
    check(is_whole, "Cairo wrote another PDF page");
  }
  return pages;
}

// Adds those of a page to those of others of the same file, in which Cairo gives each a name of its own.
void add_resources(QPDF& pdf, Handle all, Handle of_page) {
  for (const std::string& kind : of_page.getKeys()) {
    if (!of_page.getKey(kind).isDictionary()) continue;
    if (!all.hasKey(kind)) all.replaceKey(kind, Handle::newDictionary());
    Handle together = all.getKey(kind), more = of_page.getKey(kind);
    for (const std::string& name : more.getKeys()) {
      Handle one = more.getKey(name);
      Handle copy = one.isIndirect() ? pdf.copyForeignObject(one) : Handle::parse(one.unparseResolved());
      check(!together.hasKey(name) || together.getKey(name).unparse() == copy.unparse(),
            "Cairo gave two resources one name");
      together.replaceKey(name, copy);
    }
  }
}

Handle add_group(QPDF& pdf, const std::string& name) {
  Handle group = pdf.makeIndirectObject(Handle::newDictionary());
  group.replaceKey("/Type", Handle::newName("/OCG"));
  group.replaceKey("/Name", Handle::newUnicodeString(valid_utf8(name)));
  return group;
}

Handle add_page(QPDF& pdf, const std::string& media_box, Handle resources, Handle contents) {
  Handle page = pdf.makeIndirectObject(Handle::newDictionary());
  page.replaceKey("/Type", Handle::newName("/Page"));
  page.replaceKey("/MediaBox", Handle::parse(media_box));
  page.replaceKey("/Resources", resources);
  page.replaceKey("/Contents", contents);
  pdf.addPage(page, false);
  return pdf.getAllPages().back();
}

// The optional content groups of all pages.
struct Groups {
  Handle all = Handle::newArray();
  Handle order = Handle::newArray();  // grouped by page if there are several
  std::set<std::string> names;

  std::string unique(const std::string& name) {
    std::string found = name;
    for (int number = 2; !names.insert(found).second; ++number) found = name + " (" + std::to_string(number) + ")";
    return found;
  }
};

// `marks`: how many the page has so far.
Handle content_of_layer(QPDF& pdf, const PdfPage& page, Handle drawn, std::size_t layer, int& marks) {
  if (page.tags.marks.empty()) return pdf.copyForeignObject(drawn);
  const std::shared_ptr<Buffer> bytes = drawn.getStreamData(qpdf_dl_specialized);
  const std::string content(reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize());
  return Handle::newStream(&pdf, with_marks(content, page.tags, layer, marks));
}

// Streams of Cairo's stay compressed, between short ones that say which layer each is. The transparency groups of its
// pages are dropped: black ink needs none, and some printers rasterise pages that have one.
Handle add_layers(QPDF& pdf, const PdfPage& page, Groups& groups, Handle order) {
  int marks = 0;
  Handle resources = Handle::newDictionary(), properties = Handle::newDictionary(), contents = Handle::newArray();
  QPDF drawn;
  std::vector<Handle> drawn_layers = pages_of(drawn, page.file);
  check(drawn_layers.size() >= page.layers.size(), "Cairo lost a page");
  for (std::size_t i = 0; i < page.layers.size(); ++i) {
    const std::string name = "/layer" + std::to_string(i);
    Handle group = add_group(pdf, groups.unique(page.layers[i]));
    groups.all.appendItem(group);
    order.appendItem(group);
    properties.replaceKey(name, group);
    const std::string begin = (i > 0 ? "EMC\nQ\n" : "") + ("q\n" + page.placement) + " cm\n/OC " + name + " BDC\n";
    contents.appendItem(Handle::newStream(&pdf, begin));
    contents.appendItem(content_of_layer(pdf, page, drawn_layers[i].getKey("/Contents"), i, marks));
    add_resources(pdf, resources, drawn_layers[i].getKey("/Resources"));
    expect_all_read(drawn);
  }
  contents.appendItem(Handle::newStream(&pdf, std::string(page.layers.empty() ? "" : "EMC\nQ\n")));
  resources.replaceKey("/Properties", properties);
  if (!page.tags.marks.empty()) make_resources_archivable(resources);
  return add_page(pdf, page.media_box, resources, contents);
}

void add_optional_content(QPDF& pdf, const Groups& groups) {
  Handle usual = Handle::newDictionary();
  usual.replaceKey("/Order", groups.order);
  Handle optional_content = Handle::newDictionary();
  optional_content.replaceKey("/OCGs", groups.all);
  optional_content.replaceKey("/D", usual);
  pdf.getRoot().replaceKey("/OCProperties", optional_content);
}

Handle bookmark(QPDF& pdf, const PdfBookmark& mark, Handle page) {
  Handle item = pdf.makeIndirectObject(Handle::newDictionary());
  item.replaceKey("/Title", Handle::newUnicodeString(valid_utf8(mark.title)));
  Handle place = Handle::parse("[" + mark.view + "]");
  place.insertItem(0, page);
  item.replaceKey("/Dest", place);
  return item;
}

// Links the items below their parent. `shown` is the number of the items and all their descendants.
void adopt(Handle parent, std::vector<Handle> items, std::size_t shown) {
  if (items.empty()) return;
  for (std::size_t i = 0; i < items.size(); ++i) {
    items[i].replaceKey("/Parent", parent);
    if (i > 0) items[i].replaceKey("/Prev", items[i - 1]);
    if (i + 1 < items.size()) items[i].replaceKey("/Next", items[i + 1]);
  }
  parent.replaceKey("/First", items.front());
  parent.replaceKey("/Last", items.back());
  parent.replaceKey("/Count", Handle::newInteger(static_cast<long long>(shown)));
}

void add_bookmarks(QPDF& pdf, const std::vector<PdfPage>& pages, const std::vector<Handle>& page_objects) {
  Handle outlines = pdf.makeIndirectObject(Handle::newDictionary());
  outlines.replaceKey("/Type", Handle::newName("/Outlines"));
  std::vector<Handle> items;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    items.push_back(bookmark(pdf, pages[i].bookmark, page_objects[i]));
    std::vector<Handle> views;
    for (const PdfBookmark& view : pages[i].views) views.push_back(bookmark(pdf, view, page_objects[i]));
    adopt(items.back(), views, views.size());
    shown += 1 + views.size();
  }
  adopt(outlines, items, shown);
  pdf.getRoot().replaceKey("/Outlines", outlines);
}

void add_information(QPDF& pdf, const PdfDocument& document) {
  Handle information = pdf.makeIndirectObject(Handle::newDictionary());
  const auto add = [&information](const std::string& key, const std::string& text) {
    if (!text.empty()) information.replaceKey(key, Handle::newUnicodeString(valid_utf8(text)));
  };
  add("/Title", document.title);
  add("/Author", document.author);
  add("/Subject", document.subject);
  add("/Producer", "epura");
  pdf.getTrailer().replaceKey("/Info", information);
}

// One place for its name, and the file itself.
Handle add_file(QPDF& pdf, const Attachment& attachment) {
  Handle file = Handle::newStream(&pdf, attachment.bytes);
  file.getDict().replaceKey("/Type", Handle::newName("/EmbeddedFile"));
  file.getDict().replaceKey("/Subtype", Handle::newName("/" + attachment.media_type));
  Handle parameters = Handle::newDictionary();
  parameters.replaceKey("/Size", Handle::newInteger(static_cast<long long>(attachment.bytes.size())));
  file.getDict().replaceKey("/Params", parameters);
  Handle versions = Handle::newDictionary();
  Handle place = pdf.makeIndirectObject(Handle::newDictionary());
  place.replaceKey("/Type", Handle::newName("/Filespec"));
  for (const char* key : {"/F", "/UF"}) {
    place.replaceKey(key, Handle::newUnicodeString(attachment.name));
    versions.replaceKey(key, file);
  }
  place.replaceKey("/EF", versions);
  place.replaceKey("/Desc", Handle::newUnicodeString(attachment.description));
  place.replaceKey("/AFRelationship", Handle::newName("/" + std::string(name_of(attachment.relation))));
  return place;
}

void add_attachments(QPDF& pdf, const std::vector<Attachment>& attachments) {
  if (attachments.empty()) return;
  Handle names = Handle::newArray(), associated = Handle::newArray();
  for (const Attachment& attachment : attachments) {
    Handle place = add_file(pdf, attachment);
    names.appendItem(Handle::newUnicodeString(attachment.name));
    names.appendItem(place);
    associated.appendItem(place);
  }
  Handle files = Handle::newDictionary(), by_kind = Handle::newDictionary();
  files.replaceKey("/Names", names);
  by_kind.replaceKey("/EmbeddedFiles", files);
  pdf.getRoot().replaceKey("/Names", by_kind);
  pdf.getRoot().replaceKey("/AF", associated);
}

std::string bytes_of(QPDF& pdf, bool is_archive) {
  QPDFWriter writer(pdf);
  writer.setNewlineBeforeEndstream(is_archive);  // ISO 19005-3, 6.1.7.1
  writer.setOutputMemory();
  writer.setObjectStreamMode(qpdf_o_generate);
  writer.setDeterministicID(true);
  writer.write();
  expect_all_read(pdf);
  const std::shared_ptr<Buffer> bytes = writer.getBufferSharedPointer();
  return {reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize()};
}

}  // namespace

std::string join_pdf_layers(const PdfDocument& document) {
  QPDF pdf;
  pdf.setSuppressWarnings(true);
  pdf.emptyPDF();
  Groups groups;
  std::vector<Handle> pages;
  for (const PdfPage& page : document.pages) {
    Handle order = groups.order;
    if (document.pages.size() > 1) {
      order = Handle::newArray({Handle::newUnicodeString(valid_utf8(page.bookmark.title))});
      groups.order.appendItem(order);
    }
    pages.push_back(add_layers(pdf, page, groups, order));
  }
  add_optional_content(pdf, groups);
  add_bookmarks(pdf, document.pages, pages);
  add_information(pdf, document);
  add_attachments(pdf, document.attachments);
  if (document.is_archive) {
    add_structure(pdf, document.pages, pages);
    make_archive(pdf, document);
  }
  return bytes_of(pdf, document.is_archive);
}

}  // namespace epura::output
