// SPDX-License-Identifier: Apache-2.0
// Reads 3MF, the format of 3D printers.
#include <epura/importer_plugin.hpp>
#include <string_view>

#include "hand_over.hpp"
#include "model.hpp"
#include "package.hpp"

namespace epura::plugin::threemf {

namespace {

struct ThreeMf {
  static constexpr auto name = "3mf", summary = "3MF, the format of 3D printers", extensions = "3mf";

  static bool recognises(std::string_view first_bytes) {
    constexpr std::string_view archive("PK\3\4");
    return first_bytes.substr(0, archive.size()) == archive && first_bytes.find("3D/") != std::string_view::npos;
  }

  static void read(const Source& source, Sink& sink) {
    const Package package(source.path);
    constexpr double parsed = 0.9;
    const Model model = read_model(package, [&](double done) { sink.progress(parsed * done); });
    hand_over(model, sink);
  }
};

}  // namespace

}  // namespace epura::plugin::threemf

EPURA_IMPORTER(epura::plugin::threemf::ThreeMf)
