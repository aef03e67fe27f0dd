// SPDX-License-Identifier: Apache-2.0
// The options of a drawing: one table for the command line, its help, completion and the manual.
#pragma once

#include "app/options.hpp"
#include "pipeline/run_values.hpp"
#include "scene/option.hpp"

namespace epura {

scene::Options<DrawOptions> draw_options();

/// Those of a drawing of one model whose views are not chosen: of outputs, the model, the sheet and the run.
scene::Options<DrawOptions> one_model_options();

/// The options of `epura explain`.
scene::Options<DrawOptions> explain_options();

/// The options of `epura lint`.
scene::Options<DrawOptions> lint_options();
/// The options of `epura define`.
scene::Options<DrawOptions> define_options();

// Rows shared by several commands.
template <class Command, class Member>
scene::Option<Command> threads_option(Member threads) {
  return scene::option<Command>({.flag = "--threads", .help = "number of threads, 0 for all cores", .usual = "0"},
                                threads, pipeline::thread_count());
}

template <class Command>
scene::Option<Command> progress_option(ShowProgress Command::*progress) {
  return scene::option<Command>({.flag = "--progress", .help = "show progress; auto: on a terminal", .usual = "auto"},
                                progress, scene::choice<ShowProgress>().shown_as("WHEN"));
}

template <class Command, class Member>
scene::Option<Command> plugin_path_option(Member folders) {
  return {{.flag = "--plugin-path",
           .form = scene::any_text().shown_as("DIR").completed_by(scene::Completion::folders).form,
           .help = "additional folder with plugins",
           .nature = scene::Nature::code,
           .repeatable = true},
          [folders](Command& command, const scene::TomlValue& value) {
            std::invoke(folders, command).emplace_back(scene::read_text(value));
          }};
}

template <class Command, class Member>
scene::Option<Command> allow_outside_option(Member allowed) {
  return scene::option<Command>({.flag = "--allow-outside",
                                 .help = "let scene files and models name files that do not lie below their folders",
                                 .nature = scene::Nature::code},
                                allowed, scene::truth());
}

template <class Command>
scene::Option<Command> projections_option(const std::string& help,
                                          std::vector<scene::Located<scene::ProjectionRequest>> Command::*requests) {
  return scene::option<Command>({.flag = "--projection", .help = help, .usual = "isometric", .repeatable = true},
                                requests, scene::projection_request());
}

template <class Command>
scene::Option<Command> views_option(const std::string& help,
                                    std::vector<scene::Located<scene::ProjectionRequest>> Command::*views) {
  return {
      {.flag = "--views", .form = {.placeholder = "NAMES", .completion = scene::Completion::projections}, .help = help},
      [views](Command& command, const scene::TomlValue& value) {
        for (const scene::LocatedText& name : scene::each_word(value))
          (command.*views)
              .push_back({scene::projection_request().read(scene::value_of_option(name.where, *name)), name.where});
      }};
}

/// Whether an option decides what is drawn, or what is found out about it: such options a sheet carries with it, and a
/// stranger may give.
bool is_of_drawing(const scene::OptionInfo& option);

/// Whether a value of an option is the name of a file.
bool names_file(const scene::OptionInfo& option, const std::string& value);

/// The row with this name on the command line: its long flag, or one of its switches; null if there is none.
const scene::Option<DrawOptions>* find_option(const scene::Options<DrawOptions>& options, const std::string& name);

/// The name of a file or folder to read or to write.
scene::ValueKind<std::string> file_name(const std::string& placeholder);

}  // namespace epura
