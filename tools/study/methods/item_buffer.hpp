// SPDX-License-Identifier: Apache-2.0
// Visibility by an item buffer [Weghorst, Hooper, Greenberg. Improved computational methods for ray tracing. ACM TOG
// 1984; for lines: Saito, Takahashi. Comprehensible rendering of 3-D shapes. SIGGRAPH 1990].
//
// The triangles are rasterised with a depth buffer of doubles: each pixel stores the nearest triangle at its centre.
// Along an edge, one pixel per column (per row if the edge is steep) is tested. The edge is visible in that pixel if
// the pixel is empty, or has one of the edge's own faces or a face whose plane is not in front of the edge there.
// Therefore ends of spans are off by about a pixel, and faces that cover no pixel centre hide nothing.
#pragma once

#include "visibility/visibility.hpp"

namespace epura::study {

/// `density`: pixels per view unit. The buffer is created and used tile by tile, so memory does not grow with it.
visibility::HiddenSpans find_hidden_by_item_buffer(const world::World& world, const view::ProjectedScene& view,
                                                   const edges::FeatureEdges& drawn, double density,
                                                   Progress progress = {});

}  // namespace epura::study
