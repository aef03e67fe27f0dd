// SPDX-License-Identifier: Apache-2.0
#include "output/cairo/library.hpp"

// The program finds the library's functions by this name.
extern "C" {
__attribute__((visibility("default"))) extern const epura::output::CairoLibrary epura_cairo_library;
const epura::output::CairoLibrary epura_cairo_library{&epura::output::make_pdf_layers, &epura::output::make_ps,
                                                      &epura::output::make_eps, &epura::output::make_png};
}
