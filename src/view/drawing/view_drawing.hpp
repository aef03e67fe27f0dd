// SPDX-License-Identifier: Apache-2.0
// For headers that only name a drawing (drawing/drawing.hpp).
#pragma once

namespace epura::drawing {

struct ViewDrawing;

}  // namespace epura::drawing
