// SPDX-License-Identifier: Apache-2.0
// STEP, IGES and BREP files, by Open CASCADE.
#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <NCollection_DataMap.hxx>
#include <Standard_Failure.hxx>
#include <TDF_LabelMapHasher.hxx>
#include <TDF_Tool.hxx>
#include <TDataStd_Name.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <epura/importer_plugin.hpp>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include "model_file.hpp"
#include "shape_writer.hpp"
#include "tessellate.hpp"

namespace {

using namespace epura::plugin;
using namespace epura_occt;

// Names that exporters and Open CASCADE itself make up where there is none.
bool says_something(const std::string& name) {
  static constexpr std::string_view none[]{"SOLID", "COMPOUND", "SHELL", "FACE", "ASSEMBLY", "NONE", "COMPSOLID"};
  return !name.empty() && !name.starts_with("NAUO") && !name.starts_with("=>[") && !name.starts_with("Open CASCADE") &&
         name.find_first_not_of(" '") != std::string::npos &&
         std::find(std::begin(none), std::end(none), name) == std::end(none);
}

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) attribute;
  if (!label.FindAttribute(TDataStd_Name::GetID(), attribute)) return "";
  const TCollection_ExtendedString& wide = attribute->Get();
  std::string name(static_cast<std::size_t>(wide.LengthOfCString()) + 1, 0);
  char* begin = name.data();
  name.resize(static_cast<std::size_t>(wide.ToUTF8CString(begin)));
  return says_something(name) ? name : "";
}

std::string text_of(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.begin(), text.end(), number, std::chars_format::general, 2).ptr;
  return {text.begin(), end};
}

Transform matrix_of(const TopLoc_Location& location) {
  const gp_Trsf transform = location.Transformation();
  Transform rows{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) rows[static_cast<std::size_t>(4 * r + c)] = transform.Value(r + 1, c + 1);
  return rows;
}

class TreeWriter {
 public:
  TreeWriter(const ModelFile& file, const Fineness& fineness, Sink& sink, Watch& watch)
      : file_(file), fineness_(fineness), sink_(sink), watch_(watch) {}

  void write() {
    for (const std::string& note : file_.notes) sink_.note(note);
    TDF_LabelSequence roots;
    file_.shapes->GetFreeShapes(roots);
    for (const TDF_Label& root : roots) write_node(root, EPURA_NONE);
    if (!keeps(distance_, fineness_))
      sink_.note("facets are off curved faces by up to " + text_of(distance_) + " mm, " +
                 text_of(fineness_.deflection) + " mm were wanted; ask for less with :deflection=");
    const auto say = [&](int count, const char* one, const char* many) {
      if (count > 0) sink_.note(std::to_string(count) + (count == 1 ? one : many));
    };
    say(missing_.faces, " face cannot be given facets and is not drawn",
        " faces cannot be given facets and are not drawn");
    say(missing_.wires, " edge without a face is not drawn", " edges without a face are not drawn");
  }

 private:
  void write_node(const TDF_Label& label, std::uint32_t parent) {
    TDF_Label product = label;
    if (XCAFDoc_ShapeTool::IsReference(label)) XCAFDoc_ShapeTool::GetReferredShape(label, product);
    std::string name = name_of(label);
    if (name.empty()) name = name_of(product);
    const Transform place = matrix_of(XCAFDoc_ShapeTool::GetLocation(label));
    if (!XCAFDoc_ShapeTool::IsAssembly(product)) {
      sink_.node(name, parent, shape_of(product, name), place);
      return;
    }
    const std::uint32_t node = sink_.node(name, parent, EPURA_NONE, place);
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(product, components);
    for (const TDF_Label& component : components) write_node(component, node);
  }

  // Its number; every product is handed over once.
  std::uint32_t shape_of(const TDF_Label& product, const std::string& name) {
    if (const std::uint32_t* known = written_.Seek(product)) return *known;
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
    distance_ = std::max(distance_, tessellate(shape, fineness_, watch_));
    const auto name_of_part = [&](const TopoDS_Shape& part) {
      TDF_Label label;
      return file_.shapes->FindSubShape(product, part, label) ? name_of(label) : std::string();
    };
    const Missing missing = write_shape(shape, name, name_of_part, sink_);
    missing_.faces += missing.faces;
    missing_.wires += missing.wires;
    const auto number = static_cast<std::uint32_t>(written_.Extent());
    written_.Bind(product, number);
    return number;
  }

  const ModelFile& file_;
  const Fineness fineness_;
  Sink& sink_;
  Watch& watch_;
  Missing missing_;
  double distance_ = 0;  ///< of facets from their surfaces, mm
  NCollection_DataMap<TDF_Label, std::uint32_t, TDF_LabelMapHasher> written_;
};

double diagonal_of_everything(const ModelFile& file) {
  TDF_LabelSequence roots;
  file.shapes->GetFreeShapes(roots);
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TDF_Label& root : roots) builder.Add(all, XCAFDoc_ShapeTool::GetShape(root));
  return diagonal_of(all);
}

void hand_over(const ModelFile& file, const Source& source, Sink& sink, Watch& watch) {
  double deflection = source.values[0];
  if (std::isnan(deflection)) deflection = source.tolerance_of(diagonal_of_everything(file));
  if (!(deflection > 0)) deflection = 0.01;  // nothing has a size
  const Fineness fineness{deflection, source.values[1] * (std::numbers::pi / 180), source.threads > 1};
  TreeWriter(file, fineness, sink, watch).write();
  sink.progress(1);
}

constexpr std::array parameters{
    number("deflection", "mm", "distance that facets may be off curved faces; by default as the drawing needs it",
           from_box, 1e-6, 1e6),
    number("angle", "deg", "largest angle between neighbouring facets of a curved face", 20, 1, 90)};

template <ModelFile (*read_file)(const std::string&, Watch&)>
void read_by(const Source& source, Sink& sink) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  try {
    const Handle(Watch) watch = new Watch(sink);
    hand_over(read_file(source.path, *watch), source, sink, *watch);
  } catch (const Standard_Failure& failure) {
    const char* text = failure.GetMessageString();
    throw std::runtime_error("makes Open CASCADE fail: " + std::string(failure.DynamicType()->Name()) +
                             (text == nullptr || *text == 0 ? "" : ", ") + (text == nullptr ? "" : text));
  }
}

struct Step {
  static constexpr auto name = "step", summary = "STEP, AP203, AP214 and AP242", extensions = "step|stp|p21";
  static constexpr auto parameters = ::parameters;
  static bool recognises(std::string_view first) { return first.find("ISO-10303-21") < 256; }
  static void read(const Source& source, Sink& sink) { read_by<read_step>(source, sink); }
};

struct Iges {
  static constexpr auto name = "iges", summary = "IGES", extensions = "iges|igs";
  static constexpr auto parameters = ::parameters;
  // The first section's letter stands in column 73.
  static bool recognises(std::string_view first) { return first.size() > 80 && first[72] == 'S' && first[79] == '1'; }
  static void read(const Source& source, Sink& sink) { read_by<read_iges>(source, sink); }
};

struct Brep {
  static constexpr auto name = "brep", summary = "shapes of Open CASCADE", extensions = "brep|brp";
  static constexpr auto parameters = ::parameters;
  static bool recognises(std::string_view first) {
    return first.find("DBRep_DrawableShape") < 64 || first.find("CASCADE Topology") < 64;
  }
  static void read(const Source& source, Sink& sink) { read_by<read_brep>(source, sink); }
};

}  // namespace

EPURA_IMPORTERS(Step, Iges, Brep)
