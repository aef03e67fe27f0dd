// SPDX-License-Identifier: Apache-2.0
// Stiff and extreme bodies through STEP files: written by Open CASCADE, read by epura's importer, drawn with arcs, and
// compared with their lines in closed form.
//   step_cases
// prints for each step of each case the error on paper, and what the drawing states; it is right if the first is not
// larger. Exit code 1: a step is wrong.
#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/temporary_folder.hpp"
#include "base/text.hpp"
#include "study/paper/convergence.hpp"
#include "study_bodies.hpp"

namespace {

using namespace epura;
using study::ClosedForm;
using study::RoundBody;
using Kind = RoundBody::Kind;

struct StepCase {
  std::string name, parameter;
  std::vector<double> steps;
  std::function<ClosedForm(double)> form;
};

// From 10^first to 10^last.
std::vector<double> powers(int first, int last) {
  std::vector<double> all;
  const int step = first < last ? 1 : -1;
  for (int i = first; i != last + step; i += step) all.push_back(std::pow(10.0, i));
  return all;
}

RoundBody ball(double radius, const Vec3& centre = Vec3(0)) {
  RoundBody body{Kind::sphere, radius};
  body.origin = centre;
  return body;
}

RoundBody frustum(double radius, double top, double height, const Vec3& foot = Vec3(0)) {
  return {.kind = Kind::frustum, .radius = radius, .top = top, .height = height, .origin = foot};
}

ClosedForm one_body(const RoundBody& body) { return {"", "isometric", {body}}; }

ClosedForm shaft_along_view(double sine) {
  ClosedForm form = one_body(frustum(20, 20, 60));
  form.projection = "auxiliary:direction=3,-2," + format_number(std::hypot(3, 2) / sine);
  return form;
}

ClosedForm ball_in_drum(double more) {
  const double radius = 20 / (1 + more);
  ClosedForm form{"", "isometric", {ball(20), frustum(radius, radius, 50, {0, 0, -25})}};
  for (const double side : {-1.0, 1.0})
    form.crossings.emplace_back([radius, side](double s) {
      const double a = 2 * M_PI * s;
      return Vec3(radius * std::cos(a), radius * std::sin(a), side * std::sqrt(400 - radius * radius));
    });
  return form;
}

ClosedForm crossing_shafts(double more) {
  const double radius = 20 / (1 + more);
  RoundBody bar = frustum(radius, radius, 80, {-40, 0, 0});
  bar.lying = true;
  ClosedForm form{"", "isometric", {frustum(20, 20, 70, {0, 0, -35}), bar}};
  for (const double side : {-1.0, 1.0})
    form.crossings.emplace_back([radius, side](double s) {
      const double y = radius * std::cos(2 * M_PI * s), z = radius * std::sin(2 * M_PI * s);
      return Vec3(side * std::sqrt(400 - y * y), y, z);
    });
  return form;
}

std::vector<StepCase> all_cases() {
  return {{"ball of any size", "radius, mm", powers(-2, 5), [](double r) { return one_body(ball(r)); }},
          {"shaft far from the origin", "distance, mm", powers(0, 7),
           [](double d) {
             return one_body(frustum(20, 20, 60, {d, -d, d / 2}));
           }},
          {"slender cone", "half-angle, degrees", powers(1, -4),
           [](double degrees) { return one_body(frustum(20, 20 - 60 * std::tan(degrees * M_PI / 180), 60)); }},
          {"slender shaft", "length over diameter", powers(0, 4),
           [](double ratio) { return one_body(frustum(10, 10, 20 * ratio)); }},
          {"flat disk", "thickness over diameter", powers(0, -6),
           [](double ratio) { return one_body(frustum(20, 20, 40 * ratio)); }},
          {"thin ring", "radius of the tube over that of the ring", powers(-1, -4),
           [](double ratio) { return one_body({.kind = Kind::torus, .radius = 20, .tube = 20 * ratio}); }},
          {"shaft along the view", "sine of the angle to it", powers(-1, -5), shaft_along_view},
          {"ball above a drum", "clearance, mm", powers(0, -9),
           [](double gap) {
             return ClosedForm{"", "isometric", {frustum(19.5, 19.5, 50, {0, 0, -25}), ball(12, {0, 0, 37 + gap})}};
           }},
          {"ball in a drum", "radius over that of the drum, less 1", powers(-1, -6), ball_in_drum},
          {"crossing shafts", "radius over that of the other, less 1", powers(0, -6), crossing_shafts}};
}

std::string to_step(const std::vector<TopoDS_Shape>& bodies) {
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& body : bodies) builder.Add(all, body);
  STEPControl_Writer writer;
  const TemporaryFolder scratch;
  const std::filesystem::path file = scratch / "bodies.step";
  if (writer.Transfer(all, STEPControl_AsIs) != IFSelect_RetDone || writer.Write(file.c_str()) != IFSelect_RetDone)
    throw Error(ErrorKind::output, file.string(), "cannot be written by Open CASCADE");
  return read_file(file);
}

study::PaperScene through_step(const ClosedForm& form) {
  study::PaperScene scene = scene_of(form);
  scene::ModelDescription model;
  model.file = {"bodies.step", "step_cases"};
  model.content =
      std::make_shared<const std::string>(to_step(bench::bodies_of(describe_bodies(form, Mat3(1))).value()));
  scene.files.push_back(std::move(model));
  return scene;
}

// Returns whether the drawing is as good as it states.
bool draw_step(const StepCase& one, double step) {
  constexpr int points = 4096;
  std::string text = one.name + ", " + one.parameter + ' ' + format_number(step) + ": ";
  bool right = true;
  try {
    const study::PaperStudy study{{}, points};
    const study::PaperRun run = draw_on_paper(through_step(one.form(step)), 0, study::PaperWay::arcs, study);
    const double error = run.error.ink(), stated = run.error.budget.total();
    right = error <= stated;
    text += format_rounded(error, 3) + " mm, stated " + format_rounded(stated, 3) + " mm" + (right ? "" : ": wrong");
  } catch (const Error& error) {
    text += std::string("refused: ") + error.what();
  }
  std::puts(text.c_str());
  std::fflush(stdout);
  return right;
}

}  // namespace

int main() {
  Message::DefaultMessenger()->ChangePrinters().Clear();  // it reports every file that it writes
  try {
    int wrong = 0;
    for (const StepCase& one : all_cases())
      for (const double step : one.steps) wrong += draw_step(one, step) ? 0 : 1;
    return wrong > 0 ? 1 : 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "step_cases: %s\n", error.what());
    return static_cast<int>(error.kind());
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "step_cases: %s\n", failure.GetMessageString());
    return static_cast<int>(ErrorKind::input);
  }
}
