// SPDX-License-Identifier: Apache-2.0
#include "definition/rank.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SVD>
#include <Eigen/SparseCore>
#include <Eigen/SparseQR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "definition/limits.hpp"

namespace epura::definition {

namespace {

using Matrix = Eigen::MatrixXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

double largest_of(const Row& row) {
  double largest = 0;
  for (const Term& term : row) largest = std::max(largest, std::abs(term.factor));
  return largest;
}

// Unknowns as multiples of others: those that rows of one or two of them determine.
class Links {
 public:
  explicit Links(int count) : links_(static_cast<std::size_t>(count)) {
    for (int i = 0; i < count; ++i) links_[static_cast<std::size_t>(i)] = {i, 1};
  }

  // The factor is 0 for an unknown that is zero.
  [[nodiscard]] Term root(int unknown) const {
    Term at{unknown, 1};
    for (const Term* next = &link(unknown); next->unknown != at.unknown && at.factor != 0; next = &link(at.unknown))
      at = {next->unknown, at.factor * next->factor};
    if (link(at.unknown).factor == 0) at.factor = 0;
    return at;
  }

  [[nodiscard]] Row reduced(const Row& row) const {
    Row sum;
    for (const Term& term : row)
      if (const Term to = root(term.unknown); to.factor != 0) sum.push_back({to.unknown, term.factor * to.factor});
    sum = tidy(std::move(sum));
    // What is small beside the row as it was is what its terms leave when they cancel.
    std::erase_if(sum, [](const Term& term) { return std::abs(term.factor) <= surely_zero; });
    return sum;
  }

  // Returns whether the row, which is reduced, is used up.
  bool use(const Row& row) {
    if (row.empty()) return true;
    if (row.size() > 2 || largest_of(row) < surely_not_zero) return false;
    const bool is_first = row.size() == 1 || std::abs(row[0].factor) > std::abs(row[1].factor);
    const Term &replaced = row[is_first ? 0 : 1], &kept = row[is_first ? row.size() - 1 : 0];
    links_[static_cast<std::size_t>(replaced.unknown)] =
        row.size() == 1 ? Term{replaced.unknown, 0} : Term{kept.unknown, -kept.factor / replaced.factor};
    return true;
  }

 private:
  [[nodiscard]] const Term& link(int unknown) const { return links_[static_cast<std::size_t>(unknown)]; }

  std::vector<Term> links_;
};

// Uses rows up as long as there are short ones; returns the others, reduced.
std::vector<Row> use_short_rows(Links& links, std::span<const Row> rows) {
  std::vector<Row> open(rows.begin(), rows.end());
  for (bool any = true; any;) {
    any = false;
    std::vector<Row> rest;
    for (Row& row : open)
      if (links.use(links.reduced(row)))
        any = true;
      else
        rest.push_back(std::move(row));
    open = std::move(rest);
  }
  for (Row& row : open) row = links.reduced(row);
  std::erase_if(open, [](const Row& row) { return row.empty(); });
  return open;
}

// Rows that have unknowns in common, and these.
struct Group {
  std::vector<int> unknowns;  // ascending
  std::vector<int> rows;

  [[nodiscard]] int place_of(int unknown) const {
    return static_cast<int>(std::lower_bound(unknowns.begin(), unknowns.end(), unknown) - unknowns.begin());
  }
  [[nodiscard]] Matrix matrix(std::span<const Row> all) const {
    Matrix matrix = Matrix::Zero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(unknowns.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const Term& term : all[static_cast<std::size_t>(rows[i])])
        matrix(static_cast<Eigen::Index>(i), place_of(term.unknown)) = term.factor;
    return matrix;
  }
  // With rows of zeros, so that it has no fewer rows than columns.
  [[nodiscard]] SparseMatrix sparse(std::span<const Row> all) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const Term& term : all[static_cast<std::size_t>(rows[i])])
        entries.emplace_back(static_cast<int>(i), place_of(term.unknown), term.factor);
    SparseMatrix matrix(static_cast<Eigen::Index>(std::max(rows.size(), unknowns.size())),
                        static_cast<Eigen::Index>(unknowns.size()));
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }
};

std::vector<Group> groups_of(std::span<const Row> rows) {
  int count = 0;
  for (const Row& row : rows)
    for (const Term& term : row) count = std::max(count, term.unknown + 1);
  DisjointSets sets(static_cast<std::size_t>(count));
  std::vector<bool> is_used(static_cast<std::size_t>(count), false);
  for (const Row& row : rows)
    for (const Term& term : row) {
      sets.join(row.front().unknown, term.unknown);
      is_used[static_cast<std::size_t>(term.unknown)] = true;
    }
  std::map<int, std::size_t> number;
  std::vector<Group> groups;
  for (int unknown = 0; unknown < count; ++unknown) {
    if (!is_used[static_cast<std::size_t>(unknown)]) continue;
    const auto [group, is_new] = number.try_emplace(sets.root(unknown), groups.size());
    if (is_new) groups.emplace_back();
    groups[group->second].unknowns.push_back(unknown);
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!rows[i].empty()) groups[number[sets.root(rows[i].front().unknown)]].rows.push_back(static_cast<int>(i));
  return groups;
}

/// Where a column is largest, of equal places in the first row.
struct Pivot {
  double size = 0;
  Eigen::Index row = 0;
};

Pivot pivot_of(const Matrix& columns, Eigen::Index column, const std::vector<bool>& is_done) {
  Pivot best;
  for (Eigen::Index i = 0; i < columns.rows(); ++i)
    // Whatever the last digits are.
    if (const double size = std::abs(columns(i, column));
        !is_done[static_cast<std::size_t>(i)] && size > best.size * (1 + surely_zero))
      best = {size, i};
  return best;
}

// Columns that span the same space, each with a row in which it alone is 1: Gauss and Jordan, with largest pivots.
Matrix echelon(Matrix columns) {
  std::vector<bool> is_done(static_cast<std::size_t>(columns.rows()), false);
  std::vector<Pivot> pivots;
  for (Eigen::Index j = 0; j < columns.cols(); ++j) pivots.push_back(pivot_of(columns, j, is_done));
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    const auto first = pivots.begin() + k;
    double largest = 0;
    for (auto one = first; one != pivots.end(); ++one) largest = std::max(largest, one->size);
    auto best = pivots.end();
    for (auto one = first; one != pivots.end(); ++one)
      if (one->size * (1 + surely_zero) >= largest && (best == pivots.end() || one->row < best->row)) best = one;
    check(best != pivots.end() && best->size > 0, "columns are independent");
    columns.col(k).swap(columns.col(best - pivots.begin()));
    std::iter_swap(first, best);
    const Eigen::Index row = first->row;
    columns.col(k) /= columns(row, k);
    is_done[static_cast<std::size_t>(row)] = true;
    for (Eigen::Index j = 0; j < columns.cols(); ++j) {
      if (j == k || columns(row, j) == 0) continue;
      columns.col(j) -= (columns(row, j) * columns.col(k)).eval();
      if (j > k) pivots[static_cast<std::size_t>(j)] = pivot_of(columns, j, is_done);
    }
  }
  return columns;
}

// The smallest singular value of an upper triangle without zeros in its diagonal, from above: by inverse iteration.
double smallest_value(const SparseMatrix& triangle) {
  constexpr int steps = 30;
  Eigen::VectorXd vector = Eigen::VectorXd::Ones(triangle.rows());
  for (Eigen::Index i = 0; i < vector.size(); ++i) vector(i) += 1.0 / static_cast<double>(i + 2);
  double value = 0;
  for (int i = 0; i < steps; ++i) {
    vector.normalize();
    vector = triangle.transpose().triangularView<Eigen::Lower>().solve(vector).eval();
    vector = triangle.triangularView<Eigen::Upper>().solve(vector).eval();
    value = 1 / std::sqrt(vector.norm());
  }
  return value;
}

/// Columns that span the null space of a matrix.
struct Kernel {
  Matrix columns;
  bool is_certain;
};

// What QR leaves of columns that follow from others is below `surely_zero`; the smallest singular value of the triangle
// of the others proves that nothing else follows.
Kernel kernel_by_qr(const SparseMatrix& matrix) {
  Eigen::SparseQR<SparseMatrix, Eigen::COLAMDOrdering<int>> qr;
  qr.setPivotThreshold(surely_zero);
  qr.compute(matrix);
  check(qr.info() == Eigen::Success, "each matrix has a QR factorization");
  const Eigen::Index rank = qr.rank(), count = matrix.cols();
  const SparseMatrix upper = qr.matrixR();
  const SparseMatrix triangle = upper.topLeftCorner(rank, rank);
  Matrix columns = Matrix::Zero(count, count - rank);
  if (rank > 0 && rank < count)
    columns.topRows(rank) =
        -triangle.triangularView<Eigen::Upper>().solve(Matrix(upper.block(0, rank, rank, count - rank)));
  columns.bottomRows(count - rank).setIdentity();
  return {qr.colsPermutation() * columns, rank == 0 || smallest_value(triangle) >= surely_not_zero};
}

// All singular values tell what is nearly free.
Kernel kernel_in_doubt(const Matrix& matrix) {
  const Eigen::BDCSVD<Matrix> svd(matrix, Eigen::ComputeFullV);
  const auto& values = svd.singularValues();
  // Rows were of length 1 before others were put into them: what is left of all of a group may be small.
  const double scale = std::max(values(0), 1.0);
  Eigen::Index rank = 0;
  while (rank < values.size() && values(rank) > surely_zero * scale) ++rank;
  const bool is_certain = rank == 0 || values(rank - 1) >= surely_not_zero * scale;
  return {svd.matrixV().rightCols(matrix.cols() - rank), is_certain};
}

// The null space of a group, over the unknowns of the whole.
NullSpace null_space_of(const Group& group, std::span<const Row> rows) {
  Kernel kernel = kernel_by_qr(group.sparse(rows));
  if (!kernel.is_certain && group.unknowns.size() <= most_in_doubt) kernel = kernel_in_doubt(group.matrix(rows));
  NullSpace found{{}, kernel.is_certain};
  const Matrix free = echelon(std::move(kernel.columns));
  for (Eigen::Index k = 0; k < free.cols(); ++k) {
    Row vector;
    for (Eigen::Index i = 0; i < free.rows(); ++i)
      if (std::abs(free(i, k)) > surely_zero)
        vector.push_back({group.unknowns[static_cast<std::size_t>(i)], free(i, k)});
    found.vectors.push_back(std::move(vector));
  }
  return found;
}

// Which rows follow from earlier ones, and how: by Gram and Schmidt, twice for each row against rounding.
class Followers {
 public:
  explicit Followers(const Matrix& rows) : rows_(rows) {
    const Eigen::Index most = std::min(rows.rows(), rows.cols());
    square_.resize(rows.cols(), most);
    triangle_ = Matrix::Zero(most, most);
  }

  std::vector<DependentRow> find() {
    std::vector<DependentRow> found;
    for (Eigen::Index i = 0; i < rows_.rows(); ++i) {
      const auto rank = static_cast<Eigen::Index>(kept_.size());
      const auto square = square_.leftCols(rank);
      Eigen::VectorXd rest = rows_.row(i).transpose(), factors = Eigen::VectorXd::Zero(rank);
      for (int round = 0; round < 2; ++round) {
        const Eigen::VectorXd along = square.transpose() * rest;
        rest -= square * along;
        factors += along;
      }
      if (rest.norm() > surely_not_zero && rank < square_.cols()) {
        square_.col(rank) = rest.normalized();
        triangle_.col(rank).head(rank) = factors;
        triangle_(rank, rank) = rest.norm();
        kept_.push_back(static_cast<int>(i));
        continue;
      }
      if (rest.norm() > surely_zero) continue;
      factors = triangle_.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(factors).eval();
      DependentRow one{static_cast<int>(i), {}};
      for (Eigen::Index k = 0; k < factors.size(); ++k)
        if (std::abs(factors(k)) > surely_zero) one.others.push_back({kept_[static_cast<std::size_t>(k)], factors(k)});
      found.push_back(std::move(one));
    }
    return found;
  }

 private:
  const Matrix& rows_;
  Matrix square_;    // columns of length 1 that are square to each other and span the rows kept
  Matrix triangle_;  // the rows kept in terms of these
  std::vector<int> kept_;
};

}  // namespace

Row combined(const Row& row, std::span<const Row> vectors) {
  Row sum;
  for (const Term& term : row) add(sum, vectors[static_cast<std::size_t>(term.unknown)], term.factor);
  return tidy(std::move(sum));
}

NullSpace null_space(int count, std::span<const Row> rows) {
  Links links(count);
  const std::vector<Row> open = use_short_rows(links, rows);
  NullSpace found;
  std::vector<bool> is_grouped(static_cast<std::size_t>(count), false);
  for (const Group& group : groups_of(open)) {
    NullSpace more = null_space_of(group, open);
    found.is_certain = found.is_certain && more.is_certain;
    for (Row& vector : more.vectors) found.vectors.push_back(std::move(vector));
    for (const int unknown : group.unknowns) is_grouped[static_cast<std::size_t>(unknown)] = true;
  }
  std::vector<Row> followers(static_cast<std::size_t>(count));  // of each root: itself and what hangs on it
  for (int unknown = 0; unknown < count; ++unknown) {
    const Term to = links.root(unknown);
    if (to.factor != 0) followers[static_cast<std::size_t>(to.unknown)].push_back({unknown, to.factor});
  }
  for (int unknown = 0; unknown < count; ++unknown) {
    const Term to = links.root(unknown);
    if (to.unknown == unknown && to.factor != 0 && !is_grouped[static_cast<std::size_t>(unknown)])
      found.vectors.push_back({{unknown, 1.0}});
  }
  for (Row& vector : found.vectors) vector = combined(vector, followers);
  return found;
}

std::vector<DependentRow> dependent_rows(std::span<const Row> rows) {
  std::vector<DependentRow> found;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].empty()) found.push_back({static_cast<int>(i), {}});
  for (const Group& group : groups_of(rows)) {
    const Matrix matrix = group.matrix(rows);
    for (DependentRow& one : Followers(matrix).find()) {
      one.row = group.rows[static_cast<std::size_t>(one.row)];
      for (Term& term : one.others) term.unknown = group.rows[static_cast<std::size_t>(term.unknown)];
      found.push_back(std::move(one));
    }
  }
  std::sort(found.begin(), found.end(), [](const DependentRow& a, const DependentRow& b) { return a.row < b.row; });
  return found;
}

}  // namespace epura::definition
