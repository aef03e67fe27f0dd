// SPDX-License-Identifier: Apache-2.0
// How files are encoded: what the formats of lines, and PNG, let a user choose.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "output/attachments.hpp"
#include "scene/choices.hpp"

template <>
struct epura::scene::Words<epura::SvgText> {
  static constexpr std::array list{"outlines", "text"};
};

namespace epura::output {

/// AutoCAD 2007 (AC1021), the first version with texts in UTF-8, or 2000 (AC1015), the first with line weights.
enum class DxfVersion { r2007, r2000 };

/// Arcs among other lines as bulges of their polylines, and ellipses as such; or all arcs as entities whose ends are
/// those of their neighbours, and ellipses as polylines, for programs that do not know the others.
enum class DxfArcs { bulges, entities };

/// As small as it can be; or for archives (PDF/A-3b) and for people who do not see it (PDF/UA-1).
enum class PdfKind { plain, archive };

/// Likewise SVG: with roles and names for what it shows (WAI-ARIA Graphics Module 1.0).
enum class SvgKind { usual, accessible };

/// What SVG and PDF carry so that `epura check` can draw them again: nothing; options, results and hashes; the models
/// and other files that are read, too.
enum class Proof { none, data, model };

/// Dashes as a property of their line, or each as a stroke of its own (sheet/real_dashes.hpp).
enum class Strokes { dashed, real };

}  // namespace epura::output

template <>
struct epura::scene::Words<epura::output::DxfVersion> {
  static constexpr std::array list{"2007", "2000"};
};
template <>
struct epura::scene::Words<epura::output::PdfKind> {
  static constexpr std::array list{"plain", "archive"};
};
template <>
struct epura::scene::Words<epura::output::SvgKind> {
  static constexpr std::array list{"usual", "accessible"};
};
template <>
struct epura::scene::Words<epura::output::Proof> {
  static constexpr std::array list{"none", "data", "model"};
};
template <>
struct epura::scene::Words<epura::output::Strokes> {
  static constexpr std::array list{"dashed", "real"};
};
template <>
struct epura::scene::Words<epura::output::DxfArcs> {
  static constexpr std::array list{"bulges", "entities"};
};

namespace epura::output {

/// What is one entity in DXF, instead of single lines, fills and texts. Leaders and tables need version 2007.
struct DxfEntities {
  bool dimensions = false, hatches = false, leaders = false, tolerances = false, tables = false;
};

struct DxfEntityWord {
  const char* word;
  bool DxfEntities::*member;
};
inline constexpr std::array dxf_entity_words{
    DxfEntityWord{"dimensions", &DxfEntities::dimensions}, DxfEntityWord{"hatches", &DxfEntities::hatches},
    DxfEntityWord{"leaders", &DxfEntities::leaders}, DxfEntityWord{"tolerances", &DxfEntities::tolerances},
    DxfEntityWord{"tables", &DxfEntities::tables}};

struct VectorOptions {
  bool plain = false;             ///< omit the origin of lines
  std::optional<double> dpi{};    ///< PNG only; usually 300
  std::optional<int> decimals{};  ///< of coordinates in millimetres, SVG only; usually 4: no point is off by more than
                                  ///< 0.0001 mm
  SvgText text = SvgText::outlines;
  Strokes strokes = Strokes::dashed;  ///< of all formats with lines
  Proof proof = Proof::none;
  PdfKind pdf = PdfKind::plain;
  SvgKind svg = SvgKind::usual;  ///< accessible: not plain
  DxfVersion dxf_version = DxfVersion::r2007;
  DxfArcs dxf_arcs = DxfArcs::bulges;
  bool dxf_blocks = false;  ///< DXF: each view is a block
  DxfEntities dxf_entities{};
  bool is_inline = false;                 ///< SVG as an element of an HTML page, as wide as what contains it
  std::string id_prefix{};                ///< of ids and classes in SVG; empty: derived from the content of the sheet
  std::vector<Attachment> attachments{};  ///< of SVG and PDF, sorted by name
};

/// Returns the prefix. Throws Error{input} that names its origin `where`, unless it is a letter followed by letters,
/// digits, hyphens and underscores, 64 characters in all.
std::string checked_id_prefix(std::string prefix, const std::string& where);

inline constexpr double usual_dpi = 300;
inline constexpr int usual_decimals = 4, max_decimals = 5;

}  // namespace epura::output
