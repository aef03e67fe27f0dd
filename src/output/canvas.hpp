// SPDX-License-Identifier: Apache-2.0
// Common parts of all Cairo writers: surfaces that close themselves, and sheets drawn on them.
//
// Cairo stores the points of a path in 1/256 of a surface unit with 23 bits before the point. Vector files are
// therefore drawn much enlarged and scaled back once, when the layers are assembled.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>

#include "base/progress.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// How a surface lies on the sheet. Surfaces have y down.
struct Canvas {
  double units;  ///< of the surface per millimetre
  Vec2 origin;   ///< upper left corner of the surface on the sheet, mm
  Vec2 size;     ///< of the surface in its units, whole numbers: Cairo rounds heights up without a word

  [[nodiscard]] Vec2 to_surface(const Vec2& p) const { return {(p.x - origin.x) * units, (origin.y - p.y) * units}; }
  [[nodiscard]] Vec2 to_sheet(const Vec2& p) const { return {origin.x + p.x / units, origin.y - p.y / units}; }
};

/// Holds the sheet and all ink: Cairo drops what lies entirely outside a surface. 1000 units per millimetre, fewer
/// where the ink is more than 8 m long or letters are more than 40 mm high.
Canvas enlarged_canvas(const sheet::Sheet& sheet);

/// Frees with a function of Cairo's.
template <auto function>
struct Free {
  template <class Thing>
  void operator()(Thing* thing) const {
    function(thing);
  }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, Free<cairo_surface_destroy>>;
using Pen = std::unique_ptr<cairo_t, Free<cairo_destroy>>;

/// Black, round ends and joins.
Pen make_pen(const CairoSurface& surface);

/// What keeps vector files of many strokes fast. Cairo unites the boxes of all strokes drawn so far, so the first one
/// reaches over the whole surface, without ink: PDF and PostScript drop it. And Cairo rounds each line's ends to find
/// its box, which need not be fine.
void begin_vector_file(const Pen& pen, const Canvas& canvas);

/// For all that is drawn from now on.
void set_colour(const Pen& pen, const Colour& colour);

/// Adds a stroke to the current path as a separate subpath.
void add_path(const Pen& pen, const Canvas& canvas, const sheet::Stroke& stroke);

/// Draws every stroke of a layer for itself. Throws OutOfTime.
void draw(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer, const Progress& progress);

/// For Cairo's streams: appends to the std::string `bytes`.
cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned length);

/// Throws Error{output} if Cairo reports an error.
void require(cairo_status_t status, const char* format);

/// Ends the page and the file, and checks for errors in everything before.
void finish(const CairoSurface& surface, const char* format);

}  // namespace epura::output
