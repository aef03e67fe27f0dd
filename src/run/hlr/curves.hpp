// SPDX-License-Identifier: Apache-2.0
// Lines of a drawing as curves of one source each.
#pragma once

#include <epura/hlr.h>

#include <vector>

#include "drawing/view_drawing.hpp"
#include "hlr/model.hpp"

namespace epura::hlr {

struct Curves {
  std::vector<epura_hlr_curve> curves{};
  std::vector<double> points{};  ///< two numbers each
};

/// `scale` is the length on paper of a unit of the result.
Curves curves_of(const Model& model, const drawing::ViewDrawing& drawing, double scale);

/// The kind of lines with its number in hlr.h.
constexpr std::uint32_t number_of(EdgeKind kind) { return 1U << static_cast<unsigned>(kind); }

}  // namespace epura::hlr
