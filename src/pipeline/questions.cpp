// SPDX-License-Identifier: Apache-2.0
#include "pipeline/questions.hpp"

#include <string>

#include "study/questions/explain.hpp"
#include "study/questions/explain_input.hpp"
#include "study/questions/tables.hpp"

namespace epura {

Questions questions_of(const RunOptions& options) {
  return {options.why, options.dump == DumpTable::edges, options.dump == DumpTable::spans};
}

std::string answer(const Questions& questions, const World& world, const ViewOptions& wish, const ViewResult& result,
                   const Progress& progress) {
  const ViewWork& work = result.work;
  const ExplainInput drawn_view{world,        work.view,  wish.edges,     work.drawn,        work.hidden,
                                work.contact, work.paper, result.drawing, wish.keep_hidden()};
  std::string text;
  if (questions.edge_table) text += edge_table(drawn_view, progress);
  if (questions.why.empty() && !questions.span_table) return text;
  const TriangleBoxes boxes(work.view);
  if (questions.span_table) text += span_table(drawn_view, boxes, progress);
  progress.begin("answering");
  for (const EdgeQuestion& question : questions.why)
    for (const Subject& subject : find_subjects(drawn_view, question)) {
      progress.expect_time();
      text += explain(drawn_view, boxes, subject);
    }
  return text;
}

}  // namespace epura
