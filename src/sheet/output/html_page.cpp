// SPDX-License-Identifier: Apache-2.0
// One page for a browser with the sheets of a drawing. Its script and its style sheet are constant, so that their
// hashes are all that its policy permits; texts of models and scenes are text, attributes or JSON, never markup or
// code. Content Security Policy Level 3, 2.3.1.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "drawing/drawing.hpp"
#include "output/format.hpp"
#include "output/html.hpp"
#include "output/json_text.hpp"
#include "output/page_lines.hpp"
#include "output/page_parts.hpp"
#include "output/write.hpp"

namespace epura::output {

namespace {

bool has_pictures(const FileContent& content) {
  return std::any_of(content.sheets.begin(), content.sheets.end(), [](const SheetContent& one) {
    return std::any_of(one.sheet.layers.begin(), one.sheet.layers.end(),
                       [](const sheet::Layer& layer) { return !layer.pictures.empty(); });
  });
}

std::string compact_numbers(const std::vector<double>& values) {
  return json_list(
      values, [](double value) { return format_rounded(value, 12); }, ",");
}

std::string view_of(const drawing::ViewDrawing& view) {
  std::vector<double> matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix.push_back(view.world_to_page[column][row]);
  return "{\"name\":" + json_string(view.name) + ",\"scale\":" + json_number(view.scale) +
         (view.projection.central ? ",\"central\":true" : "") + (view.shown.breaks.any() ? ",\"broken\":true" : "") +
         ",\"matrix\":" + compact_numbers(matrix) + "}";
}

// Paths of files are not shown to those who get the page.
std::string model_of(const mesh::MeshReport& mesh) {
  std::vector<std::string> bodies = mesh.body_names;
  if (bodies.empty() && !mesh.only_body.empty()) bodies.push_back(mesh.only_body);
  return "{\"name\":" + json_string(std::string_view(mesh.name).substr(mesh.name.find_last_of('/') + 1)) +
         ",\"bodies\":" + json_list(bodies, json_string, ",") + "}";
}

std::string data_of(const FileContent& content) {
  const std::string models = json_list(content.report.meshes, model_of, ",");
  std::string answers;
  const auto sheet = [&](const SheetContent& one) {
    answers += one.answers;
    return "{\"title\":" + json_string(one.sheet.title) + ",\"width\":" + json_number(one.sheet.width) +
           ",\"height\":" + json_number(one.sheet.height) + ",\"views\":" + json_list(one.drawings, view_of, ",\n") +
           ",\"models\":" + models + "}";
  };
  const std::string sheets = json_list(content.sheets, sheet, ",\n");
  return within_script("{\"sheets\":" + sheets + ",\"answers\":" + json_string(answers) + "}");
}

std::string title_of(const FileContent& content) {
  const std::string& title = content.sheets.front().sheet.title;
  return html_text(!content.title.empty() ? content.title : title.empty() ? "Drawing" : title);
}

std::string sheets_of(const FileContent& content, const Progress& progress) {
  std::string html;
  for (std::size_t i = 0; i < content.sheets.size(); ++i) {
    html += "<section class=\"sheet\" tabindex=\"0\" aria-label=\"Sheet " + std::to_string(i + 1) + ": see Keys\">";
    const sheet::Sheet& sheet = content.sheets[i].sheet;
    const bool large = is_large(sheet);
    html += svg_of_page(sheet, content.options, !large, progress);
    if (large)
      html += "<script type=\"application/json\">" +
              within_script(packed_lines(sheet, content.options.plain, progress)) + "</script>";
    html += "</section>\n";
  }
  return html;
}

}  // namespace

std::string to_html(const FileContent& content, const Progress& progress) {
  // Images are not permitted if there are none.
  const std::string_view images = has_pictures(content) ? "img-src data:" : "";
  return filled_page(page_frame, {{"policy", content_policy(page_script_hash, page_style_hash, images)},
                                  {"title", title_of(content)},
                                  {"answers", html_text(content.answers_name)},
                                  {"style", std::string(page_style)},
                                  {"script", std::string(page_script)},
                                  {"sheets", sheets_of(content, progress)},
                                  {"data", data_of(content)}});
}

}  // namespace epura::output
