#include "output/pdf/contents.hpp"

#include <charconv>
#include <exception>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>

#include "base/error.hpp"

namespace epura {

namespace {

using Handle = QPDFObjectHandle;

// qpdf's own numbers follow the locale.
double number_of(Handle object) {
  const std::string text = object.isInteger() ? std::to_string(object.getIntValue()) : object.getRealValue();
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

class Operations : public Handle::ParserCallbacks {
 public:
  void handleObject(Handle object) override {
    if (object.isOperator()) {
      next_.name = object.getOperatorValue();
      all.push_back(std::move(next_));
      next_ = {};
    } else {
      add(object);
    }
  }
  void handleEOF() override {}

  std::vector<PdfOperation> all;

 private:
  void add(Handle object) {
    if (object.isNumber()) next_.numbers.push_back(number_of(object));
    if (object.isName()) next_.words.push_back(object.getName());
    if (object.isArray())
      for (int i = 0; i < object.getArrayNItems(); ++i) add(object.getArrayItem(i));
  }

  PdfOperation next_;
};

std::vector<PdfOperation> operations_of_page(Handle page) {
  Operations operations;
  page.parsePageContents(&operations);
  return std::move(operations.all);
}

std::vector<PdfOperation> operations_of_form(Handle form) {
  Operations operations;
  form.parseAsContents(&operations);
  return std::move(operations.all);
}

PdfContent content_of(Handle page) {
  PdfContent content;
  Handle box = page.getKey("/MediaBox");
  content.width = number_of(box.getArrayItem(2)) - number_of(box.getArrayItem(0));
  content.height = number_of(box.getArrayItem(3)) - number_of(box.getArrayItem(1));
  content.operations = operations_of_page(page);
  Handle resources = page.getKey("/Resources");
  Handle layers = resources.getKey("/Properties"), forms = resources.getKey("/XObject");
  for (const std::string& name : layers.getKeys())
    content.layers[name] = layers.getKey(name).getKey("/Name").getUTF8Value();
  for (const std::string& name : forms.getKeys()) content.forms[name] = operations_of_form(forms.getKey(name));
  return content;
}

}  // namespace

std::vector<PdfContent> read_pdf_contents(const std::string& bytes, const std::string& where) {
  std::vector<PdfContent> pages;
  try {
    QPDF pdf;
    pdf.setSuppressWarnings(true);
    pdf.processMemoryFile(where.c_str(), bytes.data(), bytes.size());
    Handle information = pdf.getTrailer().getKey("/Info");
    const bool ours = information.isDictionary() && information.getKey("/Producer").isString() &&
                      information.getKey("/Producer").getUTF8Value() == "epura";
    if (!ours)
      throw Error(Trouble::input, where, "was not written by epura", "epura compares PDF files that it wrote itself");
    for (Handle page : pdf.getAllPages()) pages.push_back(content_of(page));
  } catch (const Error&) {
    throw;
  } catch (const std::exception& trouble) {
    throw Error(Trouble::input, where, std::string("is no PDF that can be read: ") + trouble.what());
  }
  return pages;
}

}  // namespace epura
