// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/place_chain.hpp"

#include <cmath>
#include <cstddef>

namespace epura::sheet {

PlaceChain::PlaceChain(const design::Extent& extent, double slack) : slack_(slack), extent_(extent) {
  add(extent.from, "");
  add(extent.to, "");
}

void PlaceChain::add(double at, const std::string& name) {
  for (auto& [place, named] : places_)
    if (std::abs(place - at) <= slack_) {
      if (named.empty()) named = name;
      return;
    }
  places_.emplace_back(at, name);
}

void PlaceChain::begin() { sets_ = lengths_ = DisjointSets(places_.size()); }

void PlaceChain::join(double a, double b) {
  const int i = index_of(a), j = index_of(b);
  if (i >= 0 && j >= 0) sets_.join(i, j);
}

bool PlaceChain::join_by_length(double a, double b) {
  const int i = index_of(a), j = index_of(b);
  if (i < 0 || j < 0) return true;
  sets_.join(i, j);
  if (lengths_.root(i) == lengths_.root(j)) return false;
  lengths_.join(i, j);
  return true;
}

void PlaceChain::join_row(double from, double to, int parts) {
  for (int i = 0; i < parts; ++i) join_by_length(from + (to - from) * i / parts, from + (to - from) * (i + 1) / parts);
}

bool PlaceChain::is_joined(double at) {
  const int i = index_of(at);
  return i >= 0 && sets_.root(i) == sets_.root(index_of(extent_.from)) &&
         sets_.root(i) == sets_.root(index_of(extent_.to));
}

void PlaceChain::list_open(int axis, const Notation& notation, std::vector<std::string>& open) {
  const int root = sets_.root(index_of(extent_.from));
  const std::string along = axis_names[static_cast<std::size_t>(axis)];
  if (sets_.root(index_of(extent_.to)) != root) open.push_back("overall size along " + along);
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (!places_[i].second.empty() && sets_.root(static_cast<int>(i)) != root)
      open.push_back(places_[i].second + ": position along " + along + " (" + length_text(places_[i].first, notation) +
                     ")");
}

int PlaceChain::index_of(double at) const {
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (std::abs(places_[i].first - at) <= slack_) return static_cast<int>(i);
  return -1;
}

}  // namespace epura::sheet
