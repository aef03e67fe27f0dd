// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string_view>
#include <variant>

#include "app/draw_options.hpp"
#include "base/text.hpp"
#include "serve/serve.hpp"

namespace epura {

namespace {

using Serve = ServeOptions;

// Options that give the drawing other views, or views of something else than the whole models, or that other formats
// than SVG have.
bool is_for_other_drawings(const scene::OptionInfo& option) {
  constexpr std::array<std::string_view, 12> others{"-o,--output", "--format",  "--views",     "--section",
                                                    "--detail",    "--explode", "--break",     "--layout",
                                                    "--dpi",       "--inline",  "--max-error", "--density"};
  return option.nature == scene::Nature::run || option.flag.starts_with("--dxf-") ||
         std::find(others.begin(), others.end(), option.flag) != others.end();
}

// "--title=Flange", as one word: no value is taken for an option or a model.
std::string word_of(const scene::OptionInfo& option, const scene::TomlValue& value) {
  const std::string& text = std::get<std::string>(value.content);
  for (const scene::Switch& one : option.switches)
    if (one.word == text) return one.flag;
  const std::string name = option.flag.substr(option.flag.rfind(',') + 1);
  return option.form.placeholder.empty() ? name : name + "=" + text;
}

scene::Option<Serve> for_all_drawings(const scene::Option<DrawOptions>& row) {
  const auto read = [row](Serve& serve, const scene::TomlValue& value) {
    row.read(serve.draw, value);
    if (row.flag != "models" && row.flag != "--projection") serve.words.push_back(word_of(row, value));
  };
  return {row, read, {}};
}

}  // namespace

scene::Options<ServeOptions> serve_options() {
  scene::Options<Serve> all;
  for (const scene::Option<DrawOptions>& row : draw_options()) {
    if (is_for_other_drawings(row)) continue;
    all.push_back(for_all_drawings(row));
    if (row.flag == "models") all.back().help = "model files, as of 'epura draw'";
    if (row.flag != "--projection") continue;
    all.back().help = "projection with which the page begins, NAME[:key=value...]; 'epura plugins' lists them";
    all.back().repeatable = false;
  }
  const Serve usual;
  const auto add = [&all](scene::Option<Serve> option) {
    option.nature = scene::Nature::run;
    all.push_back(std::move(option));
  };
  add(scene::option<Serve>({.flag = "--port", .help = "port on 127.0.0.1", .usual = "any that is free"}, &Serve::port,
                           scene::whole_number(1024, 65535)));
  add(scene::option<Serve>(
      {.flag = "--job-time", .help = "time limit of a drawing, which ends it", .usual = format_number(usual.job_time)},
      &Serve::job_time, scene::number_between(0.1, 1e6, "s").shown_as("S")));
  add(scene::option<Serve>(
      {.flag = "--job-memory", .help = "memory limit of a drawing", .usual = format_number(usual.job_memory)},
      &Serve::job_memory, scene::number_between(50, 1e9, "MB").shown_as("MB")));
  return all;
}

}  // namespace epura
