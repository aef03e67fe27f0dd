// SPDX-License-Identifier: Apache-2.0
#include "app/proof.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

#include "app/draw_files.hpp"
#include "app/draw_options.hpp"
#include "app/hash.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "importer/bounds.hpp"
#include "importer/read_model.hpp"
#include "output/json_text.hpp"
#include "scene/read_entries.hpp"
#include "scene/scene_file.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

using output::Attachment;
using output::Relation;

fs::path whole_path(const std::string& file) { return fs::absolute(file).lexically_normal(); }

// The files that were read, each once, in the order of their paths.
std::vector<fs::path> inputs_of(const std::vector<std::string>& models, const scene::SceneDescription& scene) {
  std::vector<fs::path> files;
  for (const std::string& model : models) files.push_back(whole_path(importer::parse_model_request(model).path));
  for (const fs::path& file : scene::files_named_in(scene))
    files.push_back(whole_path(importer::parse_model_request(file.string()).path));
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

// The innermost folder below which all files lie.
fs::path common_folder(const std::vector<fs::path>& files) {
  fs::path common = files.front().parent_path();
  for (const fs::path& file : files) {
    fs::path shared;
    auto one = common.begin();
    for (auto other = file.begin(); one != common.end() && other != file.end() && *one == *other; ++one, ++other)
      shared /= *one;
    common = shared;
  }
  return common;
}

std::string name_below(const fs::path& folder, const std::string& file) {
  return whole_path(file).lexically_relative(folder).generic_string();
}

// A model with the parameters of its importer.
std::string request_below(const fs::path& folder, const std::string& model) {
  const std::string path = importer::parse_model_request(model).path;
  return name_below(folder, path) + model.substr(path.size());
}

std::string kind_of(const fs::path& file) {
  static const std::map<std::string, std::string> kinds{
      {".json", "application/json"}, {".toml", "application/toml"}, {".svg", "image/svg+xml"}, {".png", "image/png"},
      {".stl", "model/stl"},         {".obj", "model/obj"},         {".step", "model/step"},   {".stp", "model/step"},
      {".glb", "model/gltf-binary"}, {".gltf", "model/gltf+json"},  {".3mf", "model/3mf"},     {".igs", "model/iges"},
      {".iges", "model/iges"}};
  const auto found = kinds.find(to_lower(file.extension().string()));
  return found != kinds.end() ? found->second : "application/octet-stream";
}

// A table of an array, as `[[name]]`.
class TableText {
 public:
  explicit TableText(const std::string& name) : text_("\n[[" + name + "]]\n") {}
  // Strings of TOML have the escapes of JSON.
  TableText& add(const std::string& key, const std::string& value) {
    text_.append(key).append(" = ").append(output::json_string(value)) += '\n';
    return *this;
  }
  TableText& add_if_given(const std::string& key, const std::string& value) {
    return value.empty() ? *this : add(key, value);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string text_of(const Proof& proof) {
  std::string text = "# What this drawing was made from: `epura check` makes it again.\nproof = 1\nepura = " +
                     output::json_string(proof.version) +
                     "\nmodels = " + output::json_list(proof.models, output::json_string) + "\n";
  for (const auto& [name, value] : proof.options)
    text += TableText("option").add("name", name).add("value", value).text();
  for (const ProofInput& input : proof.inputs)
    text += TableText("input")
                .add("file", input.file)
                .add("sha256", input.sha256)
                .add_if_given("attachment", input.attachment)
                .text();
  for (const auto& [file, hash] : proof.results)
    text += TableText("result").add("file", file).add("sha256", hash).text();
  return text;
}

// What other requests add to the report is left out: whoever checks does not repeat them.
std::vector<Attachment> results_of(const pipeline::DrawnScene& drawn, const fs::path& folder) {
  report::Report report = drawn.report;
  for (mesh::MeshReport& mesh : report.meshes) mesh.name = request_below(folder, mesh.name);
  report.seconds.clear();
  report.conditions.clear();
  for (report::PlanStep& step : report.plan) step.times = {};
  std::vector<Attachment> results{{"lint.json", "application/json", "what is wrong with the dimensions: epura lint",
                                   Relation::data, findings_json(report)}};
  for (std::size_t i = 0; i < drawn.sheets.size(); ++i) {
    const pipeline::FinishedSheet& sheet = drawn.sheets[i];
    results.push_back({"drawing-" + std::to_string(i + 1) + ".json", "application/json",
                       "lines of sheet " + std::to_string(i + 1) + ", test of the drawing, requirements of the models",
                       Relation::data, output::to_json(sheet.sheet, sheet.scale, sheet.drawings, report)});
  }
  return results;
}

// Reading what a stranger may have written.

std::string text_in(const scene::TomlValue& value) {
  const auto* text = std::get_if<std::string>(&value.content);
  if (text == nullptr) scene::refuse(value, "must be text");
  return *text;
}

std::string expected_below(const scene::TomlValue& value, const std::string& file) {
  if (!output::is_safe_name(file))
    scene::refuse(value, "'" + file + "' does not lie below the folder of the inputs",
                  "a drawing must not name files elsewhere");
  return file;
}

std::string file_in(const scene::TomlValue& value) { return expected_below(value, text_in(value)); }

// What holds for models in scene files: bounds of reading are the reader's.
std::string model_in(const scene::TomlValue& value) {
  const importer::ModelRequest request = importer::parse_model_request(text_in(value));
  expected_below(value, request.path);
  for (const auto& [key, bound] : request.parameters)
    if (importer::is_bound(key)) scene::refuse(value, "'" + key + "' changes what reading the file may take");
  return text_in(value);
}

template <class Part, class Read, class Value>
scene::Option<Part> entry(const std::string& key, Value Part::*member, const Read& read) {
  return scene::option<Part>({.key = key, .required = true}, member, scene::ValueKind<Value>{{}, read});
}

// Adds what each table of an array says to a list.
template <class Item>
scene::Option<Proof> entries(const std::string& key, std::vector<Item> Proof::*list, const scene::Options<Item>& keys) {
  return {{.key = key},
          [=](Proof& proof, const scene::TomlValue& value) {
            for (const scene::TomlValue* table : scene::tables_of(value))
              scene::read_entries((proof.*list).emplace_back(), *table, keys, "[[" + key + "]]");
          },
          {}};
}

void expect_option_of_drawing(const std::pair<std::string, std::string>& option, const scene::TomlValue& where) {
  static const scene::Options<DrawOptions> rows = draw_options();
  const scene::OptionInfo* row = find_option(rows, option.first);
  if (row == nullptr || !is_of_drawing(*row))
    scene::refuse(where, "'" + option.first + "' is not an option of the drawing itself",
                  "a drawing must not write, load or run anything");
  if (names_file(*row, option.second)) expected_below(where, option.second);
}

scene::Options<Proof> keys_of_proof() {
  using Words = std::pair<std::string, std::string>;
  const auto models = [](const scene::TomlValue& value) {
    std::vector<std::string> files;
    if (const auto* list = std::get_if<scene::TomlList>(&value.content))
      for (const scene::TomlValue& one : list->values) files.push_back(model_in(one));
    if (files.empty()) scene::refuse(value, "must be a list of models");
    return files;
  };
  const auto first_version = [](Proof&, const scene::TomlValue& value) {
    if (scene::whole_number(1).read(value) != 1)
      scene::refuse(value, "is of a newer epura", "check it with that epura");
  };
  scene::Options<Words> option{entry<Words>("name", &Words::first, text_in),
                               entry<Words>("value", &Words::second, text_in)};
  option.back().read = [read = option.back().read](Words& words, const scene::TomlValue& value) {
    read(words, value);
    expect_option_of_drawing(words, value);
  };
  scene::Option<ProofInput> attachment = entry<ProofInput>("attachment", &ProofInput::attachment, file_in);
  attachment.required = false;
  return {
      {{.key = "proof", .required = true}, first_version, {}},
      entry<Proof>("epura", &Proof::version, text_in),
      {{.key = "models", .required = true},
       [models](Proof& proof, const scene::TomlValue& value) { proof.models = models(value); },
       {}},
      entries<Words>("option", &Proof::options, option),
      entries<ProofInput>("input", &Proof::inputs,
                          {entry<ProofInput>("file", &ProofInput::file, file_in),
                           entry<ProofInput>("sha256", &ProofInput::sha256, text_in), attachment}),
      entries<Words>("result", &Proof::results,
                     {entry<Words>("file", &Words::first, file_in), entry<Words>("sha256", &Words::second, text_in)})};
}

// Viewers show one list of names, without folders.
std::string free_name(const std::string& name, const std::vector<Attachment>& taken) {
  const auto is_taken = [&](const std::string& tried) {
    return tried == proof_name ||
           std::any_of(taken.begin(), taken.end(), [&](const Attachment& other) { return other.name == tried; });
  };
  std::string free = name;
  for (int number = 2; is_taken(free); ++number) free = std::to_string(number) + "-" + name;
  return free;
}

bool is_scene(const std::string& file) { return to_lower(fs::path(file).extension().string()) == ".toml"; }

}  // namespace

std::string own_version() { return EPURA_VERSION; }

void expect_provable(const DrawOptions& options, const std::vector<pipeline::Target>& targets) {
  const auto refuse = [](const std::string& reason, const std::string& hint) {
    throw Error(ErrorKind::input, "--proof", reason, hint);
  };
  if (std::none_of(targets.begin(), targets.end(), [](const auto& target) { return target.format->has_attachments; }))
    refuse("no output can carry it", "write SVG or PDF");
  if (options.vector.is_inline) refuse("cannot be combined with --inline", "write an SVG file of its own");
  if (options.run.time_limit) refuse("cannot be combined with --time-limit", "a partial drawing is not drawn twice");
  if (options.run.allow_outside)
    refuse("cannot be combined with --allow-outside", "copy the files below the folder of the scene file");
  if (std::find(options.models.begin(), options.models.end(), importer::standard_input) != options.models.end())
    refuse("needs models in files, and standard input is none", "save the model first");
}

std::vector<Attachment> proof_of(const DrawOptions& options, const scene::SceneDescription& scene,
                                 const pipeline::DrawnScene& drawn) {
  const std::vector<fs::path> files = inputs_of(options.models, scene);
  const fs::path folder = common_folder(files);
  const scene::Options<DrawOptions> rows = draw_options();
  Proof proof{own_version(), {}};
  for (const std::string& model : options.models) proof.models.push_back(request_below(folder, model));
  for (const auto& [name, value] : options.given) {
    const scene::OptionInfo* row = find_option(rows, name);
    check(row != nullptr, "options that were given have a row");
    proof.options.emplace_back(name, names_file(*row, value) ? name_below(folder, value) : value);
  }
  std::vector<Attachment> attachments = results_of(drawn, folder);
  for (const Attachment& result : attachments) proof.results.emplace_back(result.name, hash_of_bytes(result.bytes));
  for (const fs::path& file : files) {
    std::string bytes = read_file(file);
    ProofInput& input = proof.inputs.emplace_back(ProofInput{name_below(folder, file.string()), hash_of_bytes(bytes)});
    if (options.vector.proof != output::Proof::model && !is_scene(file.string())) continue;
    input.attachment = free_name(file.filename().string(), attachments);
    attachments.push_back(
        {input.attachment, kind_of(file), "read for this drawing", Relation::source, std::move(bytes)});
  }
  attachments.push_back(
      {proof_name, "application/toml", "how this drawing is made again: epura check", Relation::data, text_of(proof)});
  std::sort(attachments.begin(), attachments.end(),
            [](const Attachment& a, const Attachment& b) { return a.name < b.name; });
  return attachments;
}

Proof read_proof(const fs::path& file) {
  Proof proof;
  scene::read_entries(proof, scene::read_toml(file), keys_of_proof(), "the proof");
  return proof;
}

}  // namespace epura
