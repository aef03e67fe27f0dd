// SPDX-License-Identifier: Apache-2.0
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <fstream>
#include <stdexcept>

#include "large_numbers.hpp"
#include "part21.hpp"
#include "readers.hpp"
#include "session.hpp"
#include "tree.hpp"

namespace occt {

namespace {

TopoDS_Shape shape_in(const std::string& path, const Message_ProgressRange& progress) {
  const std::string damaged = "the file is cut off or damaged: no shape could be read";
  std::ifstream file(path);
  // Open CASCADE looks for the next word for ever where there is none.
  TopoDS_Shape shape;
  try {
    file.exceptions(std::ios::failbit | std::ios::badbit);
    guarded(damaged, [&] { BRepTools::Read(shape, file, BRep_Builder(), progress); });
  } catch (const std::ios::failure&) {
    throw std::runtime_error(damaged);
  }
  if (shape.IsNull()) throw std::runtime_error(damaged);
  return shape;
}

}  // namespace

Model read_brep(const std::string& path, const Beside& beside, epura::plugin::Sink& sink) {
  expect_kind(path, is_brep, "a BREP file of Open CASCADE");
  expect_drawable_brep(text_of(path));
  const Handle(Stage) stage = new Stage(sink, 0, share_of_reading);
  const TopoDS_Shape shape = shape_in(path, stage->Start());
  stage->finish();
  return model_of(shape, beside);
}

Model model_of(const TopoDS_Shape& shape, const Beside& beside) {
  Model model;
  const Attributes attributes;
  TreeBuilder tree(model, attributes, beside.construction);
  tree.add(shape, {}, {{}, EPURA_NONE, EPURA_NONE, gp_Trsf()});
  tree.finish();
  return model;
}

}  // namespace occt
