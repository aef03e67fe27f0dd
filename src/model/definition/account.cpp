// SPDX-License-Identifier: Apache-2.0
#include "definition/account.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "definition/limits.hpp"
#include "definition/rank.hpp"

namespace epura::definition {

namespace {

using Rigid = std::array<double, 6>;

double dot(const Rigid& a, const Rigid& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

// What is left of a vector beside unit vectors that are square to each other.
Rigid rest_of(Rigid vector, const std::vector<Rigid>& basis) {
  for (const Rigid& unit : basis) {
    const double along = dot(vector, unit);
    for (std::size_t i = 0; i < 6; ++i) vector[i] -= along * unit[i];
  }
  return vector;
}

// Changes as the whole part makes them, and a choice of these.
class Relative {
 public:
  Relative(const Part& part, const Unknowns& unknowns) : part_(part), unknowns_(unknowns) {
    for (int i = 0; i < unknowns.count(); ++i) rigid_.push_back(unknowns.rigid(i));
    largest_first_.resize(part.faces.size());
    std::iota(largest_first_.begin(), largest_first_.end(), 0);
    std::stable_sort(largest_first_.begin(), largest_first_.end(),
                     [&](int a, int b) { return area_of(a) > area_of(b); });
  }

  // Relative to the face to which most of the area keeps still.
  [[nodiscard]] Motion motion(const Row& change) const {
    Changes changes{std::vector<double>(rigid_.size(), 0.0), 0};
    std::vector<int> moving;
    for (const Term& term : change) {
      changes.values[static_cast<std::size_t>(term.unknown)] = term.factor;
      changes.largest = std::max(changes.largest, std::abs(term.factor));
      if (const int face = unknowns_[term.unknown].face; moving.empty() || moving.back() != face)
        moving.push_back(face);
    }
    Rigid best{};
    double least = 0;
    for (const int face : moving) least += area_of(face);
    for (const int face : moving) {
      const Rigid whole = holding(face, changes.values);
      // A later one must be better by more than the last digits.
      const double enough = least * (1 - same_size);
      if (const double area = moving_area(changes, whole, enough); area < enough) {
        least = area;
        best = whole;
      }
    }
    Motion found;
    for (int face = 0; face < static_cast<int>(part_.faces.size()); ++face)
      for (int i = unknowns_.first(face); i < unknowns_.first(face + 1); ++i)
        if (const double value = value_beside(changes, best, i); value != 0) {
          found.change.push_back({i, value});
          if (found.faces.empty() || found.faces.back() != face) found.faces.push_back(face);
        }
    return found;
  }

 private:
  struct Changes {
    std::vector<double> values;
    double largest;  // of their absolute values
  };

  [[nodiscard]] double area_of(int face) const { return part_.faces[static_cast<std::size_t>(face)].area; }

  // What is left of an unknown's change when the whole part goes back.
  [[nodiscard]] double value_beside(const Changes& changes, const Rigid& whole, int unknown) const {
    const auto i = static_cast<std::size_t>(unknown);
    const double value = changes.values[i] - dot(rigid_[i], whole);
    return std::abs(value) <= moves * changes.largest ? 0 : value;
  }

  // Of the faces that move beside the whole, or more than `enough`.
  [[nodiscard]] double moving_area(const Changes& changes, const Rigid& whole, double enough) const {
    double area = 0;
    for (const int face : largest_first_) {
      bool moves_on = false;
      for (int i = unknowns_.first(face); i < unknowns_.first(face + 1) && !moves_on; ++i)
        moves_on = value_beside(changes, whole, i) != 0;
      if (moves_on) area += area_of(face);
      if (area > enough) break;
    }
    return area;
  }

  // The least motion of the whole part that does what a face does.
  [[nodiscard]] Rigid holding(int face, const std::vector<double>& values) const {
    std::vector<Rigid> basis;
    Rigid whole{};
    for (int i = unknowns_.first(face); i < unknowns_.first(face + 1); ++i) {
      const Rigid& row = rigid_[static_cast<std::size_t>(i)];
      Rigid rest = rest_of(row, basis);
      const double length = std::sqrt(dot(rest, rest));
      if (length < seen_at_all) continue;
      for (double& value : rest) value /= length;
      basis.push_back(rest);
      const double lacking = (values[static_cast<std::size_t>(i)] - dot(row, whole)) / length;
      for (std::size_t k = 0; k < 6; ++k) whole[k] += lacking * rest[k];
    }
    return whole;
  }

  const Part& part_;
  const Unknowns& unknowns_;
  std::vector<Rigid> rigid_;
  std::vector<int> largest_first_;  // faces
};

// Rows in terms of vectors that they may combine.
std::vector<Row> in_terms_of(std::span<const Row> rows, std::span<const Row> vectors, int count) {
  std::vector<Row> of_unknown(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (const Term& term : vectors[i])
      of_unknown[static_cast<std::size_t>(term.unknown)].push_back({static_cast<int>(i), term.factor});
  std::vector<Row> found;
  for (const Row& row : rows) {
    found.push_back(combined(row, of_unknown));
    std::erase_if(found.back(), [](const Term& term) { return std::abs(term.factor) <= surely_zero; });
  }
  return found;
}

struct Said {
  std::vector<Row> rows;        // of length 1
  std::vector<int> of;          // the statement of each
  std::vector<double> lengths;  // of each row in its statement
};

double length_of(const Row& row) {
  double squares = 0;
  for (const Term& term : row) squares += term.factor * term.factor;
  return std::sqrt(squares);
}

Said said_by(std::span<const Statement> statements, bool with_doubtful) {
  Said said;
  for (std::size_t i = 0; i < statements.size(); ++i)
    for (const Row& row : statements[i].rows)
      if (statements[i].is_certain || with_doubtful) {
        said.lengths.push_back(length_of(row));
        said.rows.push_back(row);
        for (Term& term : said.rows.back()) term.factor /= said.lengths.back();
        said.of.push_back(static_cast<int>(i));
      }
  return said;
}

struct Free {
  std::vector<Row> dimensions;  // in terms of what rules allow
  Said said;
  std::vector<Motion> motions;
  bool is_certain;
};

// Which changes rules allow.
NullSpace allowed_by(const Part& part, const Unknowns& unknowns, std::span<const Statement> rules) {
  std::vector<Row> rows = base_rows(part, unknowns);
  for (Row& row : said_by(rules, true).rows) rows.push_back(std::move(row));
  return null_space(unknowns.count(), rows);
}

Free find_free(const Part& part, const Unknowns& unknowns, const NullSpace& by_rules,
               std::span<const Statement> dimensions, bool with_doubtful) {
  const std::vector<Row>& allowed = by_rules.vectors;
  Said said = said_by(dimensions, with_doubtful);
  Free free{in_terms_of(said.rows, allowed, unknowns.count()), {}, {}, by_rules.is_certain};
  free.said = std::move(said);
  const NullSpace left = null_space(static_cast<int>(allowed.size()), free.dimensions);
  free.is_certain = free.is_certain && left.is_certain;
  const Relative relative(part, unknowns);
  for (const Row& vector : left.vectors) free.motions.push_back(relative.motion(combined(vector, allowed)));
  return free;
}

// The statements of a row and of those from which it follows, each once.
std::vector<int> statements_of(const DependentRow& one, const Said& said) {
  std::vector<int> list{said.of[static_cast<std::size_t>(one.row)]};
  for (const Term& term : one.others)
    if (const int number = said.of[static_cast<std::size_t>(term.unknown)];
        std::find(list.begin(), list.end(), number) == list.end())
      list.push_back(number);
  return list;
}

// Whether the texts say something else of a row than those of the others do, beyond their last digits.
bool contradict(const DependentRow& one, const Said& said, std::span<const Statement> statements) {
  double more = 0, slack = 0;
  bool is_certain = true;
  const auto add_text = [&](int row, double factor) {
    const Statement& statement = statements[static_cast<std::size_t>(said.of[static_cast<std::size_t>(row)])];
    const double length = said.lengths[static_cast<std::size_t>(row)];
    more += factor * statement.more / length;
    slack += std::abs(factor) * statement.slack / length;
    is_certain = is_certain && statement.is_certain;
  };
  add_text(one.row, 1);
  for (const Term& term : one.others) add_text(term.unknown, -term.factor);
  return is_certain && std::abs(more) > slack + surely_zero;
}

void mark(std::vector<FaceState>& states, const std::vector<Motion>& motions, FaceState state) {
  for (const Motion& motion : motions)
    for (const int face : motion.faces) states[static_cast<std::size_t>(face)] = state;
}

}  // namespace

// Three unknowns of the first face, two of the second, one of the third.
std::vector<Row> base_rows(const Part& part, const Unknowns& unknowns, std::span<const FaceState> states) {
  std::vector<int> order(part.faces.size());
  std::iota(order.begin(), order.end(), 0);
  const auto is_fixed = [&](int face) {
    return states.empty() || states[static_cast<std::size_t>(face)] == FaceState::fixed;
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    if (is_fixed(a) != is_fixed(b)) return is_fixed(a);
    return part.faces[static_cast<std::size_t>(a)].area >
           part.faces[static_cast<std::size_t>(b)].area * (1 + same_size);
  });
  std::vector<Rigid> basis;
  std::vector<Row> rows;
  for (const double enough : {good_base, seen_at_all})
    for (const int face : order)
      for (int i = unknowns.first(face); i < unknowns.first(face + 1); ++i) {
        Rigid rest = rest_of(unknowns.rigid(i), basis);
        const double length = std::sqrt(dot(rest, rest));
        if (length < enough) continue;
        for (double& value : rest) value /= length;
        basis.push_back(rest);
        rows.push_back({{i, 1.0}});
      }
  return rows;
}

bool Account::is_complete() const {
  return is_certain && std::all_of(states.begin(), states.end(), [](FaceState state) {
           return state == FaceState::fixed || state == FaceState::by_model;
         });
}

Account take_account(const Part& part, const Unknowns& unknowns, std::span<const Statement> rules,
                     std::span<const Statement> dimensions) {
  const auto is_doubtful = [](const Statement& statement) { return !statement.is_certain; };
  const NullSpace by_rules = allowed_by(part, unknowns, rules);
  Free surely = find_free(part, unknowns, by_rules, dimensions, true);
  Account account;
  account.is_certain = surely.is_certain;
  account.states.assign(part.faces.size(), FaceState::fixed);
  for (std::size_t i = 0; i < part.faces.size(); ++i)
    if (part.faces[i].surface.kind == surfaces::SurfaceKind::free_form) account.states[i] = FaceState::by_model;
  if (std::any_of(dimensions.begin(), dimensions.end(), is_doubtful)) {
    const Free perhaps = find_free(part, unknowns, by_rules, dimensions, false);
    mark(account.states, perhaps.motions, FaceState::uncertain);
    account.is_certain = account.is_certain && perhaps.motions.size() == surely.motions.size();
  }
  mark(account.states, surely.motions, FaceState::free);
  account.needed = static_cast<int>(by_rules.vectors.size());
  account.motions = std::move(surely.motions);
  std::vector<std::size_t> own(dimensions.size(), 0);  // rows that follow from none before
  for (const int statement : surely.said.of) ++own[static_cast<std::size_t>(statement)];
  account.follows.assign(dimensions.size(), 0);
  for (const DependentRow& one : dependent_rows(surely.dimensions)) {
    const auto statement = static_cast<std::size_t>(surely.said.of[static_cast<std::size_t>(one.row)]);
    if (--own[statement] == 0) account.follows[statement] = 1;
    account.repeated.push_back(statements_of(one, surely.said));
    if (contradict(one, surely.said, dimensions)) account.contradictory.push_back(account.repeated.back());
  }
  return account;
}

}  // namespace epura::definition
