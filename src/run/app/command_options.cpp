// SPDX-License-Identifier: Apache-2.0
#include "app/command_options.hpp"

#include <climits>
#include <filesystem>
#include <string_view>

#include "app/draw_options.hpp"
#include "base/text.hpp"

namespace epura {

namespace {

scene::ValueKind<std::filesystem::path> path_of_file(const std::string& placeholder) {
  return {file_name(placeholder).form,
          [](const scene::TomlValue& value) { return std::filesystem::path(std::get<std::string>(value.content)); }};
}

scene::ValueKind<std::vector<int>> vertex_numbers() {
  return {{"list of numbers", "VERTICES"}, [](const scene::TomlValue& value) {
            std::vector<int> numbers;
            for (const std::string_view word : split(scene::read_text(value), ',')) {
              const auto number = parse_integer(word);
              if (!number || *number < 0 || *number > INT_MAX)
                scene::refuse(value, "'" + std::string(word) + "' is not the number of a vertex", "as in 0,3,7");
              numbers.push_back(static_cast<int>(*number));
            }
            return numbers;
          }};
}

}  // namespace

scene::Options<InfoOptions> info_options() {
  using Info = InfoOptions;
  return {
      scene::option<Info>(
          {.flag = "models", .help = "model files, as of 'epura draw'", .required = true, .repeatable = true},
          &Info::models, file_name("MODEL...")),
      scene::option<Info>({.flag = "--density", .help = "density of the bodies, for their mass"}, &Info::density,
                          scene::number_between(1e-3, 1e5, "kg/m³").shown_as("D")),
      plugin_path_option<Info>(&Info::plugin_path),
      scene::option<Info>({.flag = "--json", .help = "the same as JSON; - for standard output"}, &Info::json,
                          file_name("FILE")),
  };
}

scene::Options<RequirementsOptions> requirements_options() {
  using Ledger = RequirementsOptions;
  return {
      scene::option<Ledger>({.flag = "models",
                             .help = "model files, as of 'epura draw', or scene files (toml)",
                             .required = true,
                             .repeatable = true},
                            &Ledger::models, file_name("MODEL...")),
      plugin_path_option<Ledger>(&Ledger::plugin_path),
      scene::option<Ledger>(
          {.flag = "--drawing",
           .help = "drawing JSON that 'epura draw' wrote of the models: adds the view, the sheet, the "
                   "zone of its frame, or why the drawing lacks them",
           .repeatable = true},
          &Ledger::drawings, file_name("FILE")),
      scene::option<Ledger>({.flag = "--json", .help = "the same as JSON; - for standard output"}, &Ledger::json,
                            file_name("FILE")),
      scene::option<Ledger>({.flag = "--csv", .help = "the same as a table; - for standard output"}, &Ledger::csv,
                            file_name("FILE")),
      scene::option<Ledger>({.flag = "--as9102",
                             .help = "what is to be measured as a table with the columns of form 3 of AS9102 (first "
                                     "article inspection); - for standard output"},
                            &Ledger::as9102, file_name("FILE")),
      scene::option<Ledger>(
          {.flag = "--qif", .help = "what is to be measured as a plan in QIF 3.0 (ISO 23952); - for standard output"},
          &Ledger::qif, file_name("FILE")),
  };
}

scene::Options<PluginsOptions> plugins_options() {
  using Plugins = PluginsOptions;
  return {
      scene::option<Plugins>(
          {.flag = "name", .help = "projection to show: parameters, matrix, vanishing points"}, &Plugins::name,
          scene::any_text().shown_as("NAME[:key=value]...").completed_by(scene::Completion::projections)),
      scene::option<Plugins>(
          {.flag = "--model", .help = "show how this model is projected: every matrix from the world to the viewport"},
          &Plugins::model, file_name("MODEL")),
      scene::option<Plugins>({.flag = "--trace", .help = "follow this vertex of the model through all matrices"},
                             &Plugins::vertex, scene::whole_number(0).shown_as("VERTEX")),
      scene::option<Plugins>({.flag = "--notation", .help = "of the matrices", .usual = "text"}, &Plugins::notation,
                             scene::choice<MatrixNotation>()),
      plugin_path_option<Plugins>(&Plugins::plugin_path),
  };
}

scene::Options<PictureOptions> picture_options() {
  using Picture = PictureOptions;
  scene::Options<Picture> all{
      scene::option<Picture>(
          {.flag = "projection", .help = "projection to show, NAME[:key=value...]", .required = true},
          &Picture::projection, scene::projection_request()),
      scene::option<Picture>(
          {.flag = "model", .help = "model file, as of 'epura draw'", .required = true},
          [](auto& picture) -> auto& { return picture.draw.models; }, file_name("MODEL")),
      scene::option<Picture>({.flag = "--from", .help = "parallel projection that shows it", .usual = "from the side"},
                             &Picture::from, scene::projection_request()),
      scene::option<Picture>({.flag = "--vertices",
                              .help = "vertices of the model through which rays run, by their numbers as in JSON",
                              .usual = "corners of the outline"},
                             &Picture::vertices, vertex_numbers()),
      scene::option<Picture>(
          {.flag = "--keep-plane", .help = "draw the view plane where it is, even if it cuts the model"},
          &Picture::keeps_plane, scene::truth())};
  scene::append_options(all, one_model_options(), &Picture::draw);
  return all;
}

scene::Options<CheckPluginOptions> check_plugin_options() {
  using Check = CheckPluginOptions;
  return {
      scene::option<Check>({.flag = "file", .help = "the library, e.g. build/mine.so", .required = true}, &Check::file,
                           path_of_file("FILE.so")),
      scene::option<Check>(
          {.flag = "--time-limit",
           .help = "time limit for loading, and for each answer; built-in projections take some milliseconds",
           .usual = format_number(projection::plugin_seconds)},
          &Check::time_limit, scene::number_between(0, 1e6, "s").shown_as("S")),
      scene::option<Check>({.flag = "--picture",
                            .help = "draw each projection seen from outside into this file, as 'epura picture' does"},
                           &Check::picture, file_name("FILE")),
      scene::option<Check>({.flag = "--model", .help = "model of the picture", .usual = "a house"}, &Check::model,
                           file_name("MODEL")),
  };
}

scene::Options<ImportersOptions> importers_options() {
  using Importers = ImportersOptions;
  return {
      scene::option<Importers>({.flag = "name", .help = "importer to show, by its name or an extension of its files"},
                               &Importers::name, scene::any_text().shown_as("NAME")),
      plugin_path_option<Importers>(&Importers::plugin_path),
  };
}

scene::Options<CheckImporterOptions> check_importer_options() {
  using Check = CheckImporterOptions;
  return {
      scene::option<Check>({.flag = "file", .help = "the library, e.g. build/mine.so", .required = true}, &Check::file,
                           path_of_file("FILE.so")),
      scene::option<Check>({.flag = "models", .help = "files that it is to read", .repeatable = true}, &Check::models,
                           path_of_file("MODEL...")),
      scene::option<Check>({.flag = "--time-limit",
                            .help = "seconds for loading it, and again for each file",
                            .usual = format_number(importer::loading_seconds)},
                           &Check::time_limit, scene::number_between(0, 1e6, "s").shown_as("S")),
  };
}

scene::Options<NewProjectionOptions> new_projection_options() {
  return {scene::option<NewProjectionOptions>(
      {.flag = "name", .help = "name of the projection; creates a folder NAME", .required = true},
      &NewProjectionOptions::name, scene::field_text().shown_as("NAME"))};
}

scene::Options<NewSceneOptions> new_scene_options() {
  using New = NewSceneOptions;
  return {
      scene::option<New>({.flag = "model", .help = "model that the scene is to draw", .required = true}, &New::model,
                         file_name("MODEL")),
      scene::option<New>(
          {.flag = "-o,--output", .help = "file to write, in the folder of the model or above", .usual = "MODEL.toml"},
          &New::output, file_name("FILE")),
      plugin_path_option<New>(&New::plugin_path),
  };
}

}  // namespace epura
