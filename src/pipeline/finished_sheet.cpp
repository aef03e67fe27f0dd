// SPDX-License-Identifier: Apache-2.0
#include "pipeline/finished_sheet.hpp"

#include <utility>

#include "sheet/partial_mark.hpp"

namespace epura::pipeline {

void mark_partial(FinishedSheet& sheet, const std::string& stage) {
  sheet::Layer mark = sheet::partial_mark(sheet.paper, stage);
  std::erase_if(sheet.sheet.layers, [&](const sheet::Layer& layer) { return layer.name == mark.name; });
  sheet.sheet.layers.push_back(std::move(mark));
}

}  // namespace epura::pipeline
