// SPDX-License-Identifier: Apache-2.0
#include "iges_arcs.hpp"

#include <IGESData_TransfEntity.hxx>
#include <IGESGeom_CircularArc.hxx>
#include <IGESGeom_ConicArc.hxx>
#include <IGESGeom_TransformationMatrix.hxx>
#include <TColStd_HArray2OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <gp_GTrsf.hxx>
#include <gp_Pnt2d.hxx>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace occt {

namespace {

/// A x2 + B x y + C y2 + D x + E y + F = 0, as in IGES 5.3, 4.4.
struct Conic {
  double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0;
};

/// The same curve in axes turned by an angle, as far as its equation has no product of both.
Conic turned(const Conic& one, double cosine, double sine) {
  return {one.a * cosine * cosine + one.b * cosine * sine + one.c * sine * sine,
          0,
          one.a * sine * sine - one.b * cosine * sine + one.c * cosine * cosine,
          one.d * cosine + one.e * sine,
          one.e * cosine - one.d * sine,
          one.f};
}

constexpr double nothing = 1e-12;  // of the larger of two coefficients

// Whether an ellipse is longest along x, and others open along it; `x` of the start tells the branch of a hyperbola.
bool is_along_x(const Conic& one, double x) {
  const double large = std::max(std::abs(one.a), std::abs(one.c));
  if (std::abs(one.a) <= nothing * large) return one.c * one.d < 0;
  if (std::abs(one.c) <= nothing * large) return false;
  if (one.a * one.c > 0) return std::abs(one.a) <= std::abs(one.c);
  const double middle = -one.d / (2 * one.a);
  const double at_middle = one.f - one.d * one.d / (4 * one.a) - one.e * one.e / (4 * one.c);
  return one.a * at_middle < 0 && x > middle;
}

/// How axes are turned in which a conic arc lies along x.
struct Turn {
  double cosine = 1, sine = 0;

  [[nodiscard]] gp_XY of(const gp_Pnt2d& point) const {
    return {cosine * point.X() + sine * point.Y(), cosine * point.Y() - sine * point.X()};
  }
};

std::optional<Turn> turn_to_x(const Conic& conic, const gp_Pnt2d& start) {
  const double axis = conic.b == 0 ? 0 : std::atan2(conic.b, conic.a - conic.c) / 2;
  for (int quarter = 0; quarter < 4; ++quarter) {
    Turn turn{std::cos(axis), std::sin(axis)};
    for (int i = 0; i < quarter; ++i) turn = {-turn.sine, turn.cosine};
    if (is_along_x(turned(conic, turn.cosine, turn.sine), turn.of(start).X())) return turn;
  }
  return std::nullopt;
}

// The values of a matrix of which `turn` is the first part, and reverses the z axis if z is -1.
Handle(TColStd_HArray2OfReal) values_of(const gp_GTrsf& place, const Turn& turn, double z) {
  const double first[3][3]{{turn.cosine, -turn.sine, 0}, {turn.sine, turn.cosine, 0}, {0, 0, z}};
  const Handle(TColStd_HArray2OfReal) values = new TColStd_HArray2OfReal(1, 3, 1, 4);
  for (int row = 1; row <= 3; ++row) {
    for (int column = 1; column <= 3; ++column) {
      double sum = 0;
      for (int k = 1; k <= 3; ++k) sum += place.Value(row, k) * first[k - 1][column - 1];
      values->SetValue(row, column, sum);
    }
    values->SetValue(row, 4, place.Value(row, 4));
  }
  return values;
}

// That of a matrix, and of those that it refers to in turn.
gp_GTrsf whole_place(const Handle(IGESData_TransfEntity) & matrix, int most) {
  gp_GTrsf place = matrix->Value();
  Handle(IGESData_TransfEntity) next = matrix;
  for (int count = 0; next->HasTransf(); ++count) {
    if (count == most) throw std::runtime_error("transformation matrices (124) refer to one another");
    next = next->Transf();
    place.PreMultiply(next->Value());
  }
  return place;
}

}  // namespace

void combine_matrices(const Handle(IGESData_IGESModel) & model) {
  std::vector<std::pair<Handle(IGESGeom_TransformationMatrix), gp_GTrsf>> combined;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto matrix = Handle(IGESGeom_TransformationMatrix)::DownCast(model->Entity(i));
    if (!matrix.IsNull() && matrix->HasTransf())
      combined.emplace_back(matrix, whole_place(matrix, model->NbEntities()));
  }
  for (const auto& [matrix, place] : combined) {
    matrix->Init(values_of(place, Turn{}, 1));
    matrix->InitTransf(nullptr);
  }
}

void align_arcs(const Handle(IGESData_IGESModel) & model) {
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(IGESData_IGESEntity) entity = model->Entity(i);
    const auto circle = Handle(IGESGeom_CircularArc)::DownCast(entity);
    const auto conic = Handle(IGESGeom_ConicArc)::DownCast(entity);
    if (circle.IsNull() && conic.IsNull()) continue;
    const double z = entity->Location().VectorialPart().Determinant() < 0 ? -1 : 1;
    Conic curve;
    std::optional<Turn> turn = Turn{};
    if (!conic.IsNull()) {
      conic->Equation(curve.a, curve.b, curve.c, curve.d, curve.e, curve.f);
      turn = turn_to_x(curve, conic->StartPoint());
    }
    if (!turn || (z > 0 && turn->cosine == 1)) continue;
    const Handle(IGESGeom_TransformationMatrix) matrix = new IGESGeom_TransformationMatrix;
    matrix->Init(values_of(entity->Location(), *turn, z));
    if (!circle.IsNull())
      circle->Init(z * circle->ZPlane(), circle->Center().XY(), circle->StartPoint().XY(), circle->EndPoint().XY());
    if (!conic.IsNull()) {
      const Conic own = turned(curve, turn->cosine, turn->sine);
      conic->Init(own.a, own.b, own.c, own.d, own.e, own.f, z * conic->ZPlane(), turn->of(conic->StartPoint()),
                  turn->of(conic->EndPoint()));
    }
    entity->InitTransf(matrix);
  }
}

}  // namespace occt
