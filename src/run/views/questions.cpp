// SPDX-License-Identifier: Apache-2.0
#include "views/questions.hpp"

#include <optional>
#include <string>

#include "explain/explain.hpp"
#include "explain/find_subjects.hpp"
#include "explain/tables.hpp"
#include "refine/refine_world.hpp"

namespace epura::pipeline {

std::string answer(const RunOptions& questions, const ViewInput& input, const ViewResult& result,
                   const Progress& progress) {
  if (questions.why.empty() && !questions.dump) return {};
  const auto& [view, drawn, hidden, paper] = result.work;
  // Refining takes less time than keeping a copy takes memory.
  const std::optional<world::World> refined = refine::refine_world(input.world, view.projection);
  const explain::ExplainInput drawn_view{{refined ? *refined : input.world, view, drawn, hidden},
                                         input.options.edges,
                                         paper,
                                         result.drawing,
                                         input.options.keep_hidden()};
  std::string text;
  if (questions.dump == DumpTable::edges) text += explain::edge_table(drawn_view, progress);
  if (questions.why.empty() && questions.dump != DumpTable::spans) return text;
  const explain::TriangleBoxes boxes(view);
  if (questions.dump == DumpTable::spans) text += explain::span_table(drawn_view, boxes, progress);
  progress.begin("answering");
  for (const explain::EdgeQuestion& question : questions.why)
    for (const explain::Subject& subject : explain::find_subjects(drawn_view, question)) {
      progress.expect_time();
      text += explain::explain(drawn_view, boxes, subject);
    }
  return text;
}

}  // namespace epura::pipeline
