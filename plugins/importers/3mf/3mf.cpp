// SPDX-License-Identifier: Apache-2.0
// Reads 3MF, the format of 3D printers.
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "components.hpp"
#include "model.hpp"
#include "package.hpp"

namespace epura::plugin::threemf {

namespace {

/// Positions objects according to items and components, with each shape once.
class Tree {
 public:
  Tree(const Model& model, Sink& sink) : model_(model), sink_(sink) {}

  /// The levels have already been counted.
  void add(const Placed& placed, std::uint32_t parent) {
    const auto found = model_.objects.find(placed.object);
    if (found == model_.objects.end()) throw std::runtime_error("places an object that is not there");
    const Object& object = found->second;
    const std::string& name = placed.name.empty() ? object.name : placed.name;
    if (++nodes_ > most_parts) throw std::runtime_error("puts down more than " + std::to_string(most_parts) + " parts");
    const std::uint32_t node = sink_.node(name, parent, shape_of(placed.object, object), placed.transform);
    for (const Placed& component : object.components) add(component, node);
  }

  void tell_left_out() {
    if (beams_ > 0)
      sink_.note(std::to_string(beams_) + (beams_ == 1 ? " beam" : " beams") + " of lattices are not drawn");
    if (slices_ > 0) sink_.note("slices are not drawn");
  }

 private:
  std::uint32_t shape_of(std::uint32_t id, const Object& object) {
    const auto found = shapes_.find(id);
    if (found != shapes_.end()) return found->second;
    beams_ += object.beams;
    slices_ += object.has_slices ? 1 : 0;
    std::uint32_t shape = EPURA_NONE;
    if (!object.triangles.empty()) {
      shape = sink_.shape(object.name);
      if (object.colour) sink_.colour((*object.colour)[0], (*object.colour)[1], (*object.colour)[2]);
      sink_.points(object.points);
      sink_.triangles(object.triangles);
    }
    shapes_.emplace(id, shape);
    return shape;
  }

  const Model& model_;
  Sink& sink_;
  std::map<std::uint32_t, std::uint32_t> shapes_;
  std::size_t nodes_ = 0, beams_ = 0, slices_ = 0;
};

// For a model without build items: the objects that are not components.
std::vector<Placed> tops_of(const Model& model) {
  std::map<std::uint32_t, bool> is_part;
  for (const auto& [id, object] : model.objects)
    for (const Placed& component : object.components) is_part[component.object] = true;
  std::vector<Placed> tops;
  for (const auto& [id, object] : model.objects)
    if (!is_part[id]) tops.push_back({id, identity});
  return tops;
}

struct ThreeMf {
  static constexpr auto name = "3mf", summary = "3MF, the format of 3D printers", extensions = "3mf";

  static bool recognises(std::string_view first_bytes) {
    constexpr std::string_view archive("PK\3\4");
    return first_bytes.substr(0, archive.size()) == archive && first_bytes.find("3D/") != std::string_view::npos;
  }

  static void read(const Source& source, Sink& sink) {
    const Package package = read_package(source.path);
    constexpr double unpacked = 0.1, parsed = 0.9;
    sink.progress(unpacked);
    bool is_cancelled = false;
    const Model model = [&] {
      const auto goes_on = [&](double done) {
        try {
          sink.progress(unpacked + (parsed - unpacked) * done);
        } catch (const Cancelled&) {
          is_cancelled = true;
        }
        return !is_cancelled;
      };
      try {
        return read_model(package.bytes, goes_on);
      } catch (const std::exception&) {
        if (is_cancelled) throw Cancelled{};
        throw;
      }
    }();
    sink.unit(model.millimetres);
    sink.rounding(EPURA_SINGLE | EPURA_PRINTED);
    for (const std::string& warning : model.warnings) sink.note(warning);
    if (package.degenerate > 0)
      sink.note(std::to_string(package.degenerate) + (package.degenerate == 1 ? " triangle" : " triangles") +
                " with two equal corners left out");
    const bool builds = !model.items.empty();
    if (!builds && !model.objects.empty()) sink.note("builds nothing: all of its objects are drawn");
    Tree tree(model, sink);
    for (const Placed& item : builds ? model.items : tops_of(model)) tree.add(item, EPURA_NONE);
    tree.tell_left_out();
  }
};

}  // namespace

}  // namespace epura::plugin::threemf

EPURA_IMPORTER(epura::plugin::threemf::ThreeMf)
