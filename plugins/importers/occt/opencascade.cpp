// SPDX-License-Identifier: Apache-2.0
// Reads STEP, IGES and BREP files by Open CASCADE, with the faces and edges of the part in addition to the triangles.
#include <array>
#include <epura/parameter_rows.hpp>
#include <stdexcept>
#include <string>

#include "address.hpp"
#include "hand_over.hpp"
#include "readers.hpp"
#include "session.hpp"
#include "tessellation.hpp"

namespace {

using epura::plugin::Sink;
using epura::plugin::Source;

constexpr std::array<epura_parameter, 4> parameters_of_step{
    epura::plugin::number("deflection", "mm",
                          "distance between curved surfaces and their facets; as the drawing needs unless given",
                          epura::plugin::from_box, 1e-6, 1e6),
    epura::plugin::number("angle", "deg", "between neighbouring facets of a round face at most", 20, 1, 60),
    epura::plugin::choice("construction", "datum planes, sketches and points beside the solids of a part", "omit|draw",
                          0),
    epura::plugin::choice("annotations", "lines of annotations without a meaning that is read", "omit|draw", 0)};

/// Annotations are read of STEP only.
constexpr std::array<epura_parameter, 3> parameters_of_all{parameters_of_step[0], parameters_of_step[1],
                                                           parameters_of_step[2]};

using Read = occt::Model (*)(const std::string&, const occt::Beside&, Sink&);

/// What `read` makes of what is to be drawn beside bodies, in the facets that the source asks for.
template <class Reading>
void tell(const Reading& read, bool annotations, const Source& source, Sink& sink) {
  const occt::Silence silence;
  occt::Complaints::install();
  const auto construction = source.values[2] != 0 ? occt::Construction::draw : occt::Construction::omit;
  const occt::Beside beside{construction, annotations};
  occt::Model model = occt::guarded("cannot be read", [&] { return read(beside); });
  if (model.parts.empty())
    throw std::runtime_error("holds no face and no line to draw" +
                             (model.notes.empty() ? std::string() : ": " + model.notes.front()));
  const occt::Fineness chosen = occt::guarded("cannot be tessellated", [&] {
    const occt::Extent extent = occt::extent_of(model);
    const double given = source.values[0];
    const double tolerance = (given > 0 ? given : source.tolerance_of(extent.diagonal)) / extent.scale;
    occt::Fineness fineness{tolerance, source.values[1], source.threads};
    if (!(given > 0)) fineness = occt::affordable(model, fineness);
    occt::tessellate(model, fineness, sink);
    return fineness;
  });
  occt::guarded("cannot be handed over", [&] { occt::hand_over(model, chosen, sink); });
}

void import(Read read, const Source& source, Sink& sink) {
  tell([&](const occt::Beside& beside) { return read(source.path, beside, sink); },
       read == occt::read_step && source.values[3] != 0, source, sink);
}

struct Step {
  static constexpr auto name = "step";
  static constexpr auto summary = "STEP (ISO 10303-21: AP203, AP214, AP242), by Open CASCADE";
  static constexpr auto extensions = "step|stp|p21";
  static constexpr auto& parameters = parameters_of_step;

  static bool recognises(std::string_view first_bytes) { return occt::is_step(first_bytes); }
  static void read(const Source& source, Sink& sink) { import(occt::read_step, source, sink); }
};

struct Iges {
  static constexpr auto name = "iges";
  static constexpr auto summary = "IGES 5.3, by Open CASCADE";
  static constexpr auto extensions = "iges|igs";
  static constexpr auto& parameters = parameters_of_all;

  static bool recognises(std::string_view first_bytes) { return occt::is_iges(first_bytes); }
  static void read(const Source& source, Sink& sink) { import(occt::read_iges, source, sink); }
};

struct Brep {
  static constexpr auto name = "brep";
  static constexpr auto summary = "shapes as Open CASCADE writes them";
  static constexpr auto extensions = "brep|brp";
  static constexpr auto& parameters = parameters_of_all;

  static bool recognises(std::string_view first_bytes) { return occt::is_brep(first_bytes); }
  static void read(const Source& source, Sink& sink) { import(occt::read_brep, source, sink); }
};

}  // namespace

EPURA_IMPORTERS(Step, Iges, Brep)

/// Hands over the TopoDS_Shape at an address of this process, as the importer of BREP does one in a file: `source` has
/// no path, and its values are those of that importer's parameters. For epura's module for Python.
extern "C" EPURA_EXPORT const char* epura_opencascade_shape_v1(const void* address, const epura_source* source,
                                                               const epura_sink* sink) {
  return epura::plugin::importer::answer(source, sink, [&](const Source& wanted, Sink& to) {
    tell([&](const occt::Beside& beside) { return occt::model_of(occt::shape_at(address), beside); }, false, wanted,
         to);
  });
}
