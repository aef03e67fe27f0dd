// SPDX-License-Identifier: Apache-2.0
// Unpacks PDF streams and checks their size first. Flate can expand a byte to a thousand, filters can be chained, and a
// predictor may request any amount of memory, so a small file may stand for more than fits into memory.
#pragma once

#include <cstddef>
#include <memory>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <string>

namespace epura::output {

/// The number of bytes to which a file may still unpack.
class UnpackRoom {
 public:
  UnpackRoom(std::size_t bytes, std::string where) : where_(std::move(where)), max_(bytes), left_(bytes) {}

  /// The data of a stream. Throws Error{input} if it is too large or cannot be unpacked.
  std::string unpack(QPDFObjectHandle stream);
  /// Checks Flate data at position `at` of a file in the same way.
  void measure(const std::string& file, std::size_t at);

 private:
  [[noreturn]] void refuse() const;

  std::string where_;
  std::size_t max_, left_;
};

/// Checks the bytes of a whole file. Throws Error{input} unless its streams are packed as epura packs them: not at all
/// or by Flate once, tables with predictors of short rows, and nothing encrypted; and unless its tables of objects are
/// small, since qpdf reads them before anything else.
void check_packing(const std::string& file, const std::string& where);

/// Throws Error{input} unless the streams that contain objects are small. The file must be open, with no objects read
/// yet.
void check_object_streams(QPDF& pdf, std::size_t bytes, const std::string& where);

}  // namespace epura::output
