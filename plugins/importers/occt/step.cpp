// SPDX-License-Identifier: Apache-2.0
#include <Interface_Static.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <StepBasic_ConversionBasedUnitAndLengthUnit.hxx>
#include <StepBasic_NamedUnit.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <StepShape_SolidModel.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDocStd_Document.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <filesystem>

#include "item_faces.hpp"
#include "large_numbers.hpp"
#include "part21.hpp"
#include "readers.hpp"
#include "requirements.hpp"
#include "saved_views.hpp"
#include "session.hpp"
#include "step_checks.hpp"
#include "step_pictures.hpp"
#include "tree.hpp"
#include "unread.hpp"

namespace occt {

namespace {

/// Usual names of units other than millimetres.
std::string plain_unit(std::string name) {
  for (char& c : name)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (name.find("inch") != std::string::npos || name == "in") return "inches";
  if (name.find("foot") != std::string::npos || name == "ft") return "feet";
  if (name == "metre" || name == "meter" || name == "m") return "metres";
  if (name == "centimetre" || name == "centimeter" || name == "cm") return "centimetres";
  return name;
}

/// The first conversion-based unit of the file, for files whose representations do not name their unit.
std::string converted_unit(const StepData_StepModel& model) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const auto unit = Handle(StepBasic_ConversionBasedUnitAndLengthUnit)::DownCast(model.Value(i));
    if (!unit.IsNull() && !unit->Name().IsNull()) return unit->Name()->ToCString();
  }
  return {};
}

/// Whether a unit of this name is a millimetre, whatever it is called.
bool is_millimetre(const StepData_StepModel& model, const std::string& name) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const auto unit = Handle(StepBasic_ConversionBasedUnitAndLengthUnit)::DownCast(model.Value(i));
    if (unit.IsNull() || unit->Name().IsNull() || name != unit->Name()->ToCString()) continue;
    STEPConstruct_UnitContext context;
    context.ComputeFactors(Handle(StepBasic_NamedUnit)(unit));
    return context.LengthFactor() == 1;
  }
  const std::string unit = plain_unit(name);
  return unit == "millimetre" || unit == "millimeter" || unit == "mm";
}

void note_units(STEPControl_Reader& reader, Model& model) {
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  std::vector<std::string> others;
  for (const TCollection_AsciiString& length : lengths) {
    const std::string name = length.IsEmpty() ? converted_unit(*reader.StepModel()) : length.ToCString();
    const std::string unit = plain_unit(name);
    if (!unit.empty() && !is_millimetre(*reader.StepModel(), name) &&
        std::find(others.begin(), others.end(), unit) == others.end())
      others.push_back(unit);
  }
  for (const std::string& unit : others) model.notes.push_back("the file is in " + unit + ": converted to millimetres");
}

/// Calls visit(entity, shape) for each entity of a kind in the file that has become a shape, where that is not moved.
template <class Entity, class Visit>
void visit_shapes(const STEPControl_Reader& reader, const Visit& visit) {
  const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  const Handle(StepData_StepModel) model = reader.StepModel();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto entity = Handle(Entity)::DownCast(model->Value(i));
    if (entity.IsNull()) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
    if (!shape.IsNull()) visit(*entity, shape.Located(TopLoc_Location()));
  }
}

/// The names of solids and surfaces, since XCAF has only the names of products.
Names names_of_bodies(const STEPControl_Reader& reader) {
  Names names;
  const auto bind = [&](const StepRepr_RepresentationItem& item, const TopoDS_Shape& shape) {
    const std::string name = item.Name().IsNull() ? "" : meaningful(item.Name()->ToCString());
    if (!name.empty()) names.Bind(shape, name);
  };
  visit_shapes<StepShape_SolidModel>(reader, bind);
  visit_shapes<StepShape_ShellBasedSurfaceModel>(reader, bind);
  return names;
}

Products products_of(const STEPControl_Reader& reader) {
  Products products;
  visit_shapes<StepBasic_ProductDefinition>(
      reader, [&](const StepBasic_ProductDefinition&, const TopoDS_Shape& shape) { products.Add(shape); });
  return products;
}

/// Shapes of files without products, such as sketches.
std::vector<TopoDS_Shape> shapes_without_products(STEPControl_Reader& reader) {
  const Handle(StepData_StepModel) model = reader.StepModel();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto representation = Handle(StepShape_ShapeRepresentation)::DownCast(model->Value(i));
    if (!representation.IsNull()) reader.TransferEntity(representation);
  }
  std::vector<TopoDS_Shape> shapes;
  for (int i = 1; i <= reader.NbShapes(); ++i) shapes.push_back(reader.Shape(i));
  return shapes;
}

/// Lines of annotations that say nothing else, or how many are not drawn.
void add_annotations(Model& model, std::string_view text, const Pictures& pictures, bool are_drawn) {
  const std::size_t lost = pictures.annotations.size() - (are_drawn ? add_pictures(model, text, pictures) : 0);
  if (lost == 0) return;
  model.notes.push_back(counted(lost, "annotation") + " of the file " + (lost == 1 ? "is a picture" : "are pictures") +
                        " without a meaning that is read: not drawn" +
                        (are_drawn || !may_have_pictures(model) ? "" : " (FILE:annotations=draw draws its lines)"));
}

[[noreturn]] void throw_shapeless(const std::string& text, const std::string& faults) {
  const std::string unread = unread_shapes_in_step(text);
  const std::string& reason = unread.empty() ? faults : unread;
  throw std::runtime_error("holds no shape" + (reason.empty() ? std::string() : ": " + reason));
}

}  // namespace

Model read_step(const std::string& file, const Beside& beside, epura::plugin::Sink& sink) {
  // By default, Open CASCADE looks for referenced files in the working folder.
  const std::string path = std::filesystem::absolute(file).string();
  expect_kind(path, is_step, "a STEP file: it does not begin with ISO-10303-21");
  if (end_of(path).find("END-ISO-10303-21") == std::string::npos) throw cut_off(path, "END-ISO-10303-21");
  const std::string text = text_of(path);
  expect_drawable_step(text);
  STEPCAFControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  const Handle(Complaints) complaints = Complaints::install();
  STEPCAFControl_Reader reader;
  reader.SetColorMode(true);
  reader.SetLayerMode(false);
  reader.SetPropsMode(false);
  reader.SetGDTMode(false);
  reader.SetMatMode(false);
  reader.SetViewMode(false);
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("is not a valid STEP file" +
                             (complaints->line().empty() ? "" : ": it is damaged in line " + complaints->line()));
  sink.progress(share_of_reading / 4);
  const Handle(StepData_StepModel) entities = reader.ChangeReader().StepModel();
  expect_no_cycle(entities);
  Model model;
  model.notes = without_foreign_files(reader.ChangeReader(), path);
  const std::string broken = faults_of(entities, Fault::reference);
  if (!broken.empty()) throw std::runtime_error("the file is damaged: " + broken);
  expect_rigid_places(entities);
  const std::string faults = faults_of(entities, Fault::value);
  if (!faults.empty()) model.notes.push_back(faults);
  const std::string parabolas = trim_parabolas_by_points(entities);
  if (!parabolas.empty()) model.notes.push_back(parabolas);
  note_units(reader.ChangeReader(), model);

  const Handle(Stage) stage = new Stage(sink, share_of_reading / 4, share_of_reading);
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  const bool is_transferred = reader.Transfer(document, stage->Start());
  stage->finish();
  const Attributes attributes{names_of_bodies(reader.Reader()), colours_of(document), products_of(reader.Reader())};
  TreeBuilder tree(model, attributes, beside.construction);
  if (is_transferred)
    add_document(document, tree);
  else
    for (const TopoDS_Shape& shape : shapes_without_products(reader.ChangeReader()))
      tree.add(shape, {}, {{}, EPURA_NONE, EPURA_NONE, gp_Trsf()});
  tree.finish();
  if (model.parts.empty()) throw_shapeless(text, faults);
  StepRequirements stated = requirements_in_step(text);
  find_faces(stated.all, reader.Reader());
  model.requirements = std::move(stated.all);
  model.saved_views = saved_views_of(reader.Reader(), text, model.notes);
  add_annotations(model, text, stated.pictures, beside.annotations);
  const std::vector<std::string> unread = unread_in_step(text, stated.read);
  model.standard = std::move(stated.standard);
  model.notes.insert(model.notes.end(), unread.begin(), unread.end());
  return model;
}

}  // namespace occt
