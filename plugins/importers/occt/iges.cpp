// SPDX-License-Identifier: Apache-2.0
// IGES has hardly any products: its faces and solids are independent, so they become one part.
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>

#include "iges_arcs.hpp"
#include "large_numbers.hpp"
#include "part21.hpp"
#include "readers.hpp"
#include "session.hpp"
#include "tree.hpp"
#include "unread.hpp"

namespace occt {

namespace {

/// Whether the last line is that of section T.
bool has_end(std::string_view bytes) {
  constexpr std::size_t section = 72;
  const auto last = bytes.find_last_not_of("\r\n \x1a\0");
  if (last == std::string_view::npos) return false;
  const auto before = bytes.find_last_of("\r\n", last);
  const std::string_view line = bytes.substr(before == std::string_view::npos ? 0 : before + 1);
  return line.size() > section && line[section] == 'T';
}

void note_unit(const IGESData_GlobalSection& header, Model& model) {
  constexpr double metre_in_mm = 1000;
  const double millimetres = header.UnitValue() * (header.CascadeUnit() > 0 ? header.CascadeUnit() : 1);
  if (!(millimetres > 0) || std::abs(millimetres - 1) < 1e-9) return;
  const Handle(TCollection_HAsciiString) name = header.UnitName();
  std::string unit = name.IsNull() ? std::string() : name->ToCString();
  if (unit == "IN" || unit == "INCH") unit = "inches";
  if (unit == "M" || millimetres == metre_in_mm) unit = "metres";
  model.notes.push_back("the file is in " + (unit.empty() ? "another unit" : unit) + ": converted to millimetres");
}

}  // namespace

Model read_iges(const std::string& path, const Beside& beside, epura::plugin::Sink& sink) {
  expect_kind(path, is_iges, "an IGES file: column 73 of its first line is not S");
  // Open CASCADE crashes on some files without it.
  if (!has_end(end_of(path))) throw cut_off(path, "the line of section T");
  const std::string text = text_of(path);
  expect_drawable_iges(text);
  IGESControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  IGESCAFControl_Reader reader;
  reader.SetColorMode(true);
  reader.SetLayerMode(false);
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("the file is cut off or damaged: its sections could not be read");
  if (!reader.IGESModel().IsNull()) {
    combine_matrices(reader.IGESModel());
    align_arcs(reader.IGESModel());
  }
  const Handle(Stage) stage = new Stage(sink, share_of_reading / 4, share_of_reading);
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  reader.Transfer(document, stage->Start());
  stage->finish();
  Model model;
  if (!reader.IGESModel().IsNull()) note_unit(reader.IGESModel()->GlobalSection(), model);

  TopoDS_Compound everything;
  const BRep_Builder builder;
  builder.MakeCompound(everything);
  Attributes attributes{{}, colours_of(document)};
  TDF_LabelSequence roots;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(roots);
  for (const TDF_Label& root : roots) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(root);
    if (shape.IsNull()) continue;
    builder.Add(everything, shape);
    const std::string name = name_of(root);
    if (!name.empty()) attributes.names.Bind(shape.Located(TopLoc_Location()), name);
  }
  TreeBuilder tree(model, attributes, beside.construction);
  tree.add(everything, {}, {{}, EPURA_NONE, EPURA_NONE, gp_Trsf()});
  tree.finish();
  const std::vector<std::string> unread = unread_in_iges(text);
  model.notes.insert(model.notes.end(), unread.begin(), unread.end());
  return model;
}

}  // namespace occt
