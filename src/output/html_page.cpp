// SPDX-License-Identifier: Apache-2.0
// One page for a browser with the sheets of a drawing. Its script and its style sheet are constant, so that their
// hashes are all that its policy permits; texts of models and scenes are text, attributes or JSON, never markup or
// code. Content Security Policy Level 3, 2.3.1.
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "output/base64.hpp"
#include "output/html.hpp"
#include "output/json_text.hpp"
#include "output/page_lines.hpp"
#include "output/page_parts.hpp"
#include "output/write.hpp"
#include "output/xml_text.hpp"

namespace epura::output {

namespace {

// A hash as the policy has it.
std::string base64_of_hexadecimal(std::string_view digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    const auto value = [&](std::size_t at) { return digits[at] <= '9' ? digits[at] - '0' : digits[at] - 'a' + 10; };
    bytes += static_cast<char>(16 * value(i) + value(i + 1));
  }
  return base64(bytes);
}

// Styles set by the script are not concerned; images are not permitted if there are none.
std::string policy(bool has_pictures) {
  return "default-src 'none'; script-src 'sha256-" + base64_of_hexadecimal(page_script_hash) + "'; style-src 'sha256-" +
         base64_of_hexadecimal(page_style_hash) + "'" + (has_pictures ? "; img-src data:" : "") +
         "; base-uri 'none'; form-action 'none'";
}

bool has_pictures(const FileContent& content) {
  return std::any_of(content.sheets.begin(), content.sheets.end(), [](const SheetContent& one) {
    return std::any_of(one.sheet.layers.begin(), one.sheet.layers.end(),
                       [](const sheet::Layer& layer) { return !layer.pictures.empty(); });
  });
}

// JSON inside <script>: no "<" may begin the end of the element or a comment.
std::string within_script(const std::string& json) {
  std::string text;
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

std::string numbers(const std::vector<double>& values) {
  return json_list(
      values, [](double value) { return format_rounded(value, 12); }, ",");
}

std::string view_of(const drawing::ViewDrawing& view) {
  std::vector<double> matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix.push_back(view.world_to_page[column][row]);
  return "{\"name\":" + json_string(view.name) + ",\"scale\":" + json_number(view.scale) +
         (view.projection.central ? ",\"central\":true" : "") + (view.breaks.any() ? ",\"broken\":true" : "") +
         ",\"matrix\":" + numbers(matrix) + "}";
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
  std::string html;
  // One pass over the frame: what is inserted is not searched for more places.
  for (std::string_view rest = page_frame; !rest.empty();) {
    const std::size_t open = std::min(rest.find("{{"), rest.size());
    html += rest.substr(0, open);
    rest.remove_prefix(open);
    if (rest.empty()) break;
    const std::size_t close = rest.find("}}");
    const std::string_view name = rest.substr(2, close - 2);
    rest.remove_prefix(close + 2);
    if (name == "policy") html += policy(has_pictures(content));
    if (name == "title") html += title_of(content);
    if (name == "answers") html += html_text(content.answers_name);
    if (name == "style") html += page_style;
    if (name == "script") html += page_script;
    if (name == "sheets") html += sheets_of(content, progress);
    if (name == "data") html += data_of(content);
  }
  return html;
}

}  // namespace epura::output
