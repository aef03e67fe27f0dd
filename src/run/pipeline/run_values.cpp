// SPDX-License-Identifier: Apache-2.0
#include "pipeline/run_values.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace epura::pipeline {

scene::ValueKind<double> contact_distance() { return scene::number_between(0, HUGE_VAL, ""); }

scene::ValueKind<double> arc_tolerance() {
  scene::ValueKind<double> tolerance = scene::number_between(1e-6, 1, "mm").shown_as("MM");
  tolerance.form.implied = "0.01";
  return tolerance;
}

scene::ValueKind<double> max_error() { return scene::number_between(1e-12, 1e6, "mm").shown_as("MM"); }

scene::ValueKind<double> time_limit() { return scene::number_between(0, HUGE_VAL, "s").shown_as("S"); }

scene::ValueKind<int> verify_samples() { return scene::whole_number(1, 10'000'000); }

scene::ValueKind<int> thread_count() { return scene::whole_number(0, 1024); }

// A standard, or single rules.
scene::ValueKind<definition::RuleSet> applied_rules() {
  const auto& standards = definition::standard_names;
  std::vector<std::string> words(standards.begin(), standards.end());
  for (const definition::Rule& rule : definition::all_rules()) words.emplace_back(rule.name);
  scene::ValueForm form{"list of texts", "NAMES", words};
  form.is_list = form.is_closed = true;
  return {std::move(form), [words](const scene::TomlValue& value) {
            definition::RuleSet applied;
            for (const scene::LocatedText& word : scene::each_word(value)) {
              const std::size_t number = scene::read_word(scene::value_of_option(value.where, *word), words);
              if (number < standards.size())
                applied |= definition::rules_of(static_cast<definition::Standard>(number));
              else
                applied.set(number - standards.size());
            }
            return applied;
          }};
}

}  // namespace epura::pipeline
