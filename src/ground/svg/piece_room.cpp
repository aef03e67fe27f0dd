// SPDX-License-Identifier: Apache-2.0
#include "svg/piece_room.hpp"

#include <utility>

#include "base/error.hpp"

namespace epura::svg {

namespace {

constexpr std::size_t always_room = 250'000;

}  // namespace

PieceRoom::PieceRoom(std::size_t bytes, std::string where)
    : where_(std::move(where)), max_(always_room + bytes / 2), left_(max_) {}

void PieceRoom::take(std::size_t pieces) {
  if (pieces > left_)
    throw Error(ErrorKind::input, where_, "stands for more than " + std::to_string(max_) + " pieces of lines",
                "a drawing of this file size has fewer");
  left_ -= pieces;
}

}  // namespace epura::svg
