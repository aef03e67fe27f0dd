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

/// Where least is left so far.
struct Best {
  Equations equations{};
  std::vector<double> values{};
  double left = HUGE_VAL;
};

// The step to what the rows say; with damping, a shorter one.
Eigen::VectorXd step_of(const Equations& equations, double damping) {
  const Eigen::Index count = equations.rows.cols();
  Eigen::SparseMatrix<double> rows(equations.rows.rows() + count, count);
  Eigen::VectorXd left = Eigen::VectorXd::Zero(rows.rows());
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index column = 0; column < count; ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(equations.rows, column); entry; ++entry)
      entries.emplace_back(static_cast<int>(entry.row()), static_cast<int>(column), entry.value());
    if (damping > 0)
      entries.emplace_back(static_cast<int>(equations.rows.rows() + column), static_cast<int>(column), damping);
  }
  rows.setFromTriplets(entries.begin(), entries.end());
  left.head(equations.left.size()) = equations.left;
  Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double>> solver(rows);
  solver.setTolerance(rounding);
  solver.setMaxIterations(std::max<Eigen::Index>(1000, 10 * count));
  return solver.solve(left);
}

}  // namespace

Rebuilt rebuild(const Unknowns& unknowns, std::span<const Row> base, const StateAll& state_all, double off,
                unsigned seed) {
  constexpr int most_steps = 60;
  const double settled = surely_zero * surely_not_zero;
  const int count = unknowns.count();
  std::mt19937 random(seed);
  Rebuilt found;
  for (int i = 0; i < count; ++i) {
    const double unit = static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    found.begun.push_back(off * (2 * unit - 1));
  }
  found.values = found.begun;
  Best best;
  double damping = 0;
  for (int step = 0; step < most_steps && !found.is_settled; ++step) {
    const Equations equations = equations_of(state_all(unknowns.changed_by(found.values)), base, count, found.values);
    const double left = equations.left.norm();
    const bool is_downhill = left <= (1 + surely_zero) * best.left + settled;
    damping = is_downhill ? damping / damping_step : std::max(least_damping, damping) * damping_step;
    if (damping < least_damping) damping = 0;
    if (is_downhill) best = {equations, found.values, left};
    const Eigen::VectorXd change = step_of(best.equations, damping);
    found.values = best.values;
    for (int i = 0; i < count; ++i) found.values[static_cast<std::size_t>(i)] += change[i];
    found.left = best.equations.left.size() > 0 ? best.equations.left.cwiseAbs().maxCoeff() : 0;
    found.is_settled = damping == 0 && change.cwiseAbs().maxCoeff() <= settled;
  }
  return found;
}

}  // namespace epura::definition
