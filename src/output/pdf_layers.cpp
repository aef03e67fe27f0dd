#include "output/pdf_layers.hpp"

#include <memory>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFWriter.hh>

#include "base/error.hpp"
#include "base/utf8.hpp"

namespace epura {

namespace {

using Handle = QPDFObjectHandle;

// Cairo's page as a form XObject of `pdf`: the stream as it is, still compressed. The page's transparency group stays
// behind; black ink needs none, and some printers answer one with pixels.
Handle add_form(QPDF& pdf, const std::string& file, const std::string& box) {
  QPDF drawn;
  drawn.setImmediateCopyFrom(true);  // `drawn` does not outlive this function
  drawn.processMemoryFile("layer", file.data(), file.size());
  Handle page = drawn.getAllPages().at(0);
  check(page.getKey("/Contents").isStream() && page.getKey("/Resources").isIndirect(), "Cairo wrote another PDF page");
  Handle form = pdf.copyForeignObject(page.getKey("/Contents"));
  form.getDict().replaceKey("/Type", Handle::newName("/XObject"));
  form.getDict().replaceKey("/Subtype", Handle::newName("/Form"));
  form.getDict().replaceKey("/BBox", Handle::parse(box));
  form.getDict().replaceKey("/Resources", pdf.copyForeignObject(page.getKey("/Resources")));
  return form;
}

Handle add_group(QPDF& pdf, const std::string& name) {
  Handle group = pdf.makeIndirectObject(Handle::newDictionary());
  group.replaceKey("/Type", Handle::newName("/OCG"));
  group.replaceKey("/Name", Handle::newUnicodeString(valid_utf8(name)));
  return group;
}

void add_page(QPDF& pdf, const std::string& media_box, Handle resources, const std::string& content) {
  Handle page = pdf.makeIndirectObject(Handle::newDictionary());
  page.replaceKey("/Type", Handle::newName("/Page"));
  page.replaceKey("/MediaBox", Handle::parse(media_box));
  page.replaceKey("/Resources", resources);
  page.replaceKey("/Contents", Handle::newStream(&pdf, content));
  pdf.addPage(page, false);
}

void add_layers(QPDF& pdf, const std::vector<PdfLayer>& layers, const PdfPage& page) {
  Handle groups = Handle::newArray(), forms = Handle::newDictionary(), properties = Handle::newDictionary();
  std::string content = "q\n" + page.placement + " cm\n";
  for (const PdfLayer& layer : layers) {
    const std::string name = "/layer" + std::to_string(groups.getArrayNItems());
    Handle group = add_group(pdf, layer.name);
    groups.appendItem(group);
    properties.replaceKey(name, group);
    forms.replaceKey(name, add_form(pdf, layer.file, page.layer_box));
    content += "/OC " + name + " BDC " + name + " Do EMC\n";
  }
  Handle resources = Handle::newDictionary();
  resources.replaceKey("/XObject", forms);
  resources.replaceKey("/Properties", properties);
  add_page(pdf, page.media_box, resources, content + "Q\n");

  Handle usual = Handle::newDictionary();
  usual.replaceKey("/Order", groups.shallowCopy());
  Handle optional_content = Handle::newDictionary();
  optional_content.replaceKey("/OCGs", groups);
  optional_content.replaceKey("/D", usual);
  pdf.getRoot().replaceKey("/OCProperties", optional_content);
}

}  // namespace

std::string join_pdf_layers(const std::vector<PdfLayer>& layers, const PdfPage& page) {
  QPDF pdf;
  pdf.emptyPDF();
  add_layers(pdf, layers, page);
  Handle information = pdf.makeIndirectObject(Handle::newDictionary());
  information.replaceKey("/Title", Handle::newUnicodeString(valid_utf8(page.title)));
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
