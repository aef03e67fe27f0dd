// SPDX-License-Identifier: Apache-2.0
// Order and names of elements are those of the schema of QIF 3.0 (qifstandards.org), QIFDocument.xsd.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/hash.hpp"
#include "app/ledger.hpp"
#include "app/qif_characteristics.hpp"
#include "base/text.hpp"
#include "composition/requirement_words.hpp"
#include "scene/choices.hpp"

namespace epura {

namespace {

using importer::RequirementKind;
using surfaces::PartFace;
using surfaces::SurfaceKind;

constexpr const char* uuid_space = "urn:epura:qif";

/// What a face is in the document; 0: QIF has no feature of its kind.
struct FeatureIds {
  int definition = 0, nominal = 0, item = 0;
};

/// The faces and datums of one model.
struct ModelIds {
  int part = 0;
  std::map<int, FeatureIds> features{};
  std::map<std::string, int> datums{}, frames{};
  std::vector<int> targets{};
};

bool is_target(const LedgerRow& row) { return row.type == "datum target"; }

const char* feature_kind(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::plane:
      return "Plane";
    case SurfaceKind::cylinder:
      return "Cylinder";
    case SurfaceKind::cone:
      return "Cone";
    case SurfaceKind::sphere:
      return "Sphere";
    default:
      return nullptr;
  }
}

std::string vector_text(const Vec3& v) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) text += (axis > 0 ? " " : "") + format_number(v[axis]);
  return text;
}

// Adds a list; the number of its items is known at its end.
template <class AddItems>
void add_list(pugi::xml_node parent, const char* name, const AddItems& add_items) {
  pugi::xml_node list = parent.append_child(name);
  list.append_attribute("n") = 0;
  add_items(list);
  const auto count = std::distance(list.children().begin(), list.children().end());
  if (count == 0)
    parent.remove_child(list);
  else
    list.attribute("n") = static_cast<unsigned>(count);
}

pugi::xml_node with_id(pugi::xml_node list, const std::string& name, int id) {
  pugi::xml_node node = list.append_child(name.c_str());
  node.append_attribute("id") = id;
  return node;
}

void add_unit(pugi::xml_node unit, const char* of, const char* name, double factor) {
  qif::add_text(unit, "SIUnitName", of);
  qif::add_text(unit, "UnitName", name);
  qif::add_number(unit.append_child("UnitConversion"), "Factor", factor);
}

// "A", "B-C (maximum material requirement)"
std::vector<std::string> letters_of(const std::string& cell) {
  return pipeline::items_of(cell.substr(0, cell.find(" (")), "-");
}

void add_reference(pugi::xml_node datum, const std::string& words, const ModelIds& model) {
  const std::vector<std::string> letters = letters_of(words);
  const auto add_simple = [&](pugi::xml_node parent, const std::string& letter) {
    pugi::xml_node simple = parent.append_child("SimpleDatum");
    qif::add_text(simple, "DatumDefinitionId", std::to_string(model.datums.at(letter)));
    qif::add_text(simple, "MaterialModifier", qif::material_of(words));
    qif::add_text(simple, "ReferencedComponent", "ACTUAL");
  };
  if (letters.size() == 1) return add_simple(datum, letters.front());
  add_list(datum, "CompoundDatum", [&](pugi::xml_node list) {
    for (std::size_t i = 0; i < letters.size(); ++i) {
      pugi::xml_node one = list.append_child("Datum");
      add_simple(one, letters[i]);
      qif::add_text(one, "SequenceNumber", std::to_string(i + 1));
    }
  });
}

void add_frame(pugi::xml_node frame, const std::string& words, const ModelIds& model) {
  constexpr std::array ranks{"PRIMARY", "SECONDARY", "TERTIARY", "QUATERNARY", "QUINARY", "SENARY"};
  add_list(frame, "Datums", [&](pugi::xml_node list) {
    const std::vector<std::string> cells = pipeline::items_of(words, " | ");
    for (std::size_t i = 0; i < cells.size() && i < ranks.size(); ++i) {
      pugi::xml_node datum = list.append_child("Datum");
      add_reference(datum, cells[i], model);
      qif::add_text(datum.append_child("Precedence"), "PrecedenceEnum", ranks[i]);
    }
  });
}

void add_size(pugi::xml_node definition, const PartFace& face, double scale) {
  if (face.surface.kind == SurfaceKind::plane) return;
  qif::add_text(definition, "InternalExternal", face.inwards ? "INTERNAL" : "EXTERNAL");
  qif::add_number(definition, "Diameter", 2 * face.surface.radius * scale);
  if (face.surface.kind == SurfaceKind::cone)
    qif::add_number(definition, "HalfAngle", std::atan(std::abs(face.surface.slope)) * 180 / std::numbers::pi);
}

void add_place(pugi::xml_node nominal, const PartFace& face, double scale) {
  const surfaces::PartSurface& surface = face.surface;
  const bool has_axis = surfaces::has_axis(surface.kind);
  if (!has_axis) {
    qif::add_text(nominal, "Location", vector_text(surface.origin * scale));
    if (surface.kind == SurfaceKind::plane) qif::add_text(nominal, "Normal", vector_text(surface.axis));
    return;
  }
  // The axis of a cone points to where it widens.
  pugi::xml_node axis = nominal.append_child("Axis");
  qif::add_text(axis, "AxisPoint", vector_text(surface.origin * scale));
  qif::add_text(axis, "Direction", vector_text(surface.slope < 0 ? -surface.axis : surface.axis));
}

void add_item(pugi::xml_node item, const Ledger& ledger, const LedgerRow& row, const qif::CharacteristicLinks& links) {
  const std::string comments = comments_on(row);
  qif::add_text(item, "Description", reference_location(ledger, row) + (comments.empty() ? "" : "; " + comments));
  qif::add_text(item, "Name", row.id);
  const std::string model = std::filesystem::path(ledger.model).filename().string();
  pugi::xml_node designator = item.append_child("CharacteristicDesignator");
  qif::add_text(designator, "Designator", std::to_string(row.characteristic));
  const std::string own = uuid_of(row.id, uuid_of(model, uuid_of(uuid_space)));
  qif::add_text(designator, "UUID", is_uuid(row.name) ? to_lower(row.name) : own);
  qif::add_ids(item, "FeatureItemIds", links.feature_items);
}

/// Builds the document section by section.
class QifDocument {
 public:
  explicit QifDocument(const std::vector<Ledger>& ledgers)
      : ledgers_(ledgers), models_(ledgers.size()), root_(xml_.append_child("QIFDocument")) {
    bool any = false, all = true;
    const double inch = scene::millimetres(Unit::in);
    for (const Ledger& ledger : ledgers)
      for (const LedgerRow& row : ledger.requirements) {
        if (row.is_angle != 0 || row.unit <= 0) continue;
        any = true;
        all = all && row.unit == inch;
      }
    if (any && all) units_.length = inch;
  }

  std::string write() {
    const int standard = begin();
    number();
    add_datums();
    add_product();
    add_features();
    add_characteristics(standard);
    pugi::xml_node steps = root_.append_child("Plan").append_child("UnorderedPlanRoot").append_child("Steps");
    steps.append_attribute("n") = 1;
    steps.append_child("MeasureEvaluateAll");
    root_.attribute("idMax") = last_id_;
    root_.child("QPId").text().set(uuid_of(printed(), uuid_of(uuid_space)).c_str());
    return printed();
  }

 private:
  int next_id() { return ++last_id_; }

  [[nodiscard]] std::string printed() const {
    std::ostringstream out;
    xml_.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
    return out.str();
  }

  // Organization and designator of the first one that a file names; otherwise that of signs in its unit.
  [[nodiscard]] std::pair<std::string, std::string> standard_of(bool is_inch) const {
    for (const Ledger& ledger : ledgers_)
      for (const char* organization : {"ASME", "ISO"})
        if (const std::string before = std::string(organization) + " "; ledger.standard.starts_with(before))
          return {organization, ledger.standard.substr(before.size(), ledger.standard.find(", ") - before.size())};
    return is_inch ? std::pair("ASME", "Y14.5") : std::pair("ISO", "1101");
  }

  // Returns the id of the standard.
  int begin() {
    const std::string space = "http://qifstandards.org/xsd/qif3";
    root_.append_attribute("xmlns") = space.c_str();
    root_.append_attribute("xmlns:xsi") = "http://www.w3.org/2001/XMLSchema-instance";
    root_.append_attribute("xsi:schemaLocation") = (space + " QIFDocument.xsd").c_str();
    root_.append_attribute("versionQIF") = "3.0.0";
    root_.append_attribute("idMax") = 0;
    root_.append_child("QPId");
    pugi::xml_node header = root_.append_child("Header");
    qif::add_text(header.append_child("Application"), "Name", "epura");
    qif::add_text(header, "Scope", "Plan");
    const int id = next_id();
    pugi::xml_node standards = root_.append_child("StandardsDefinitions");
    standards.append_attribute("n") = 1;
    pugi::xml_node standard = standards.append_child("Standard");
    standard.append_attribute("id") = id;
    const bool is_inch = units_.length != 1;
    const auto [organization, designator] = standard_of(is_inch);
    qif::add_text(standard.append_child("Organization"), "StandardsOrganizationEnum", organization);
    qif::add_text(standard, "Designator", designator);
    pugi::xml_node primary = root_.append_child("FileUnits").append_child("PrimaryUnits");
    add_unit(primary.append_child("AngularUnit"), "radian", "degree", std::numbers::pi / 180);
    add_unit(primary.append_child("LinearUnit"), "meter", is_inch ? "inch" : "mm", units_.length / 1000);
    return id;
  }

  // Ids come before what refers to them.
  void number() {
    for (std::size_t m = 0; m < ledgers_.size(); ++m) {
      ModelIds& ids = models_[m];
      ids.part = next_id();
      for (const LedgerRow& row : ledgers_[m].requirements) {
        for (const int face : row.faces)
          if (const PartFace* of = face_at(m, face); of != nullptr && feature_kind(of->surface.kind) != nullptr)
            if (FeatureIds& feature = ids.features[face]; feature.item == 0)
              feature = {next_id(), next_id(), next_id()};
        if (row.kind == RequirementKind::datum && !is_target(row)) number_datum(ids, row.datums);
        if (row.kind != RequirementKind::tolerance || row.datums.empty() || ids.frames.contains(row.datums)) continue;
        ids.frames.emplace(row.datums, next_id());
        for (const std::string& cell : pipeline::items_of(row.datums, " | "))
          for (const std::string& letter : letters_of(cell)) number_datum(ids, letter);
      }
    }
  }

  void number_datum(ModelIds& ids, const std::string& letter) {
    if (!ids.datums.contains(letter)) ids.datums.emplace(letter, next_id());
  }

  [[nodiscard]] const PartFace* face_at(std::size_t model, int face) const {
    const auto& part = ledgers_[model].part;
    return part == nullptr ? nullptr : &part->faces[static_cast<std::size_t>(face)];
  }

  [[nodiscard]] qif::CharacteristicLinks links_of(std::size_t model, const LedgerRow& row) const {
    qif::CharacteristicLinks links;
    for (const int face : row.faces)
      if (const auto feature = models_[model].features.find(face); feature != models_[model].features.end()) {
        links.nominal_features.push_back(feature->second.nominal);
        links.feature_items.push_back(feature->second.item);
      }
    if (const auto frame = models_[model].frames.find(row.datums); frame != models_[model].frames.end())
      links.datum_frame = frame->second;
    return links;
  }

  template <class Visit>
  void for_each_row(const Visit& visit) const {
    for (std::size_t m = 0; m < ledgers_.size(); ++m)
      for (const LedgerRow& row : ledgers_[m].requirements) visit(m, row);
  }

  void add_datums() {
    add_list(root_, "DatumDefinitions", [&](pugi::xml_node list) {
      for (std::size_t m = 0; m < models_.size(); ++m)
        for (const auto& [letter, id] : models_[m].datums) {
          pugi::xml_node datum = with_id(list, "DatumDefinition", id);
          qif::add_text(datum, "DatumLabel", letter);
          const std::vector<LedgerRow>& rows = ledgers_[m].requirements;
          const auto row = std::find_if(rows.begin(), rows.end(), [&letter = letter](const LedgerRow& one) {
            return one.kind == RequirementKind::datum && one.datums == letter;
          });
          if (row != rows.end()) qif::add_ids(datum, "FeatureNominalIds", links_of(m, *row).nominal_features);
        }
    });
    add_list(root_, "DatumTargetDefinitions", [&](pugi::xml_node list) {
      for_each_row([&](std::size_t m, const LedgerRow& row) {
        if (!is_target(row)) return;
        models_[m].targets.push_back(next_id());
        pugi::xml_node target = with_id(list, "DatumTarget", models_[m].targets.back());
        qif::add_text(target, "DatumTargetLabel", row.datums);
        if (const auto features = links_of(m, row).nominal_features; !features.empty())
          qif::add_text(target, "FeatureNominalId", std::to_string(features.front()));
      });
    });
    add_list(root_, "DatumReferenceFrames", [&](pugi::xml_node list) {
      for (const ModelIds& model : models_)
        for (const auto& [words, id] : model.frames) add_frame(with_id(list, "DatumReferenceFrame", id), words, model);
    });
  }

  void add_product() {
    pugi::xml_node product = root_.append_child("Product");
    add_list(product, "PartSet", [&](pugi::xml_node list) {
      for (std::size_t m = 0; m < ledgers_.size(); ++m) {
        const std::string name = std::filesystem::path(ledgers_[m].model).filename().string();
        pugi::xml_node part = with_id(list, "Part", models_[m].part);
        part.append_attribute("label") = name.c_str();
        qif::add_text(part, "UUID", uuid_of(name, uuid_of(uuid_space)));
        qif::add_text(part, "ModelNumber", name);
      }
    });
    if (models_.size() == 1)
      qif::add_text(product.append_child("RootPart"), "Id", std::to_string(models_.front().part));
  }

  template <class Visit>
  void for_each_feature(const Visit& visit) const {
    for (std::size_t m = 0; m < models_.size(); ++m)
      for (const auto& [number, ids] : models_[m].features) visit(m, number, ids, *face_at(m, number));
  }

  [[nodiscard]] double scale_of(std::size_t model) const { return ledgers_[model].unit / units_.length; }

  void add_features() {
    pugi::xml_node features = root_.append_child("Features");
    const auto named = [](const PartFace& face, const char* aspect) {
      return feature_kind(face.surface.kind) + std::string("Feature") + aspect;
    };
    add_list(features, "FeatureDefinitions", [&](pugi::xml_node list) {
      for_each_feature([&](std::size_t m, int, const FeatureIds& ids, const PartFace& face) {
        add_size(with_id(list, named(face, "Definition"), ids.definition), face, scale_of(m));
      });
    });
    add_list(features, "FeatureNominals", [&](pugi::xml_node list) {
      for_each_feature([&](std::size_t m, int, const FeatureIds& ids, const PartFace& face) {
        pugi::xml_node nominal = with_id(list, named(face, "Nominal"), ids.nominal);
        qif::add_text(nominal, "FeatureDefinitionId", std::to_string(ids.definition));
        add_place(nominal, face, scale_of(m));
      });
    });
    add_list(features, "FeatureItems", [&](pugi::xml_node list) {
      for_each_feature([&](std::size_t, int number, const FeatureIds& ids, const PartFace& face) {
        pugi::xml_node item = with_id(list, named(face, "Item"), ids.item);
        qif::add_text(item, "FeatureNominalId", std::to_string(ids.nominal));
        qif::add_text(item, "FeatureName", "face " + std::to_string(number));
        item.append_child("DeterminationMode").append_child("Checked");
      });
    });
    if (!features.first_child()) root_.remove_child(features);
  }

  // Datums are no characteristics.
  template <class Visit>
  void for_each_characteristic(const Visit& visit) const {
    std::size_t at = 0;
    for_each_row([&](std::size_t m, const LedgerRow& row) {
      if (importer::is_measured(row.kind)) visit(m, row, at++);
    });
  }

  void add_characteristics(int standard) {
    std::vector<std::pair<int, int>> ids;  // of definitions and nominals
    for_each_characteristic([&](std::size_t, const LedgerRow&, std::size_t) {
      const int definition = next_id();
      ids.emplace_back(definition, next_id());
    });
    if (ids.empty()) return;
    pugi::xml_node all = root_.append_child("Characteristics");
    qif::add_text(all, "FormalStandardId", std::to_string(standard));
    const auto named = [](const LedgerRow& row, const qif::CharacteristicLinks& links, const char* aspect) {
      return qif::kind_of(row, links) + "Characteristic" + aspect;
    };
    add_list(all, "CharacteristicDefinitions", [&](pugi::xml_node list) {
      for_each_characteristic([&](std::size_t m, const LedgerRow& row, std::size_t at) {
        const qif::CharacteristicLinks links = links_of(m, row);
        pugi::xml_node definition = with_id(list, named(row, links, "Definition"), ids[at].first);
        const std::string words = pipeline::requirement_sentence(row);
        qif::add_text(definition, "Description", words);
        qif::add_definition(definition, row, links, words, units_);
      });
    });
    add_list(all, "CharacteristicNominals", [&](pugi::xml_node list) {
      for_each_characteristic([&](std::size_t m, const LedgerRow& row, std::size_t at) {
        const qif::CharacteristicLinks links = links_of(m, row);
        pugi::xml_node nominal = with_id(list, named(row, links, "Nominal"), ids[at].second);
        qif::add_text(nominal, "CharacteristicDefinitionId", std::to_string(ids[at].first));
        qif::add_nominal(nominal, row, links, units_);
      });
    });
    add_list(all, "CharacteristicItems", [&](pugi::xml_node list) {
      for_each_characteristic([&](std::size_t m, const LedgerRow& row, std::size_t at) {
        if (row.characteristic == 0) return;
        const qif::CharacteristicLinks links = links_of(m, row);
        add_item(with_id(list, named(row, links, "Item"), next_id()), ledgers_[m], row, links);
        qif::add_text(list.last_child(), "CharacteristicNominalId", std::to_string(ids[at].second));
      });
    });
  }

  const std::vector<Ledger>& ledgers_;
  std::vector<ModelIds> models_;
  qif::Units units_{};
  int last_id_ = 0;
  pugi::xml_document xml_{};
  pugi::xml_node root_;
};

}  // namespace

std::string qif_of(const std::vector<Ledger>& ledgers) { return QifDocument(ledgers).write(); }

}  // namespace epura
