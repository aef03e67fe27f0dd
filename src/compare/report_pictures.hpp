// SPDX-License-Identifier: Apache-2.0
// A comparison as a case of a report, with its pictures.
#pragma once

#include <string>

#include "compare/comparison.hpp"
#include "compare/html_report.hpp"

namespace epura::compare {

ReportedCase add_pictures(ReportedCase reported, const PictureFile& expected, const PictureFile& actual,
                          const Comparison& comparison);

}  // namespace epura::compare
