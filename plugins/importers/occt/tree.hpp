// SPDX-License-Identifier: Apache-2.0
// Converts shapes of Open CASCADE to parts and positions: a shape in several positions becomes one part if the file
// says so.
#pragma once

#include <NCollection_IndexedDataMap.hxx>
#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <epura/importer_plugin.hpp>

#include "bodies.hpp"
#include "model.hpp"

namespace occt {

class TreeBuilder {
 public:
  TreeBuilder(Model& model, const Attributes& attributes, Construction construction)
      : model_(model), attributes_(attributes), construction_(construction) {}

  /// Adds the shape where `place` says, after its own location. `part_name` is that of the shape wherever it occurs;
  /// `company` is in the same product as the shape.
  void add(const TopoDS_Shape& shape, const std::string& part_name, Place place, const Company& company = {});
  std::uint32_t add_assembly(Place place);

  /// Whether the shape is that of a product, not one of several representations of one.
  [[nodiscard]] bool is_product(const TopoDS_Shape& shape) const;

  /// Adds notes about omitted parts of the shapes.
  void finish();

 private:
  /// A shape: its part, and parts of it that occur in it several times.
  struct Prototype {
    std::uint32_t part = EPURA_NONE;
    std::vector<Place> inside;
  };

  /// What a shape consists of.
  struct Content {
    Bodies bodies;
    std::vector<TopoDS_Edge> wires;
    std::size_t endless = 0;  ///< other edges outside faces, which are infinite or have no curve
    std::vector<gp_Pnt> points;
  };

  Prototype make(const TopoDS_Shape& shape, const std::string& name, const Company& company);
  void omit_construction(Content& content, const Company& company);
  void separate_repeats(std::vector<TopoDS_Shape>& bodies, Prototype& prototype);
  std::uint32_t add_part(const std::string& name, const std::vector<TopoDS_Shape>& bodies);
  [[nodiscard]] std::string name_of(const TopoDS_Shape& body) const;
  [[nodiscard]] std::optional<Colour> colour_of(const TopoDS_Shape& body) const;

  Model& model_;
  const Attributes& attributes_;
  Construction construction_;
  NCollection_IndexedDataMap<TopoDS_Shape, Prototype, TopTools_ShapeMapHasher> prototypes_;
  std::size_t endless_ = 0, loose_ = 0, sewn_into_ = 0;
  std::size_t omitted_surfaces_ = 0, omitted_lines_ = 0, omitted_points_ = 0;
};

/// Adds the tree of an XCAF document.
void add_document(const Handle(TDocStd_Document) & document, TreeBuilder& tree);

/// The colours of an XCAF document.
Colours colours_of(const Handle(TDocStd_Document) & document);

/// "" for names made up by programs, such as "NAUO12", "=>[0:1:1:2]", "SOLID".
std::string meaningful(const std::string& name);

/// The name of a shape of an XCAF document, in UTF-8, if it is meaningful.
std::string name_of(const TDF_Label& label);

}  // namespace occt
