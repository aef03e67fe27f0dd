// SPDX-License-Identifier: Apache-2.0
#include "views/plan_steps.hpp"

#include <filesystem>
#include <set>

#include "sheet/lettering.hpp"

namespace epura::pipeline {

report::PlanStep plugins_step(const std::vector<SheetOfViews>& sheets) {
  std::set<std::filesystem::path> opened;
  long long views = 0;
  for (const SheetOfViews& sheet : sheets)
    for (const PlannedView& view : sheet.plans) {
      opened.insert(view.entry.plugin);
      ++views;
    }
  return {"plugins", false, "only those that views name are opened", views, static_cast<long long>(opened.size())};
}

report::PlanStep text_step(const sheet::Sheet& sheet, bool leave_out) {
  long long texts = 0;
  for (const sheet::Layer& layer : sheet.layers) texts += static_cast<long long>(layer.texts.size());
  if (texts == 0 && !leave_out) sheet::Lettering();
  return {"text",
          texts > 0 || !leave_out,
          texts > 0    ? "there are texts"
          : !leave_out ? "requested by --plan"
                       : "there are no texts: no font is opened",
          texts,
          texts,
          {},
          texts == 0 && leave_out ? 1 : 0};
}

}  // namespace epura::pipeline
