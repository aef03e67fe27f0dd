// SPDX-License-Identifier: Apache-2.0
#include "base/error.hpp"
#include "base/shared_library.hpp"
#include "output/pdf/library.hpp"

namespace epura::output {

const PdfLibrary& pdf_library() {
  const std::filesystem::path path = own_folder() / EPURA_PDF_LIBRARY;
  try {
    const void* library = find_symbol(load_library(path, ErrorKind::output), "epura_pdf_library");
    if (library == nullptr) throw Error(ErrorKind::output, "", "is a different library");
    return *static_cast<const PdfLibrary*>(library);
  } catch (const Error& error) {
    throw Error(error.kind(), path.string(), error.what(), "epura needs it for PDF files: reinstall epura");
  }
}

}  // namespace epura::output
