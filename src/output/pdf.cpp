// PDF: Cairo draws each layer, qpdf joins them as optional content (ISO 32000-1, 8.11) on one page.
#include <cairo-pdf.h>

#include <cstddef>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFWriter.hh>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/canvas.hpp"
#include "output/utf8.hpp"
#include "output/write.hpp"

namespace epura {

namespace {

using Handle = QPDFObjectHandle;

constexpr double points_per_millimetre = 72 / 25.4;

// PDF knows no exponents.
std::string real(double value) { return format_fixed(value, 15); }

std::string cairo_pdf(const Canvas& canvas, const Layer& layer) {
  std::string bytes;
  const CairoSurface surface(cairo_pdf_surface_create_for_stream(append_bytes, &bytes, canvas.size.x, canvas.size.y));
  {
    const Pen pen = make_pen(surface);
    begin_vector_file(pen, canvas);
    draw(pen, canvas, layer);
  }
  finish(surface, "PDF");
  return bytes;
}

Handle rectangle(const Vec2& size) {
  Handle box = Handle::newArray();
  for (const double side : {0.0, 0.0, size.x, size.y}) box.appendItem(Handle::newReal(real(side)));
  return box;
}

// Cairo's page as a form XObject of `pdf`: the stream as it is, still compressed. The page's transparency group stays
// behind; black ink needs none, and some printers answer one with pixels.
Handle add_form(QPDF& pdf, const Canvas& canvas, const std::string& bytes) {
  QPDF drawn;
  drawn.setImmediateCopyFrom(true);  // `drawn` does not outlive this function
  drawn.processMemoryFile("layer", bytes.data(), bytes.size());
  Handle page = drawn.getAllPages().at(0);
  check(page.getKey("/Contents").isStream() && page.getKey("/Resources").isIndirect(), "Cairo wrote another PDF page");
  Handle form = pdf.copyForeignObject(page.getKey("/Contents"));
  form.getDict().replaceKey("/Type", Handle::newName("/XObject"));
  form.getDict().replaceKey("/Subtype", Handle::newName("/Form"));
  form.getDict().replaceKey("/BBox", rectangle(canvas.size));
  form.getDict().replaceKey("/Resources", pdf.copyForeignObject(page.getKey("/Resources")));
  return form;
}

Handle add_group(QPDF& pdf, const std::string& name) {
  Handle group = pdf.makeIndirectObject(Handle::newDictionary());
  group.replaceKey("/Type", Handle::newName("/OCG"));
  group.replaceKey("/Name", Handle::newUnicodeString(valid_utf8(name)));
  return group;
}

// From the surface, seen with y up as PDF does, to points on the page.
std::string placement(const Canvas& canvas) {
  const std::string scale = real(points_per_millimetre / canvas.units);
  const Vec2 corner = canvas.to_sheet({0, canvas.size.y}) * points_per_millimetre;
  return scale + " 0 0 " + scale + " " + real(corner.x) + " " + real(corner.y) + " cm\n";
}

void add_page(QPDF& pdf, const Sheet& sheet, Handle resources, const std::string& content) {
  Handle page = pdf.makeIndirectObject(Handle::newDictionary());
  page.replaceKey("/Type", Handle::newName("/Page"));
  page.replaceKey("/MediaBox", rectangle(Vec2(sheet.width, sheet.height) * points_per_millimetre));
  page.replaceKey("/Resources", resources);
  page.replaceKey("/Contents", Handle::newStream(&pdf, content));
  pdf.addPage(page, false);
}

void add_layers(QPDF& pdf, const Sheet& sheet) {
  const Canvas canvas = enlarged_canvas(sheet);
  Handle groups = Handle::newArray(), forms = Handle::newDictionary(), properties = Handle::newDictionary();
  std::string content = "q\n" + placement(canvas);
  for (const Layer& layer : sheet.layers) {
    const std::string name = "/layer" + std::to_string(groups.getArrayNItems());
    Handle group = add_group(pdf, layer.name);
    groups.appendItem(group);
    properties.replaceKey(name, group);
    forms.replaceKey(name, add_form(pdf, canvas, cairo_pdf(canvas, layer)));
    content += "/OC " + name + " BDC " + name + " Do EMC\n";
  }
  Handle resources = Handle::newDictionary();
  resources.replaceKey("/XObject", forms);
  resources.replaceKey("/Properties", properties);
  add_page(pdf, sheet, resources, content + "Q\n");

  Handle usual = Handle::newDictionary();
  usual.replaceKey("/Order", groups.shallowCopy());
  Handle optional_content = Handle::newDictionary();
  optional_content.replaceKey("/OCGs", groups);
  optional_content.replaceKey("/D", usual);
  pdf.getRoot().replaceKey("/OCProperties", optional_content);
}

}  // namespace

std::string to_pdf(const Sheet& sheet) {
  QPDF pdf;
  pdf.emptyPDF();
  add_layers(pdf, sheet);
  Handle information = pdf.makeIndirectObject(Handle::newDictionary());
  information.replaceKey("/Title", Handle::newUnicodeString(valid_utf8(sheet.title)));
  information.replaceKey("/Producer", Handle::newString("epura"));
  pdf.getTrailer().replaceKey("/Info", information);

  QPDFWriter writer(pdf);
  writer.setOutputMemory();
  writer.setObjectStreamMode(qpdf_o_generate);
  writer.setDeterministicID(true);
  writer.write();
  const std::shared_ptr<Buffer> bytes = writer.getBufferSharedPointer();
  return {reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize()};
}

}  // namespace epura
