// SPDX-License-Identifier: Apache-2.0
// Checks of a STEP file after its entities are read and before shapes are made of them.
#pragma once

#include <STEPControl_Reader.hxx>
#include <string>
#include <vector>

namespace occt {

/// Throws if an assembly contains itself: Open CASCADE would follow it endlessly.
void expect_no_cycle(const Handle(StepData_StepModel) & model);

/// Throws if an item places a shape by an operator that scales or mirrors it: Open CASCADE 7.6.3 would place it
/// unscaled, and turned for mirrored (findings/occt-step-scales.sh).
void expect_rigid_places(const Handle(StepData_StepModel) & model);

/// Has parabolas trimmed by their points where the file gives these: Open CASCADE 7.6.3 reads and writes parameters
/// that are not those of ISO 10303-42 (findings/occt-step-parabolas.sh), so where others end depends on the program
/// that wrote them. Tells of those by their number and the first; "" if there are none.
std::string trim_parabolas_by_points(const Handle(StepData_StepModel) & model);

/// A reference to an entity that is missing or has a wrong type, which Open CASCADE follows without a check; or another
/// invalid value.
enum class Fault { reference, value };

/// Entities of the shape with such faults: the first one and their number; "" if there are none.
std::string faults_of(const Handle(StepData_StepModel) & model, Fault kind);

/// Voids references to files outside the folder of the file, so that they are not followed; returns a sentence for each
/// of them, and for each missing file.
std::vector<std::string> without_foreign_files(STEPControl_Reader& reader, const std::string& path);

}  // namespace occt
