// SPDX-License-Identifier: Apache-2.0
#include "sheet/arrangement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "base/error.hpp"
#include "sheet/arranger.hpp"
#include "sheet/standard_scale.hpp"

namespace epura::sheet {

namespace {

using Spots = std::vector<ViewSpot>;

// Least size of pictorial views relative to the others; `min_share` applies if the others would lose too much
// otherwise.
constexpr double good_share = 0.4, min_share = 0.1;
// 2^14: more than ten thousand times smaller than what would fit with nothing in the way.
constexpr int max_halvings = 14;
constexpr double rounding = 1e-9;
// Views are not aligned beside others if the rest could be more than this larger.
constexpr double cost_of_alignment = 1.9;

// Returns the largest scale at which `fits` holds, if it holds at some scale that is not much less than `max`.
std::optional<double> largest_that(double max, bool standard, const std::function<bool(double)>& fits) {
  // What stands around the views, such as their dimensions, may leave no room at any scale.
  if (!(max > 0)) return std::nullopt;
  double fitting = standard ? standard_scale_up_to(max) : max;
  double too_large = fitting;
  for (int i = 0; !fits(fitting); ++i) {
    if (i == max_halvings) return std::nullopt;
    too_large = fitting;
    fitting = standard ? standard_scale_up_to(fitting * 0.99) : fitting / 2;
  }
  while (!standard && too_large > fitting * (1 + rounding)) {
    const double middle = (fitting + too_large) / 2;
    (fits(middle) ? fitting : too_large) = middle;
  }
  check(fitting > 0 && fitting <= max * (1 + rounding), "a scale that fits is not larger than the largest");
  return fitting;
}

struct Found {
  double scale;
  Spots spots;
  double largest = 0;  ///< scale that would fit with smaller pictorial views
};

std::optional<Found> at_fixed_scale(const Arranger& arranger, double scale) {
  auto spots = arranger.arranged(scale, min_share);
  if (!spots) return std::nullopt;
  return Found{scale, arranger.balanced(*spots)};
}

// `otherwise` is the scale to use if no view depends on the scale.
std::optional<Found> at_free_scale(const Arranger& arranger, bool standard, double otherwise) {
  double max = arranger.largest_scale();
  if (!std::isfinite(max)) max = otherwise;
  std::optional<Found> found;
  for (const double share : {min_share, good_share}) {
    const auto fits = [&](double scale) { return arranger.arranged(scale, share).has_value(); };
    const auto scale = largest_that(max, standard, fits);
    if (!scale || (found && *scale < good_share * found->scale)) break;
    found = Found{*scale, *arranger.arranged(*scale, share), found ? found->largest : *scale};
  }
  if (found) found->spots = arranger.balanced(found->spots);
  return found;
}

struct Question {
  std::span<const ViewToPlace> views;
  scene::ScaleChoice choice;
  ProjectionAngle angle;
  DrawingRoom room;
};

// The scale to report if no view depends on it.
double scale_of_first(const Question& question) { return question.views.front().scale.value_or(1); }

std::optional<Found> find(const Question& question, const Arranger& arranger) {
  if (question.choice.fixed) return at_fixed_scale(arranger, *question.choice.fixed);
  return at_free_scale(arranger, question.choice.standard, scale_of_first(question));
}

ArrangerRoom room_on(const Paper& paper, const DrawingRoom& room) {
  const Rectangle area = drawing_area(paper).grown(-room.clearance);
  ArrangerRoom arranger{area, {}, std::min(room.gap, std::min(area.size().x, area.size().y) / 10), room.clearance};
  if (room.title_block) arranger.taken.push_back(room.title_block->grown(room.clearance));
  return arranger;
}

// The first choice of gaps at which the views fit; of standard scales, the one with the largest scale.
std::optional<Found> find_on(const Question& question, const Paper& paper) {
  const ArrangerRoom room = room_on(paper, question.room);
  if (!(room.area.size().x > 0 && room.area.size().y > 0)) return std::nullopt;
  std::optional<Found> best;
  const auto try_with = [&](double part_of_gap, bool watch_given) {
    ArrangerRoom tried = room;
    tried.gap *= part_of_gap;
    tried.watch_given = watch_given;
    const Arranger aligned(question.views, question.angle, tried);
    auto found = find(question, aligned);
    if (aligned.has_aligned()) {
      tried.aligns = false;
      auto loose = find(question, Arranger(question.views, question.angle, tried));
      if (loose && (!found || loose->scale > cost_of_alignment * found->scale)) found = std::move(loose);
    }
    if (found && (!best || found->scale > best->scale * (1 + rounding))) best = std::move(found);
  };
  for (const double part_of_gap : {1.0, 0.25})
    if (!best || question.choice.standard) try_with(part_of_gap, true);
  if (!best) try_with(0.25, false);
  return best;
}

Found overflow(const Question& question, const Paper& paper) {
  const Arranger arranger(question.views, question.angle, room_on(paper, question.room));
  const double max = arranger.largest_scale();
  const double scale = question.choice.fixed.value_or(std::isfinite(max) && max > 0 ? max : scale_of_first(question));
  return {scale, arranger.overflowing(scale)};
}

bool all_inside(const Spots& spots, const Question& question, const Paper& paper) {
  const Rectangle area = drawing_area(paper);
  const double slack = rounding * std::max(paper.width, paper.height);
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (!area.holds(spots[i].box, slack)) return false;
    if (question.room.title_block && spots[i].box.overlaps(*question.room.title_block, slack)) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (spots[i].box.overlaps(spots[j].box, slack)) return false;
  }
  return true;
}

Rectangle box_of_views(const Spots& spots) {
  Rectangle box = spots.front().box;
  for (const ViewSpot& spot : spots) box = united(box, spot.box);
  return box;
}

bool is_on_paper(const Spots& spots, const Paper& paper) {
  const Rectangle all{{0, 0}, {paper.width, paper.height}};
  return std::all_of(spots.begin(), spots.end(), [&](const ViewSpot& spot) { return all.holds(spot.box, rounding); });
}

std::optional<double> scale_that_fits(Question question, const Paper& paper) {
  question.choice = {std::nullopt, true};
  const auto found = find_on(question, paper);
  return found ? std::optional(found->scale) : std::nullopt;
}

Arrangement moved_to_paper(const Question& question) {
  const Paper& paper = question.room.paper;
  auto found = find_on(question, paper);
  const bool has_room = found.has_value();
  if (!has_room) found = overflow(question, paper);
  check_drawing_size(box_of_views(found->spots).size());
  Arrangement arrangement{paper, found->scale, found->spots, all_inside(found->spots, question, paper)};
  if (question.choice.standard && found->largest > found->scale) arrangement.fitting = found->largest;
  arrangement.crowded = arrangement.inside && !has_room && question.choice.fixed;
  if (arrangement.inside && !arrangement.crowded) return arrangement;
  arrangement.on_paper = is_on_paper(arrangement.views, paper);
  arrangement.fitting = scale_that_fits(question, paper);
  return arrangement;
}

// Arranges the views on A4, or on a larger sheet of that shape if the scale is given, and then cuts the paper to size.
Arrangement on_cut_paper(Question question) {
  const Paper margins = question.room.paper;
  Paper trial = make_paper({}, false);
  question.room.title_block.reset();
  auto found = find_on(question, trial);
  for (; !found && question.choice.fixed && trial.width < 2 * scene::longest_side; trial.width *= 2, trial.height *= 2)
    found = find_on(question, trial);
  if (!found) found = overflow(question, trial);
  const Rectangle box = box_of_views(found->spots);
  check_drawing_size(box.size());
  const bool given = std::any_of(question.views.begin(), question.views.end(), [](const auto& v) { return v.at; });
  const Vec2 corner = Vec2(margins.left, margins.above()) + question.room.clearance;
  const Vec2 move = given ? Vec2(0, 0) : corner - box.min;
  Arrangement arrangement{margins, found->scale, found->spots, true};
  for (ViewSpot& spot : arrangement.views) spot = moved(spot, move);
  const Vec2 max = box.max + move + question.room.clearance;
  arrangement.paper.width = max.x + margins.other;
  arrangement.paper.height = max.y + margins.above();
  arrangement.inside = all_inside(arrangement.views, question, arrangement.paper);
  return arrangement;
}

bool stands_alone(const Question& question) {
  const ViewToPlace& view = question.views.front();
  return question.views.size() == 1 && !view.at && !question.room.title_block && question.room.clearance == 0 &&
         view.before == Vec2(0, 0) && view.after == Vec2(0, 0);
}

Arrangement alone(const Question& question) {
  const projection::Window& box = question.views.front().box;
  const Paper& paper = question.room.paper;
  std::optional<double> scale = question.choice.fixed;
  if (!scale && question.choice.standard)
    scale = standard_scale_up_to(place_ink(box.min, box.max, std::nullopt, paper).scale);
  const Placement placed = place_ink(box.min, box.max, scale, paper);
  const Rectangle ink{placed.scale * box.min + placed.shift, placed.scale * box.max + placed.shift};
  Arrangement arrangement{placed.paper, placed.scale, {{0, placed.scale, placed.shift, ink}}, placed.inside};
  if (arrangement.inside) return arrangement;
  arrangement.on_paper = is_on_paper(arrangement.views, placed.paper);
  arrangement.fitting = standard_scale_up_to(place_ink(box.min, box.max, std::nullopt, paper).scale);
  return arrangement;
}

}  // namespace

ViewPlace view_place(const projection::Projection& projection) {
  constexpr double same_direction = 1e-9;
  const auto same = [](const Vec3& a, const Vec3& b) { return glm::length(a - b) < same_direction; };
  if (projection.central || !same(glm::normalize(projection.projector), projection.n)) return ViewPlace::pictorial;
  // Normal and upward direction on the page, in order of ViewPlace. ISO 128-3.
  const std::array<std::array<Vec3, 2>, 6> principal{{{{{0, -1, 0}, {0, 0, 1}}},
                                                      {{{0, 1, 0}, {0, 0, 1}}},
                                                      {{{-1, 0, 0}, {0, 0, 1}}},
                                                      {{{1, 0, 0}, {0, 0, 1}}},
                                                      {{{0, 0, 1}, {0, 1, 0}}},
                                                      {{{0, 0, -1}, {0, -1, 0}}}}};
  for (std::size_t i = 0; i < principal.size(); ++i)
    if (same(projection.n, principal[i][0]) && same(projection.v, principal[i][1])) return static_cast<ViewPlace>(i);
  const Vec3 size = glm::abs(projection.n);
  return std::min({size.x, size.y, size.z}) < same_direction ? ViewPlace::other : ViewPlace::pictorial;
}

Arrangement arrange(std::span<const ViewToPlace> views, const scene::ScaleChoice& choice, ProjectionAngle angle,
                    const DrawingRoom& room) {
  Question question{views, choice, angle, room};
  std::vector<ViewToPlace> single;
  if (views.size() == 1 && views.front().scale) {
    single = {views.front()};
    question.choice = {std::exchange(single.front().scale, std::nullopt)};
    question.views = single;
  }
  const Arrangement arrangement = stands_alone(question)  ? alone(question)
                                  : room.paper.width == 0 ? on_cut_paper(question)
                                                          : moved_to_paper(question);
  check(arrangement.views.size() == views.size(), "every view has a place");
  for (std::size_t i = 0; i < views.size(); ++i) {
    const ViewSpot& spot = arrangement.views[i];
    check(spot.view == i && spot.scale > 0, "every view has a scale");
    check(spot.box.min.x <= spot.box.max.x && spot.box.min.y <= spot.box.max.y, "the place of a view has a size");
  }
  return arrangement;
}

}  // namespace epura::sheet
