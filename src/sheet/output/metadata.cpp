// SPDX-License-Identifier: Apache-2.0
#include "output/metadata.hpp"

#include "base/text.hpp"

namespace epura::output {

std::string fact_of(const sheet::Sheet& sheet, std::string_view name) {
  for (const auto& [fact, value] : sheet.facts)
    if (fact == name) return value;
  return {};
}

std::string description_of(const sheet::Sheet& sheet) {
  std::string text;
  for (const sheet::ViewFrame& view : sheet.views) {
    append_to_list(text, view.name);
    if (!view.projection.empty() && view.projection != view.name) text += " (" + view.projection + ")";
    if (!view.scale.empty()) text += " " + view.scale;
  }
  return text;
}

}  // namespace epura::output
