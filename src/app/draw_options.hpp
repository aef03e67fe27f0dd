// SPDX-License-Identifier: Apache-2.0
// The options of a drawing: one table for the command line, its help, completion and the manual.
#pragma once

#include "app/options.hpp"
#include "scene/option.hpp"

namespace epura {

Options<DrawOptions> draw_options();

/// Those of `epura explain`.
Options<DrawOptions> explain_options();

// Rows that several commands have.
template <class Command, class Member>
Option<Command> threads_option(Member threads) {
  return option<Command>({.flag = "--threads", .help = "number of threads, 0 for all cores", .usual = "0"}, threads,
                         whole_number(0, 1024));
}

template <class Command>
Option<Command> progress_option(ShowProgress Command::*progress) {
  return option<Command>({.flag = "--progress", .help = "show how far it is (auto: on a terminal)", .usual = "auto"},
                         progress, choice<ShowProgress>().shown_as("WHEN"));
}

template <class Command, class Member>
Option<Command> plugin_path_option(Member folders) {
  return {{.flag = "--plugin-path",
           .form = any_text().shown_as("DIR").completed_by(Completion::folders).form,
           .help = "more folders with projection plugins",
           .nature = Nature::code,
           .repeatable = true},
          [folders](Command& command, const TomlValue& value) {
            std::invoke(folders, command).emplace_back(read_text(value));
          }};
}

template <class Command>
Option<Command> projections_option(const std::string& help,
                                   std::vector<Located<ProjectionRequest>> Command::*requests) {
  return option<Command>({.flag = "--projection", .help = help, .usual = "isometric", .repeatable = true}, requests,
                         projection_request());
}

/// Files, or folders, to read or to write.
ValueKind<std::string> file_name(const std::string& placeholder);

}  // namespace epura
