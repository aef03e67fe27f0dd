// SPDX-License-Identifier: Apache-2.0
#include "definition/rebuild.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

#include "definition/limits.hpp"

namespace epura::definition {

namespace {

/// Rows without their last term, and what is left of them where the faces are.
struct Equations {
  Eigen::SparseMatrix<double> rows;
  Eigen::VectorXd left;
};

Equations equations_of(const std::vector<Statement>& statements, std::span<const Row> base, int count,
                       const std::vector<double>& values) {
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> left;
  const auto add_row = [&](const Row& row, double said) {
    double length = 0, now = 0;
    for (const Term& term : row) {
      if (term.unknown < count)
        length += term.factor * term.factor;
      else
        now = term.factor;
    }
    if (!(length > 0)) return;
    length = std::sqrt(length);
    const int number = static_cast<int>(left.size());
    for (const Term& term : row)
      if (term.unknown < count) entries.emplace_back(number, term.unknown, term.factor / length);
    left.push_back((said - now) / length);
  };
  for (const Row& row : base) {
    Row with_value = row;
    with_value.push_back({count, values[static_cast<std::size_t>(row.front().unknown)]});
    add_row(with_value, 0);
  }
  for (const Statement& statement : statements)
    for (const Row& row : statement.rows)
      if (statement.is_certain) add_row(row, statement.more);
  Equations found{{static_cast<Eigen::Index>(left.size()), count},
                  Eigen::Map<const Eigen::VectorXd>(left.data(), static_cast<Eigen::Index>(left.size()))};
  found.rows.setFromTriplets(entries.begin(), entries.end());
  return found;
}

}  // namespace

Rebuilt rebuild(const Unknowns& unknowns, std::span<const Row> base, const StateAll& state_all, double off,
                unsigned seed) {
  constexpr int most_steps = 30;
  const int count = unknowns.count();
  std::mt19937 random(seed);
  Rebuilt found;
  for (int i = 0; i < count; ++i) {
    const double unit = static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    found.begun.push_back(off * (2 * unit - 1));
  }
  found.values = found.begun;
  for (int step = 0; step < most_steps && !found.is_settled; ++step) {
    const std::vector<Statement> said = state_all(unknowns.changed_by(found.values));
    const Equations equations = equations_of(said, base, count, found.values);
    Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double>> solver(equations.rows);
    solver.setTolerance(rounding);
    solver.setMaxIterations(std::max(1000, 10 * count));
    const Eigen::VectorXd change = solver.solve(equations.left);
    for (int i = 0; i < count; ++i) found.values[static_cast<std::size_t>(i)] += change[i];
    found.left = equations.left.size() > 0 ? equations.left.cwiseAbs().maxCoeff() : 0;
    found.is_settled = change.cwiseAbs().maxCoeff() <= surely_zero * surely_not_zero;
  }
  return found;
}

}  // namespace epura::definition
