// SPDX-License-Identifier: Apache-2.0
// Common parts of all Cairo writers: surfaces that close themselves, and sheets drawn on them.
//
// Cairo stores the points of a path in 1/256 of a surface unit with 23 integer bits. Vector files are therefore drawn
// greatly enlarged and scaled back once, when the layers are assembled.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>

#include "base/progress.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

inline constexpr double points_per_millimetre = 72 / 25.4;

/// Position of a surface on the sheet. Surfaces have y down.
struct Canvas {
  double units;  ///< surface units per millimetre
  Vec2 origin;   ///< upper left corner of the surface on the sheet, mm
  Vec2 size;     ///< of the surface in its units, integers: Cairo silently rounds heights up

  [[nodiscard]] Vec2 to_surface(const Vec2& p) const { return {(p.x - origin.x) * units, (origin.y - p.y) * units}; }
  [[nodiscard]] Vec2 to_sheet(const Vec2& p) const { return {origin.x + p.x / units, origin.y - p.y / units}; }
};

/// Includes the sheet and all ink: Cairo drops objects entirely outside a surface. 1000 units per millimetre, fewer if
/// the ink is more than 8 m long or letters are more than 40 mm high.
Canvas enlarged_canvas(const sheet::Sheet& sheet);

/// Frees with a Cairo function.
template <auto function>
struct Free {
  template <class Thing>
  void operator()(Thing* thing) const {
    function(thing);
  }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, Free<cairo_surface_destroy>>;
using Pen = std::unique_ptr<cairo_t, Free<cairo_destroy>>;

/// Black, with round ends and joins.
Pen make_pen(const CairoSurface& surface);

/// Keeps vector files of many strokes fast. Cairo unites the boxes of all strokes drawn so far, so the first one
/// extends over the whole surface, without ink: PDF and PostScript drop it. Also, Cairo approximates each line's round
/// ends to find its box, which need not be precise.
void begin_vector_file(const Pen& pen, const Canvas& canvas);

/// Applies to everything drawn from now on.
void set_colour(const Pen& pen, const Colour& colour);

/// Draws the pictures of a layer.
void draw_pictures(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer);

/// Adds a stroke to the current path as a separate subpath.
void add_path(const Pen& pen, const Canvas& canvas, const sheet::Stroke& stroke);

/// Draws every stroke of a layer separately. Throws OutOfTime.
void draw(const Pen& pen, const Canvas& canvas, const sheet::Layer& layer, const Progress& progress);

/// For Cairo's streams: appends to the std::string `bytes`.
cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned length);

/// Throws Error{output} if Cairo reports an error.
void require(cairo_status_t status, const char* format);

/// Ends the page and the file, and checks for errors in everything up to this point.
void finish(const CairoSurface& surface, const char* format);

}  // namespace epura::output
