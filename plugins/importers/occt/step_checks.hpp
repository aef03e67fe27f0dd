// SPDX-License-Identifier: Apache-2.0
// What is looked at in a STEP file between reading its entities and making shapes of them.
#pragma once

#include <STEPControl_Reader.hxx>
#include <string>
#include <vector>

namespace occt {

/// Throws if an assembly contains itself: Open CASCADE would follow it for ever.
void expect_no_cycle(const Handle(StepData_StepModel) & model);

/// A reference to an entity that is missing or of a wrong type, which Open CASCADE follows blindly; or another value
/// that is not as it should be.
enum class Fault { reference, value };

/// Entities of the shape with such faults: the first one, and how many; "" if there are none.
std::string faults_of(const Handle(StepData_StepModel) & model, Fault kind);

/// Makes references to files outside the folder of the file void, so that they are not followed; returns a sentence for
/// each, and for each file that is missing.
std::vector<std::string> without_foreign_files(STEPControl_Reader& reader, const std::string& path);

}  // namespace occt
