// SPDX-License-Identifier: Apache-2.0
// An independent judge of visibility: brute force in rational numbers over the doubles of the input and of the matrix.
// It shares nothing with the program but the mesh. Three answers: hidden, visible, or undecided where moving an
// occluder by a billionth of the drawing, or by twice the contact tolerance in depth, changes the answer.
#pragma once

#include <array>
#include <string>

#include "shapes.hpp"

namespace epura::test {

struct Verdict {
  double longest_wrong = 0;  ///< longest connected span shown hidden that is visible or the other way, in drawings
  double wrong = 0;          ///< total of such spans
  double undecided = 0;
  double judged = 0;  ///< total length of all edges
  std::string worst;  ///< the longest wrong span in words
};

Verdict judge(const Result& result);

/// A triangle and a point of an edge, exactly as their places on the page say.
struct PointTruth {
  double inside;     ///< how far the point lies from the nearest side; negative outside
  double ahead;      ///< how far the plane of the triangle lies before it
  double steepness;  ///< of that plane, 1 square to the view
};

PointTruth truth_of_point(const std::array<PageVertex, 3>& triangle, const std::array<PageVertex, 2>& edge, double s);

}  // namespace epura::test
