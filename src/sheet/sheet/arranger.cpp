// SPDX-License-Identifier: Apache-2.0
#include "sheet/arranger.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "sheet/free_rectangles.hpp"
#include "sheet/standard_scale.hpp"

namespace epura::sheet {

namespace {

// Lengths that differ by less than this rounding error of sums are equal.
constexpr double slack = 1e-7;
// Several rounds, because each group of views that moves changes the room of the others a little.
constexpr int rounds_of_balance = 4;

void append_spots(std::vector<ViewSpot>& spots, const std::vector<ViewSpot>& more) {
  spots.insert(spots.end(), more.begin(), more.end());
}

bool is_principal(ViewPlace place) { return place < ViewPlace::pictorial; }

// Column and row in the layout around the front view.
std::array<int, 2> cross_place(ViewPlace place, ProjectionAngle angle) {
  const int to_its_side = angle == ProjectionAngle::third ? 1 : -1;
  switch (place) {
    case ViewPlace::left:
      return {1 - to_its_side, 1};
    case ViewPlace::right:
      return {1 + to_its_side, 1};
    case ViewPlace::top:
      return {1, 1 - to_its_side};
    case ViewPlace::bottom:
      return {1, 1 + to_its_side};
    case ViewPlace::back:
      return {3, 1};
    default:
      return {1, 1};
  }
}

}  // namespace

Arranger::Arranger(std::span<const ViewToPlace> views, ProjectionAngle angle, ArrangerRoom room)
    : views_(views), angle_(angle), room_(std::move(room)) {
  sort_out();
  if (!principal_.empty()) {
    std::vector<ViewCell> cells;
    for (const std::size_t view : principal_) cells.push_back(principal_cell(view));
    cross_.emplace_back(cells, room_.gap);
  }
  others_ = grids(other_, Labels::given);
  pictorials_ = grids(pictorial_, Labels::given);
  labelled_pictorials_ = grids(pictorial_, Labels::all);
}

// Without principal and other views, pictorial views are treated as other views.
void Arranger::sort_out() {
  std::array<bool, 6> there{};
  std::vector<char> stands_firm(views_.size(), 0);  // others can be placed beside it
  const auto add = [&](std::size_t i) {
    const ViewToPlace& view = views_[i];
    const bool principal = is_principal(view.place) && !view.scale;
    std::vector<std::size_t>& group = view.at                                                               ? given_
                                      : room_.aligns && view.beside && stands_firm[view.beside->first] != 0 ? beside_
                                      : principal && !std::exchange(there[static_cast<std::size_t>(view.place)], true)
                                          ? principal_
                                      : view.place == ViewPlace::pictorial ? pictorial_
                                                                           : other_;
    group.push_back(i);
    if (!view.beside && (&group == &given_ || &group == &principal_)) stands_firm[i] = 1;
  };
  for (std::size_t i = 0; i < views_.size(); ++i)
    if (!views_[i].beside) add(i);
  for (std::size_t i = 0; i < views_.size(); ++i)
    if (views_[i].beside) add(i);
  for (std::vector<std::size_t>* group : {&given_, &principal_, &other_, &pictorial_})
    std::sort(group->begin(), group->end());
  if (principal_.empty() && other_.empty()) other_.swap(pictorial_);
  check(given_.size() + principal_.size() + beside_.size() + other_.size() + pictorial_.size() == views_.size(),
        "every view is in one group");
}

Vec2 Arranger::room_after(const ViewToPlace& view) const {
  if (!view.labelled) return view.after;
  return glm::max(view.after, Vec2(0, label_room - std::min(room_.gap, room_.clearance)));
}

ViewCell Arranger::principal_cell(std::size_t view) const {
  const ViewToPlace& v = views_[view];
  const auto [column, row] = cross_place(v.place, angle_);
  return {view, column, row, Vec2(0, 0), v.box.min, v.box.max, v.before, room_after(v)};
}

ViewCell Arranger::free_cell(std::size_t view, int column, int row, Labels labels) const {
  const ViewToPlace& v = views_[view];
  const Vec2 middle = Rectangle{v.box.min, v.box.max}.centre();
  Vec2 after = room_after(v);
  if (labels == Labels::all || v.scale) after.y = std::max(after.y, label_room);
  if (!v.scale) return {view, column, row, middle, v.box.min - middle, v.box.max - middle, v.before, after};
  const Vec2 half = (v.box.max - middle) * *v.scale;
  return {view, column, row, middle, Vec2(0, 0), Vec2(0, 0), v.before + half, after + half, v.scale};
}

Arranger::Tables Arranger::grids(const std::vector<std::size_t>& views, Labels labels) const {
  Tables tables;
  const auto count = static_cast<int>(views.size());
  int columns_before = 0;
  for (int rows = 1; rows <= count; ++rows) {
    const int columns = (count + rows - 1) / rows;
    if (columns == std::exchange(columns_before, columns)) continue;
    std::vector<ViewCell> cells;
    for (int i = 0; i < count; ++i)
      cells.push_back(free_cell(views[static_cast<std::size_t>(i)], i % columns, i / columns, labels));
    tables.emplace_back(cells, room_.gap);
  }
  return tables;
}

double Arranger::largest_scale() const {
  double largest = HUGE_VAL;
  for (const Tables* tables : {&cross_, &others_}) {
    double of_these = tables->empty() ? HUGE_VAL : 0;
    for (const ViewTable& table : *tables) of_these = std::max(of_these, table.largest_scale(room_.area.size()));
    largest = std::min(largest, of_these);
  }
  for (const std::size_t i : given_) {
    const ViewToPlace& view = views_[i];
    const ViewTable alone({free_cell(i, 0, 0, Labels::given)}, 0);
    const Vec2 half = glm::min(room_.area.max - *view.at, *view.at - room_.area.min);
    if (const double fitting = alone.largest_scale(half * 2.0); fitting > 0) largest = std::min(largest, fitting);
  }
  return largest;
}

ViewSpot Arranger::given_spot(std::size_t view, double scale) const {
  const ViewCell cell = free_cell(view, 0, 0, Labels::given);
  const ViewSpot spot = ViewTable({cell}, 0).spots(scale, {0, 0}).front();
  return moved(spot, *views_[view].at - (spot.shift + spot.scale * cell.anchor));
}

// The nearest free place.
std::optional<ViewSpot> Arranger::beside_spot(std::size_t view, const Spots& spots, double scale,
                                              std::span<const Rectangle> taken) const {
  constexpr double step = 1;  // mm
  const ViewToPlace& v = views_[view];
  const auto parent =
      std::find_if(spots.begin(), spots.end(), [&](const ViewSpot& spot) { return spot.view == v.beside->first; });
  if (parent == spots.end()) return std::nullopt;
  const double own = v.scale.value_or(scale), most = room_.area.size().x + room_.area.size().y;
  const Vec2 min = own * v.box.min - v.before, max = own * v.box.max + room_after(v);
  for (double distance = 0; distance <= most; distance += step) {
    const Vec2 at = parent->shift + distance * v.beside->second;
    const ViewSpot spot{view, own, at, {at + min, at + max}};
    if (is_free({spot}, taken)) return spot;
  }
  return std::nullopt;
}

bool Arranger::is_free(const Spots& spots, std::span<const Rectangle> taken) const {
  return std::all_of(spots.begin(), spots.end(), [&](const ViewSpot& spot) {
    return room_.area.holds(spot.box, slack) &&
           std::none_of(taken.begin(), taken.end(),
                        [&](const Rectangle& obstacle) { return obstacle.overlaps(spot.box, slack); });
  });
}

// As high and far to the left as possible: the title block is at the lower right, and the other views need room.
std::optional<Arranger::Spots> Arranger::principal_spots(double scale, std::span<const Rectangle> taken) const {
  std::vector<Rectangle> corners = {room_.area};
  const std::vector<Rectangle> free = free_rectangles(room_.area, taken);
  corners.insert(corners.end(), free.begin(), free.end());
  check(!cross_.empty(), "principal views have a table");
  const ViewTable& table = cross_.front();
  for (const Rectangle& r : corners) {
    Spots spots = table.spots(scale, {r.min.x, r.max.y - table.size(scale).y});
    if (is_free(spots, taken) && add_beside(spots, scale, taken)) return spots;
  }
  if (beside_.empty()) return std::nullopt;
  // Views beside them may need the room above or to the left.
  const Vec2 play = room_.area.size() - table.size(scale);
  for (const Vec2& part :
       {Vec2(0, 0), Vec2(1, 1), Vec2(1, 0), Vec2(0.5, 0.5), Vec2(0.5, 0), Vec2(0, 0.5), Vec2(1, 0.5)}) {
    Spots spots = table.spots(scale, room_.area.min + part * play);
    if (is_free(spots, taken) && add_beside(spots, scale, taken)) return spots;
  }
  return std::nullopt;
}

// Adds the views beside others to those placed already; false if there is no room.
bool Arranger::add_beside(Spots& spots, double scale, std::span<const Rectangle> taken) const {
  std::vector<Rectangle> all(taken.begin(), taken.end());
  for (const ViewSpot& spot : spots) all.push_back(spot.box.grown(room_.gap));
  for (const std::size_t view : beside_) {
    const bool is_here = std::any_of(spots.begin(), spots.end(),
                                     [&](const ViewSpot& spot) { return spot.view == views_[view].beside->first; });
    if (!is_here) continue;
    const auto spot = beside_spot(view, spots, scale, all);
    if (!spot) return false;
    spots.push_back(*spot);
    all.push_back(spot->box.grown(room_.gap));
  }
  return true;
}

std::optional<Arranger::Spots> Arranger::grid_spots(const Tables& tables, double scale,
                                                    std::span<const Rectangle> taken) const {
  if (tables.empty()) return Spots{};
  const ViewTable* best = nullptr;
  Rectangle where{};
  double largest = 0;
  for (const Rectangle& r : free_rectangles(room_.area, taken))
    for (const ViewTable& table : tables)
      if (const double fitting = table.largest_scale(r.size()); fitting > largest) {
        best = &table;
        where = r;
        largest = fitting;
      }
  if (best == nullptr || largest < scale * (1 - 1e-12)) return std::nullopt;
  return best->spots(scale, where.centre() - best->size(scale) / 2.0);
}

std::optional<Arranger::Spots> Arranger::pictorial_spots(double scale, double share,
                                                         std::span<const Rectangle> taken) const {
  if (auto spots = grid_spots(pictorials_, scale, taken)) return spots;
  for (double s = standard_scale_up_to(scale * 0.99); s >= scale * share; s = standard_scale_up_to(s * 0.99))
    if (auto spots = grid_spots(labelled_pictorials_, s, taken)) return spots;
  return std::nullopt;
}

std::optional<std::vector<ViewSpot>> Arranger::arranged(double scale, double share) const {
  Spots all;
  std::vector<Rectangle> taken = room_.taken;
  const auto add = [&](const std::optional<Spots>& spots) {
    if (!spots) return false;
    append_spots(all, *spots);
    for (const ViewSpot& spot : *spots) taken.push_back(spot.box.grown(room_.gap));
    return true;
  };
  for (const std::size_t view : given_) {
    Spots spot = {given_spot(view, scale)};
    if (room_.watch_given && !is_free(spot, taken)) return std::nullopt;
    if (!add_beside(spot, scale, taken)) return std::nullopt;
    add(spot);
  }
  if (!principal_.empty() && !add(principal_spots(scale, taken))) return std::nullopt;
  if (!add(grid_spots(others_, scale, taken)) || !add(pictorial_spots(scale, share, taken))) return std::nullopt;
  std::sort(all.begin(), all.end(), [](const ViewSpot& a, const ViewSpot& b) { return a.view < b.view; });
  check(all.size() == views_.size(), "every view has a place");
  return all;
}

// How far the views of a group can move backwards and forwards along an axis until one hits something.
std::array<double, 2> Arranger::play(const Spots& spots, const std::vector<std::size_t>& group, int axis) const {
  std::vector<Rectangle> taken = room_.taken;
  for (const ViewSpot& spot : spots)
    if (std::find(group.begin(), group.end(), spot.view) == group.end()) taken.push_back(spot.box.grown(room_.gap));
  double back = HUGE_VAL, forth = HUGE_VAL;
  for (const std::size_t view : group) {
    const Rectangle& box = spots[view].box;
    back = std::min(back, box.min[axis] - room_.area.min[axis]);
    forth = std::min(forth, room_.area.max[axis] - box.max[axis]);
    for (const Rectangle& obstacle : taken) {
      const int across = 1 - axis;
      if (std::min(box.max[across], obstacle.max[across]) - std::max(box.min[across], obstacle.min[across]) <= slack)
        continue;
      if (obstacle.centre()[axis] < box.centre()[axis])
        back = std::min(back, box.min[axis] - obstacle.max[axis]);
      else
        forth = std::min(forth, obstacle.min[axis] - box.max[axis]);
    }
  }
  check(back < HUGE_VAL && forth < HUGE_VAL, "the sheet ends how far views move");
  return {std::max(back, 0.0), std::max(forth, 0.0)};
}

std::vector<ViewSpot> Arranger::balanced(std::vector<ViewSpot> spots) const {
  // Views beside principal ones move with them.
  std::vector<std::size_t> principal = principal_;
  for (const std::size_t view : beside_)
    if (!views_[views_[view].beside->first].at) principal.push_back(view);
  const std::array<const std::vector<std::size_t>*, 3> groups{&principal, &other_, &pictorial_};
  for (int round = 0; round < rounds_of_balance; ++round)
    for (const auto* group : groups)
      for (const int axis : {0, 1}) {
        if (group->empty()) continue;
        const auto [back, forth] = play(spots, *group, axis);
        Vec2 move(0, 0);
        move[axis] = (forth - back) / 2;
        for (const std::size_t view : *group) {
          check(spots[view].view == view, "views are in order");
          spots[view] = moved(spots[view], move);
        }
      }
  return spots;
}

std::vector<ViewSpot> Arranger::overflowing(double scale) const {
  std::vector<ViewCell> cells;
  for (const std::size_t view : principal_) cells.push_back(principal_cell(view));
  int column = 4;  // the rear view is in column 3
  for (const auto* views : {&beside_, &other_, &pictorial_})
    for (const std::size_t view : *views) cells.push_back(free_cell(view, column++, 1, Labels::given));
  const ViewTable table(cells, room_.gap);
  Spots all = table.spots(scale, room_.area.centre() - table.size(scale) / 2.0);
  for (const std::size_t view : given_) all.push_back(given_spot(view, scale));
  std::sort(all.begin(), all.end(), [](const ViewSpot& a, const ViewSpot& b) { return a.view < b.view; });
  return all;
}

}  // namespace epura::sheet
