// SPDX-License-Identifier: Apache-2.0
// Requirements of model files in the signs of drawings. ISO 129-1, ISO 14405-1, ISO 1101.
#pragma once

#include <string>

#include "importer/requirements.hpp"
#include "scene/description.hpp"

namespace epura::pipeline {

/// How a sheet is written.
struct Manner {
  Unit unit = Unit::mm;  ///< of dimensions
  bool is_asme = false;  ///< in the signs of ASME Y14.5, not ISO
};

/// Writes the value, tolerance and modifiers of a requirement into a dimension, with the digits of the file: numbers in
/// another unit than that of the sheet have their unit behind them. Returns why that is not possible; empty if it is
/// done.
std::string write_value(scene::DimensionDescription& dimension, const importer::ModelRequirement& requirement,
                        const Manner& manner);

/// A dimension that `write_value` has written, as a note: "R5 ±0.1". Limits have a line each. `measured`, mm or
/// degrees, stands where the file gives no value.
scene::NoteText value_note(const scene::DimensionDescription& dimension, const std::string& sign,
                           const importer::ModelRequirement& requirement, const Manner& manner, double measured);

/// Writes a geometric tolerance into a frame. Returns the same.
std::string write_frame(scene::ToleranceFrame& frame, const importer::ModelRequirement& requirement,
                        const Manner& manner);

/// A datum target without its place; `with_size`: its size is in the symbol.
scene::DatumTarget target_of(const importer::ModelRequirement& requirement, bool with_size, const Manner& manner);

scene::SurfaceTexture texture_of(const importer::ModelRequirement& requirement);

/// A note that stands at the end of a leader, in lines of some words.
scene::NoteText note_of(const importer::ModelRequirement& requirement);

/// What a scene states, as a file would, without its id and faces; numbers are in `unit`, that of the sheets, or in
/// degrees. Throws Error{input} for texts that are no values.
importer::ModelRequirement requirement_of(const scene::RequirementDescription& words, Unit unit);

/// Adds words to a list that stands above a frame: "4×, between".
void add_above(scene::ToleranceFrame& frame, const std::string& words);

}  // namespace epura::pipeline
