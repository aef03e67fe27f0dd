// SPDX-License-Identifier: Apache-2.0
// What makes a PDF file one for archives and for people who do not see it: PDF/A-3b (ISO 19005-3) and PDF/UA-1 (ISO
// 14289-1).
#pragma once

#include <cstddef>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <string>
#include <vector>

#include "output/pdf/layers.hpp"

namespace epura::output {

/// The content stream of a layer, drawn by Cairo, whose marks get their elements and their numbers on the page, from
/// `first` on, which is moved on; what belongs to no element becomes an artifact.
std::string with_marks(const std::string& content, const PdfTags& tags, std::size_t layer, int& first);

/// Pictures and fonts as archives want them, in the resources of a page.
void make_resources_archivable(QPDFObjectHandle resources);

/// Adds the logical structure of all pages, with marks numbered as above, layer by layer.
void add_structure(QPDF& pdf, const std::vector<PdfPage>& pages, const std::vector<QPDFObjectHandle>& page_objects);

/// Adds what holds for the document: metadata, language, the colours that are meant.
void make_archive(QPDF& pdf, const PdfDocument& document);

/// An ICC profile of sRGB.
std::string srgb_profile();

}  // namespace epura::output
