// SPDX-License-Identifier: Apache-2.0
// Lines of a drawing as curves of one source each.
#pragma once

#include <epura/hlr.h>

#include <map>
#include <vector>

#include "drawing/view_drawing.hpp"
#include "hlr/model.hpp"

namespace epura::hlr {

/// The picture of a spline, and what it refers to.
struct PlaneSpline {
  epura_hlr_spline told;
  std::vector<double> poles, weights, knots;
};

struct Curves {
  std::vector<epura_hlr_curve> curves{};
  std::vector<double> points{};          ///< two numbers each
  std::map<int, PlaneSpline> splines{};  ///< by their numbers in the model
};

/// `scale` is the length on paper of a unit of the result; see epura_hlr_request::all_types.
Curves curves_of(const Model& model, const drawing::ViewDrawing& drawing, double scale, bool all_types);

/// The kind of lines with its number in hlr.h.
constexpr std::uint32_t number_of(EdgeKind kind) { return 1U << static_cast<unsigned>(kind); }

}  // namespace epura::hlr
