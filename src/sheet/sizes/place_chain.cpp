// SPDX-License-Identifier: Apache-2.0
#include "sizes/place_chain.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace epura::sheet {

PlaceChain::PlaceChain(int axis, const features::Extent& extent, std::span<const FeaturePlace> places, double slack)
    : axis_(axis), slack_(slack), extent_(extent) {
  add(extent.from, "");
  add(extent.to, "");
  for (const FeaturePlace& place : places)
    if (place.axis == axis) add(place.at, place.name);
  sets_ = lengths_ = DisjointSets(places_.size());
}

void PlaceChain::add(double at, const std::string& name) {
  for (auto& [place, named] : places_)
    if (std::abs(place - at) <= slack_) {
      if (named.empty()) named = name;
      return;
    }
  places_.emplace_back(at, name);
}

bool PlaceChain::join(const PlaceJoin& join) {
  check(join.axis == axis_, "a chain is along one axis");
  const auto at = [&join](int i) { return join.from + (join.to - join.from) * i / join.parts; };
  bool is_new = true;
  for (int i = 0; i < join.parts; ++i) is_new = join_by_length(at(i), at(i + 1)) && is_new;
  const int i = index_of(join.from), j = index_of(join.to);
  if (join.parts == 0 && i >= 0 && j >= 0) sets_.join(i, j);
  return is_new;
}

bool PlaceChain::join_by_length(double a, double b) {
  const int i = index_of(a), j = index_of(b);
  if (i < 0 || j < 0) return true;
  sets_.join(i, j);
  if (lengths_.root(i) == lengths_.root(j)) return false;
  lengths_.join(i, j);
  return true;
}

std::vector<double> PlaceChain::joined() {
  std::vector<double> joined;
  const int root = sets_.root(index_of(extent_.from));
  if (sets_.root(index_of(extent_.to)) != root) return joined;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (sets_.root(static_cast<int>(i)) == root) joined.push_back(places_[i].first);
  return joined;
}

std::vector<std::string> PlaceChain::open(const Notation& notation) {
  std::vector<std::string> open;
  const int root = sets_.root(index_of(extent_.from));
  const std::string along = axis_names[static_cast<std::size_t>(axis_)];
  if (sets_.root(index_of(extent_.to)) != root) open.push_back("overall size along " + along);
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (!places_[i].second.empty() && sets_.root(static_cast<int>(i)) != root)
      open.push_back(places_[i].second + ": position along " + along + " (" + length_text(places_[i].first, notation) +
                     ")");
  return open;
}

int PlaceChain::index_of(double at) const {
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (std::abs(places_[i].first - at) <= slack_) return static_cast<int>(i);
  return -1;
}

}  // namespace epura::sheet
