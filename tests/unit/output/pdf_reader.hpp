// SPDX-License-Identifier: Apache-2.0
// Objects of a PDF file, read with qpdf. Through its C interface, whose header every compiler reads as C++20.
#pragma once

#include <qpdf/qpdf-c.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace epura {

class PdfObject {
 public:
  PdfObject(qpdf_data pdf, qpdf_oh object) : pdf_(pdf), object_(object) {}

  PdfObject operator[](const char* key) const { return {pdf_, qpdf_oh_get_key(pdf_, dictionary(), key)}; }
  PdfObject operator[](int index) const { return {pdf_, qpdf_oh_get_array_item(pdf_, object_, index)}; }
  [[nodiscard]] bool has(const char* key) const { return qpdf_oh_has_key(pdf_, dictionary(), key) != 0; }
  [[nodiscard]] bool is_dictionary() const { return qpdf_oh_is_dictionary(pdf_, object_) != 0; }
  [[nodiscard]] int size() const { return qpdf_oh_get_array_n_items(pdf_, object_); }
  [[nodiscard]] double number() const { return qpdf_oh_get_numeric_value(pdf_, object_); }
  [[nodiscard]] std::string name() const { return qpdf_oh_get_name(pdf_, object_); }
  [[nodiscard]] std::string text() const { return qpdf_oh_get_utf8_value(pdf_, object_); }
  [[nodiscard]] std::string stream() const {
    unsigned char* data = nullptr;
    std::size_t length = 0;
    qpdf_oh_get_stream_data(pdf_, object_, qpdf_dl_all, nullptr, &data, &length);
    std::string bytes(reinterpret_cast<const char*>(data), length);
    std::free(data);
    return bytes;
  }

 private:
  [[nodiscard]] qpdf_oh dictionary() const {
    return qpdf_oh_is_stream(pdf_, object_) ? qpdf_oh_get_dict(pdf_, object_) : object_;
  }

  qpdf_data pdf_;
  qpdf_oh object_;
};

class PdfReader {
 public:
  /// `bytes` has to stay.
  explicit PdfReader(const std::string& bytes) : pdf_(qpdf_init()) {
    qpdf_read_memory(pdf_, "test", bytes.data(), bytes.size(), nullptr);
  }
  PdfReader(const PdfReader&) = delete;
  PdfReader& operator=(const PdfReader&) = delete;
  ~PdfReader() { qpdf_cleanup(&pdf_); }

  [[nodiscard]] PdfObject root() const { return {pdf_, qpdf_get_root(pdf_)}; }
  [[nodiscard]] PdfObject trailer() const { return {pdf_, qpdf_get_trailer(pdf_)}; }
  [[nodiscard]] PdfObject page(std::size_t number = 0) const { return {pdf_, qpdf_get_page_n(pdf_, number)}; }
  [[nodiscard]] int pages() const { return qpdf_get_num_pages(pdf_); }
  [[nodiscard]] bool has_trouble() const { return qpdf_has_error(pdf_) || qpdf_more_warnings(pdf_); }

 private:
  qpdf_data pdf_;
};

}  // namespace epura
