// SPDX-License-Identifier: Apache-2.0
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>

#include "readers.hpp"
#include "session.hpp"
#include "tree.hpp"

namespace occt {

Model read_brep(const std::string& path, Construction construction, epura::plugin::Sink& sink) {
  expect_kind(path, is_brep, "a BREP file of Open CASCADE");
  const Handle(Stage) stage = new Stage(sink, 0, share_of_reading);
  TopoDS_Shape shape;
  const std::string damaged = "the file is cut off or damaged: no shape could be read";
  const bool is_read =
      guarded(damaged, [&] { return BRepTools::Read(shape, path.c_str(), BRep_Builder(), stage->Start()); });
  stage->finish();
  if (!is_read || shape.IsNull()) throw std::runtime_error(damaged);
  Model model;
  const Attributes attributes;
  TreeBuilder tree(model, attributes, construction);
  tree.add(shape, {}, {{}, EPURA_NONE, EPURA_NONE, gp_Trsf()});
  tree.finish();
  return model;
}

}  // namespace occt
