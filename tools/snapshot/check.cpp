// SPDX-License-Identifier: Apache-2.0
#include "snapshot/check.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <map>
#include <system_error>
#include <utility>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/draw_files.hpp"
#include "app/draw_options.hpp"
#include "app/hash.hpp"
#include "app/proof.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/temporary_folder.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "compare/attachments.hpp"
#include "compare/comparison.hpp"
#include "report/format.hpp"
#include "snapshot/compare.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

/// What is found, in words.
struct Findings {
  std::string text{};
  bool is_proved = true;

  void add(const std::string& sentence) { text += "  " + sentence + "\n"; }
  void add_lines(const std::string& lines) {
    for (const std::string_view line : split(lines, '\n'))
      if (!line.empty()) add(std::string(line));
  }
  void object(const std::string& sentence) {
    is_proved = false;
    add("WRONG: " + sentence);
  }
};

using Carried = std::map<std::string, std::string>;  // bytes of attachments by name

std::string extension_of(const std::string& drawing) { return to_lower(fs::path(drawing).extension().string()); }

Carried carried_by(const std::string& bytes, const std::string& drawing) {
  Carried carried;
  for (output::Attachment& one : compare::attachments_in(bytes, drawing))
    carried.emplace(std::move(one.name), std::move(one.bytes));
  if (carried.count(proof_name) == 0)
    throw Error(ErrorKind::input, drawing, "carries no proof",
                "epura draw --proof data, or --proof model, makes drawings that can be checked");
  return carried;
}

void write_below(const fs::path& folder, const std::string& name, const std::string& bytes) {
  const fs::path file = folder / name;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw Error(ErrorKind::output, file.parent_path().string(), "cannot be created: " + error.message());
  write_file(file, bytes);
}

// Puts the files that were read into a folder, from the drawing or from beside it.
void gather_inputs(const Proof& proof, const Carried& carried, const CheckOptions& options, const fs::path& folder,
                   Findings& findings) {
  const fs::path beside = options.inputs.empty() ? fs::path(options.drawing).parent_path() : fs::path(options.inputs);
  for (const ProofInput& input : proof.inputs) {
    const auto attached = carried.find(input.attachment);
    const bool is_attached = attached != carried.end();
    const fs::path file = beside / input.file;
    std::error_code missing;
    if (!is_attached && !fs::exists(file, missing))
      throw Error(ErrorKind::input, options.drawing, "was drawn from " + input.file + ", which it does not carry",
                  "put it beside the drawing, or name its folder by --inputs");
    const std::string bytes = is_attached ? attached->second : read_file(file);
    const std::string place = is_attached ? " (carried by the drawing)" : " (" + file.string() + ")";
    if (hash_of_bytes(bytes) == input.sha256)
      findings.add(input.file + place + ": the file that was drawn, SHA-256 " + input.sha256);
    else
      findings.object(input.file + place + ": is not the file that was drawn, whose SHA-256 is " + input.sha256);
    write_below(folder, input.file, bytes);
  }
}

void expect_results(const Proof& proof, const Carried& carried, Findings& findings) {
  Carried others = carried;
  others.erase(proof_name);
  for (const ProofInput& input : proof.inputs) others.erase(input.attachment);
  for (const auto& [file, hash] : proof.results) {
    const auto found = others.find(file);
    if (found == others.end())
      findings.object(file + " is missing");
    else if (hash_of_bytes(found->second) != hash)
      findings.object(file + " was changed: its SHA-256 is not the one that the drawing states");
    others.erase(file);
  }
  for (const auto& [file, bytes] : others) findings.object(file + " was added");
}

DrawOptions options_of(const Proof& proof, const CheckOptions& options, const fs::path& inputs,
                       const fs::path& output) {
  DrawOptions draw;
  draw.outputs = {output.string()};
  draw.run.plugin_path = options.plugin_path;
  for (const std::string& model : proof.models) draw.models.push_back((inputs / model).string());
  const scene::Options<DrawOptions> rows = draw_options();
  for (const auto& [name, value] : proof.options) {
    const scene::Option<DrawOptions>* row = find_option(rows, name);
    check(row != nullptr, "options of a proof have a row");
    row->read(draw, scene::value_of_option(name, names_file(*row, value) ? (inputs / value).string() : value));
  }
  return draw;
}

// Errors name files as the drawing does.
DrawnFiles draw_again(const DrawOptions& options, const std::string& drawing, const std::string& folder) {
  ProgressBoard board;
  const Console console(board, false);
  try {
    return draw_files(options, pipeline::silent_messages(), Progress(board));
  } catch (const Error& error) {
    std::string words = error.what();
    for (std::size_t at = 0; (at = words.find(folder, at)) != words.npos;) words.erase(at, folder.size());
    throw Error(error.kind(), drawing, "cannot be drawn again: " + words, error.hint());
  }
}

void tell_differences(const std::string& given, const std::string& drawn, const std::string& drawing,
                      Findings& findings) {
  Carried carried = carried_by(given, drawing);
  for (const auto& [name, bytes] : carried_by(drawn, drawing)) {
    const auto found = carried.find(name);
    if (found == carried.end())
      findings.object(name + " is missing");
    else if (found->second != bytes)
      findings.object(name + " is not what is found now");
  }
  if (extension_of(drawing) == ".pdf")
    for (const std::string& layer : compare::differing_layers(given, drawn, drawing))
      findings.object(layer + " is not as drawn now");
  const double tolerance = CompareOptions().tolerance;
  const compare::Comparison comparison =
      compare::compare(compare::pictures_of(drawn, drawing), compare::pictures_of(given, drawing), tolerance);
  if (comparison.is_same()) return findings.add("lines that are seen: no difference");
  findings.object("lines that are seen:");
  findings.add_lines(compare::format_comparison(comparison, tolerance));
}

void compare_bytes(const std::string& given, const DrawnFiles& drawn, const CheckOptions& options, const Proof& proof,
                   Findings& findings) {
  std::vector<std::string> files;
  for (const std::string& file : drawn.paths) files.push_back(read_file(file));
  const std::string by = "drawn again by epura " + own_version() + ": ";
  const auto same = std::find(files.begin(), files.end(), given);
  if (same != files.end()) return findings.add(by + "the same file, byte for byte");
  findings.object(by + "another file");
  if (proof.version != own_version())
    findings.add("it was written by epura " + proof.version + ", and other versions may write other bytes");
  if (files.size() > 1) return findings.add("none of the " + std::to_string(files.size()) + " sheets is this one");
  tell_differences(given, files.front(), options.drawing, findings);
}

void tell_results(const DrawnFiles& drawn, Findings& findings) {
  if (drawn.report.verification)
    findings.add_lines("test of the view with most faults: " + report::format_verification(*drawn.report.verification));
  const std::size_t found = drawn.report.findings.size();
  findings.add(found == 0 ? "lint: nothing is wrong with the dimensions"
                          : "lint: " + std::to_string(found) + (found == 1 ? " fault" : " faults") +
                                " of the dimensions, listed in the lint.json that the sheet carries");
  const std::vector<report::RequirementRow>& rows = drawn.report.requirements;
  const auto drawn_rows = std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.is_drawn(); });
  if (!rows.empty())
    findings.add("requirements of the models: " + std::to_string(drawn_rows) + " of " + std::to_string(rows.size()) +
                 " are on the sheets");
  if (exit_code_of(drawn) != 0) findings.object("the test of the drawing, or its requirements, say that it is wrong");
}

}  // namespace

scene::Options<CheckOptions> check_options() {
  using Check = CheckOptions;
  return {
      scene::option<Check>({.flag = "drawing", .help = "SVG or PDF that 'epura draw --proof' wrote", .required = true},
                           &Check::drawing, file_name("FILE")),
      scene::option<Check>({.flag = "--inputs",
                            .help = "folder of the models that the drawing does not carry",
                            .usual = "that of the drawing"},
                           &Check::inputs, file_name("DIR").completed_by(scene::Completion::folders)),
      plugin_path_option<Check>(&Check::plugin_path),
  };
}

int check_drawing(const CheckOptions& options) {
  const std::string extension = extension_of(options.drawing);
  if (extension != ".svg" && extension != ".pdf")
    throw Error(ErrorKind::input, options.drawing, "is not a drawing that can be checked", "epura checks SVG and PDF");
  const std::string bytes = read_file(options.drawing);
  const Carried carried = carried_by(bytes, options.drawing);
  const TemporaryFolder folder;
  write_file(folder / proof_name, carried.at(proof_name));
  const Proof proof = read_proof(folder / proof_name);
  Findings findings;
  expect_results(proof, carried, findings);
  const fs::path inputs = folder / "inputs";
  gather_inputs(proof, carried, options, inputs, findings);
  const fs::path again = folder / ("again" + extension);
  const DrawnFiles drawn =
      draw_again(options_of(proof, options, inputs, again), options.drawing, inputs.string() + "/");
  compare_bytes(bytes, drawn, options, proof, findings);
  tell_results(drawn, findings);
  const std::string text = options.drawing + ", written by epura " + proof.version + "\n" + findings.text +
                           (findings.is_proved ? "proved: it is what its models and options give\n" : "NOT proved\n");
  std::fputs(printable(text).c_str(), stdout);
  return findings.is_proved ? 0 : found_wrong_exit_code;
}

}  // namespace epura
