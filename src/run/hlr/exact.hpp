// SPDX-License-Identifier: Apache-2.0
// Facets divided until they follow the exact surfaces and edges that call-backs of the calling program evaluate.
#pragma once

#include <epura/hlr.h>

#include "importer/document.hpp"

namespace epura::hlr {

/// Divides facets of faces that are not planes, and the pieces of their edges. Where two of them meet without an edge,
/// the first one counts. Throws Error{input} for functions that fail or answer wrongly.
void follow_surfaces(importer::Document& document, const epura_hlr_exact& exact);

}  // namespace epura::hlr
