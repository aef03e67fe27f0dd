// SPDX-License-Identifier: Apache-2.0
// Points, loops in space and outlines in a plane: what solids are made from. Millimetres and degrees.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace samples {

using Point = std::array<double, 3>;
using Loop = std::vector<Point>;  ///< a closed polygon in space; the last point is not repeated
using Point2 = std::array<double, 2>;
using Outline = std::vector<Point2>;  ///< a closed polygon in a plane, counter-clockwise

/// A place for an outline in space: `u` and `v` are its axes, unit vectors at right angles.
struct Frame {
  Point origin;
  Point u;
  Point v;
};

// Frames that look along an axis of the world; outlines in them run counter-clockwise seen from that side.
inline Frame seen_from_top(const Point& origin) { return {origin, {1, 0, 0}, {0, 1, 0}}; }
inline Frame seen_from_front(const Point& origin) { return {origin, {1, 0, 0}, {0, 0, 1}}; }
inline Frame seen_from_right(const Point& origin) { return {origin, {0, 1, 0}, {0, 0, 1}}; }
inline Frame seen_from_back(const Point& origin) { return {origin, {-1, 0, 0}, {0, 0, 1}}; }
inline Frame seen_from_left(const Point& origin) { return {origin, {0, -1, 0}, {0, 0, 1}}; }

Point operator+(const Point& a, const Point& b);
Point operator-(const Point& a, const Point& b);
Point operator*(double s, const Point& a);
double dot(const Point& a, const Point& b);
Point cross(const Point& a, const Point& b);

/// Twice the vector area of a polygon: its normal, as long as twice the area.
Point area_vector(std::span<const Point> polygon);

/// Whether all corners lie in one plane, up to what rounding the coordinates leaves of it.
bool is_planar(const Loop& corners);

Loop place(const Outline& outline, const Frame& frame);
Loop shifted(Loop loop, const Point& step);
Loop reversed(Loop loop);

Outline rectangle(double x0, double y0, double x1, double y1);
Outline circle(double radius, int segments, const Point2& centre = {0, 0});
/// Points from one angle to another, both included.
Outline arc(const Point2& centre, double radius, double from, double to, int segments);
/// `count` circles with their centres on a circle, the first of them at `angle`.
std::vector<Outline> bolt_circle(int count, double pitch_radius, double radius, int segments, double angle = 0);
/// The circle about the origin of a frame.
Loop ring(const Frame& frame, double radius, int segments);

double cos_deg(double angle);
double sin_deg(double angle);

}  // namespace samples
