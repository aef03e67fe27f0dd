// SPDX-License-Identifier: Apache-2.0
// `epura define`: proves that the numbers on the sheets define the part.
#include <cstdio>
#include <string>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/describe.hpp"
#include "app/draw_files.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "output/json_text.hpp"
#include "pipeline/targets.hpp"

namespace epura {

namespace {

// What is nothing beside any last digit is 0.
std::string length(double value) { return format_rounded(value < 1e-9 ? 0 : value, 4) + " mm"; }

// Schema: define.schema.json.
std::string json_of(const sheet::RebuiltPart& part) {
  const auto truth = [](bool value) { return value ? "true" : "false"; };
  const auto face = [](const sheet::OffFace& one) {
    return "{\"face\": " + std::to_string(one.number) + ", \"what\": " + output::json_string(one.name) +
           ", \"off\": " + format_rounded(one.off, 6) + "}";
  };
  return std::string("{\"epura_define\": 1, \"defined\": ") + truth(part.is_defined()) +
         ", \"settled\": " + truth(part.is_settled) + ", \"faces\": " + std::to_string(part.faces) +
         ", \"by_model\": " + std::to_string(part.by_model) + ", \"perturbed\": " + format_rounded(part.perturbed, 6) +
         ", \"deviation\": " + format_rounded(part.deviation, 6) + ", \"spread\": " + format_rounded(part.spread, 6) +
         ", \"volume\": " + format_rounded(part.volume, 9) +
         ", \"volume_of_part\": " + format_rounded(part.of_part, 9) +
         ",\n \"free\": " + output::json_lines(part.free, face, "\n  ") +
         ",\n \"unread\": " + output::json_list(part.unread, output::json_string) + "}\n";
}

std::string text_of(const sheet::RebuiltPart& part) {
  std::string text;
  for (const sheet::OffFace& one : part.free)
    text += "not defined: " + one.name + " comes out as it began, " + length(one.off) + " off\n";
  for (const std::string& one : part.unread) text += "cannot tell: what " + one + " measures\n";
  if (!part.is_settled)
    return text +
           "cannot tell whether the numbers define the part: their equations do not come to rest; epura lint names "
           "the faces that they leave free\n";
  const int given = part.faces - part.by_model;
  text += std::to_string(given - static_cast<int>(part.free.size())) + " of " + std::to_string(given) +
          " faces are found again from the numbers on the sheets";
  if (part.by_model > 0) text += ", " + std::to_string(part.by_model) + " are given by the model alone";
  return text + "; perturbed by " + length(part.perturbed) + ", off by " + length(part.deviation) +
         " in the end; volume " + format_rounded(part.volume, 6) + " mm³, of the part " +
         format_rounded(part.of_part, 6) + " mm³\n";
}

// As for parts whose sheets nobody has described.
void choose_views(DrawOptions& options) {
  if (is_scene_file(options.models.front())) return;
  if (options.views.empty() && options.projections.empty())
    options.views.push_back({scene::parse_request("auto"), "--views"});
  if (!options.dimensions.given()) options.dimensions = {AutomaticDimensions::automatic, "--dimensions"};
}

}  // namespace

int define(DrawOptions options) {
  options.run.rebuild = true;
  if (!options.found_json.empty()) pipeline::refuse_overwriting({options.found_json}, options.models);
  choose_views(options);
  ProgressBoard board;
  Console console(board, shows_progress(options.progress), options.run.time_limit);
  const DrawnFiles drawn = draw_files(options, messages_to(console), Progress(board, options.run.time_limit));
  console.print("");
  tell_the_end(messages_to(console), options, drawn);
  if (!drawn.rebuilt)
    throw Error(ErrorKind::input, options.models.front(), "only single parts with recognised faces are found again",
                "draw one part, with --surfaces auto");
  if (!options.found_json.empty()) pipeline::write({options.found_json, json_of(*drawn.rebuilt)}, {});
  if (options.found_json != "-") std::fputs(text_of(*drawn.rebuilt).c_str(), stdout);
  const int code = exit_code_of(drawn);
  return code == 0 && !drawn.rebuilt->is_defined() ? found_wrong_exit_code : code;
}

}  // namespace epura
