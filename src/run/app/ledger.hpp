// SPDX-License-Identifier: Apache-2.0
// The ledger of what model files require, as `epura requirements` writes it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "importer/requirements.hpp"
#include "report/report.hpp"
#include "surfaces/recognise.hpp"

namespace epura {

struct LedgerRow : importer::ModelRequirement {
  int characteristic;              ///< its number in an inspection; 0: it is not measured
  report::RequirementRow shown{};  ///< where the drawing shows it, if there is one
};

/// The ledger of one model.
struct Ledger {
  std::string model;
  std::string counts;  ///< in words
  std::vector<LedgerRow> requirements;
  std::shared_ptr<const surfaces::PartFaces> part{};  ///< whose faces they name; null if the file has none
  double unit = 1;                                    ///< of the part, mm
  std::string standard{};                             ///< that the file names; empty: none
};

/// "sheet 1, zone B4, view front" where a drawing shows it, otherwise "plate.step #120".
std::string reference_location(const Ledger& ledger, const LedgerRow& row);

/// What of it is not read, and why it is not drawn; empty if there is nothing to say.
std::string comments_on(const LedgerRow& row);

/// The ledger as a plan in the Quality Information Framework, QIF 3.0 (ISO 23952:2020): definitions, nominals and items
/// of all characteristics with the features that they belong to, and datums. The same files give the same bytes.
std::string qif_of(const std::vector<Ledger>& ledgers);

}  // namespace epura
