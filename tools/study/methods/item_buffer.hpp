// SPDX-License-Identifier: Apache-2.0
// Visibility by an item buffer [Weghorst, Hooper, Greenberg. Improved computational methods for ray tracing. ACM TOG
// 1984; for lines: Saito, Takahashi. Comprehensible rendering of 3-D shapes. SIGGRAPH 1990].
//
// The triangles are rasterised with a depth buffer of doubles: each pixel holds the nearest triangle at its middle.
// Along an edge, one pixel a column (a row, where it is steep) says what is seen there. The edge is visible in that
// pixel if it holds nothing, one of the edge's own faces, or a face whose plane does not lie before the edge there. So
// ends of spans are off by about a pixel, and faces that no pixel's middle meets hide nothing.
#pragma once

#include "visibility/visibility.hpp"

namespace epura::study {

/// `density`: pixels per view unit. The buffer is made and used tile by tile, so that memory does not grow with it.
visibility::HiddenSpans find_hidden_by_item_buffer(const scene::World& world, const view::ProjectedScene& view,
                                                   const edges::FeatureEdges& drawn, double density,
                                                   Progress progress = {});

}  // namespace epura::study
