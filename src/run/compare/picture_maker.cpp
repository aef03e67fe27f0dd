// SPDX-License-Identifier: Apache-2.0
#include "compare/picture_maker.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/error.hpp"
#include "base/text.hpp"
#include "sheet/paper.hpp"

namespace epura::compare {

namespace {

constexpr std::size_t max_looks = 200, max_views = 2000;

// Views may be outside their sheet.
constexpr double farthest = 10 * scene::longest_side;

constexpr const char* is_it_ours = "is it a drawing of epura?";

}  // namespace

void PictureMaker::expect_on_paper(const Vec2& place) const {
  if (!(std::abs(place.x) <= farthest && std::abs(place.y) <= farthest))
    refuse_input(where_,
                 "has something at (" + format_rounded(place.x, 6) + ", " + format_rounded(place.y, 6) +
                     ") mm, outside any paper",
                 "drawings are compared up to " + format_number(farthest / 1000) + " m from their corner");
}

void PictureMaker::set_size(const Vec2& size) {
  expect_on_paper(size);
  picture_.size = size;
}

int PictureMaker::look(const PictureLook& look) {
  std::vector<double> lengths = look.dashes;
  lengths.push_back(look.width);
  if (!std::all_of(lengths.begin(), lengths.end(), [](double length) { return length >= 0 && length <= farthest; }))
    refuse_input(where_, "has lines whose width or dashes are not valid lengths", is_it_ours);
  const int number = number_of_look(picture_.looks, look);
  if (picture_.looks.size() > max_looks)
    refuse_input(where_, "has more than " + std::to_string(max_looks) + " line styles", is_it_ours);
  return number;
}

int PictureMaker::view(const std::string& name) {
  const int number = number_of_name(picture_.views, name);
  if (picture_.views.size() > max_views)
    refuse_input(where_, "has more than " + std::to_string(max_views) + " views", is_it_ours);
  return number;
}

int PictureMaker::add_origins(std::vector<std::string> origins) {
  const auto first = static_cast<int>(picture_.origins.size());
  std::move(origins.begin(), origins.end(), std::back_inserter(picture_.origins));
  return first;
}

void PictureMaker::add(const PicturePiece& piece) {
  expect_on_paper(piece.from);
  expect_on_paper(piece.to);
  picture_.pieces.push_back(piece);
}

void PictureMaker::add(const PictureText& text) {
  expect_on_paper(text.min);
  expect_on_paper(text.max);
  picture_.texts.push_back(text);
}

}  // namespace epura::compare
