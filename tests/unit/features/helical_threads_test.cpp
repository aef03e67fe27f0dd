// SPDX-License-Identifier: Apache-2.0
// Threads that are modelled as helical faces: their sizes, and the cylinders that take their places.
#include "features/helical_threads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "recognised.hpp"
#include "surfaces/declared_part.hpp"

namespace epura::test::helical_threads_test {
namespace {

constexpr double minor_radius = 4.188, major_radius = 5;  // M10: 8.376 and 10
constexpr int around = 40, steps = 8;                     // vertices of a turn, and rows of a pitch

/// Rows of a wave that runs around the z axis. A negative pitch makes it left-handed.
void add_helix(Part& part, double pitch, int turns) {
  for (int k = 0; k <= turns * steps; ++k)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * pi * i / around, phase = 2 * pi * k / steps - (pitch < 0 ? -angle : angle);
      const double r = (minor_radius + major_radius) / 2 + (major_radius - minor_radius) / 2 * std::cos(phase);
      part.add({r * std::cos(angle), r * std::sin(angle), std::abs(pitch) * k / steps});
    }
  for (int k = 0; k < turns * steps; ++k)
    for (int i = 0; i < around; ++i) {
      const int j = (i + 1) % around;
      part.faces.push_back({k * around + i, k * around + j, (k + 1) * around + j, (k + 1) * around + i});
    }
}

// A screw with a head of radius 8 and height 6 above its thread.
Part screw(double pitch, int turns = 8) {
  Part part;
  add_helix(part, pitch, turns);
  const int top = turns * steps * around, head = static_cast<int>(part.points.size());
  const double height = std::abs(pitch) * turns;
  for (const double z : {height, height + 6})
    for (int i = 0; i < around; ++i)
      part.add({8 * std::cos(2 * pi * i / around), 8 * std::sin(2 * pi * i / around), z});
  std::vector<int> tip, end;
  for (int i = 0; i < around; ++i) {
    const int j = (i + 1) % around;
    part.faces.push_back({top + i, top + j, head + j, head + i});
    part.faces.push_back({head + i, head + j, head + around + j, head + around + i});
    tip.insert(tip.begin(), i);
    end.push_back(head + around + i);
  }
  part.faces.push_back(tip);
  part.faces.push_back(end);
  return part;
}

// A square plate of width 20 with the same thread in its hole; no other face is round.
Part nut(double pitch, int turns = 5) {
  Part part;
  add_helix(part, pitch, turns);
  part.turn_inside_out();
  const int top = turns * steps * around, outline = static_cast<int>(part.points.size());
  const double height = std::abs(pitch) * turns;
  for (const double z : {0.0, height})
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * pi * i / around;
      const double out = 10 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
      part.add({out * std::cos(angle), out * std::sin(angle), z});
    }
  for (int i = 0; i < around; ++i) {
    const int j = (i + 1) % around, low = outline, high = outline + around;
    part.faces.push_back({i, j, low + j, low + i});
    part.faces.push_back({top + j, top + i, high + i, high + j});
    part.faces.push_back({low + i, low + j, high + j, high + i});
  }
  return part;
}

features::HelicalForms forms_of(const Part& part, double unit = 1) {
  const mesh::Mesh mesh = part.mesh();
  return features::find_helical_threads(mesh, surfaces::recognise_faces(mesh), unit);
}

std::vector<features::HelicalThread> threads_of(const Part& part, double unit = 1) {
  return forms_of(part, unit).threads;
}

double volume_of(const mesh::Mesh& mesh) {
  double volume = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.triangle(t);
    volume += glm::dot(mesh.point(a), glm::cross(mesh.point(b), mesh.point(c))) / 6;
  }
  return volume;
}

TEST(HelicalThreads, HaveTheSizeOfTheirDiameterAndPitch) {
  const auto size = [](const Part& part, double unit = 1) {
    const auto threads = threads_of(part, unit);
    return threads.size() == 1 ? threads.front().thread.text : std::to_string(threads.size()) + " threads";
  };
  EXPECT_EQ(size(screw(1.5)), "M10");
  EXPECT_EQ(size(screw(1.25)), "M10×1.25");
  EXPECT_EQ(size(screw(-1.5)), "M10-LH");
  EXPECT_EQ(size(nut(1.5)), "M10");
  EXPECT_EQ(size(screw(1.5).turn_inside_out()), "M10") << "orientation does not matter";
  EXPECT_EQ(size(screw(1.5), 2), "0 threads") << "M20 has no pitch of 3 mm";
  EXPECT_EQ(size(screw(1.5).move([](const Vec3& p) { return Vec3(p.z, p.x, p.y) / 25.4; }), 25.4), "M10");
}

TEST(HelicalThreads, OfOtherPitchesAndShorterOnesAreNone) {
  EXPECT_TRUE(threads_of(screw(1.4)).empty());
  EXPECT_TRUE(threads_of(screw(1.5, 1)).empty());
}

// They are told with diameter and pitch.
TEST(HelicalThreads, OfOtherPitchesAreOtherHelices) {
  for (const double pitch : {1.4, -1.4, 1.1, 3.0}) {
    for (const Part& part : {screw(pitch), nut(pitch)}) {
      const features::HelicalForms forms = forms_of(part, 2);
      EXPECT_TRUE(forms.threads.empty()) << pitch;
      ASSERT_EQ(forms.others.size(), 1U) << pitch;
      EXPECT_NEAR(forms.others[0].pitch, 2 * std::abs(pitch), 1e-3);
    }
    EXPECT_NEAR(forms_of(screw(pitch)).others.at(0).diameter, 2 * major_radius, 0.02);
    EXPECT_NEAR(forms_of(nut(pitch)).others.at(0).diameter, 2 * minor_radius, 0.02);
  }
  EXPECT_TRUE(forms_of(screw(1.5)).others.empty());
  EXPECT_TRUE(forms_of(screw(1.4, 1)).others.empty()) << "one turn is no thread";
}

// A shaft beside a nut, around whose axis the faces of the thread are not.
TEST(HelicalThreads, AreFoundAroundTheirOwnAxes) {
  const Part shaft = moved(screw(1.5).move([](const Vec3& p) {
    const double r = std::hypot(p.x, p.y);
    return r < 6 ? Vec3(5 * p.x / r, 5 * p.y / r, p.z) : p;
  }),
                           {22, 0, 0});
  EXPECT_EQ(threads_of(shaft).size(), 0U);
  const auto threads = threads_of(together({shaft, nut(1.5), moved(nut(1.5), {0, 30, 0})}));
  ASSERT_EQ(threads.size(), 2U);
  for (const features::HelicalThread& thread : threads) EXPECT_NEAR(thread.origin.x, 0, 1e-6);
}

// Rings of waves have no pitch.
TEST(HelicalThreads, AreNotRings) {
  Part bellows = screw(1.5);
  for (int k = 0; k <= 8 * steps; ++k)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * pi * i / around;
      const double r =
          (minor_radius + major_radius) / 2 + (major_radius - minor_radius) / 2 * std::cos(2 * pi * k / steps);
      bellows.points[static_cast<std::size_t>(k * around + i)] = {r * std::cos(angle), r * std::sin(angle),
                                                                  1.5 * k / steps};
    }
  EXPECT_TRUE(threads_of(bellows).empty());
  EXPECT_TRUE(forms_of(bellows).others.empty());
}

// Every face but those of the thread is where it was, and the new one is a cylinder all around.
void expect_faces_kept(const mesh::Mesh& before, const surfaces::PartFaces& part, const mesh::Mesh& mesh,
                       const std::vector<int>& face_of_triangle, const features::HelicalThread& thread) {
  const surfaces::PartSurface cylinder{surfaces::SurfaceKind::cylinder, thread.origin, thread.axis, thread.crest};
  const surfaces::PartFaces kept = surfaces::part_with_face(part, before, {mesh, face_of_triangle, cylinder}, 5);
  std::set<int> of_thread;
  for (const int t : thread.triangles) of_thread.insert(part.face_of_triangle[static_cast<std::size_t>(t)]);
  ASSERT_EQ(kept.faces.size(), part.faces.size() - of_thread.size() + 1);
  const surfaces::PartFace& last = kept.faces.back();
  EXPECT_EQ(last.surface.kind, surfaces::SurfaceKind::cylinder);
  EXPECT_EQ(last.inwards, thread.internal);
  EXPECT_GT(last.sweep, 359);
  for (const surfaces::PartFace& face : kept.faces) EXPECT_LT(face.residual, 1e-9);
  std::size_t declared = 0;
  for (const surfaces::PartBorder& border : part.borders)
    if (of_thread.count(border.faces[0]) + of_thread.count(border.faces[1]) == 0) ++declared;
  EXPECT_EQ(kept.borders.size(), declared + 2) << "the cylinder has two ends";
}

// The crests of a screw are its major diameter, those of a hole the minor one.
TEST(HelicalThreads, BecomeCylindersOfClosedBodies) {
  const double disc = around / 2.0 * std::sin(2 * pi / around);  // area of a polygon in a circle of radius 1
  const double head = disc * 64 * 6, plate = 400 * 7.5;
  for (const bool internal : {false, true}) {
    const Part part = internal ? nut(1.5) : screw(1.5);
    const mesh::Mesh before = part.mesh();
    const surfaces::PartFaces faces = surfaces::recognise_faces(before);
    const auto threads = features::find_helical_threads(before, faces, 1).threads;
    ASSERT_EQ(threads.size(), 1U);
    EXPECT_EQ(threads.front().internal, internal);
    const double radius = internal ? minor_radius : major_radius, height = internal ? 7.5 : 12;
    const auto made_mesh = features::with_cylinder(before, faces, threads.front());
    ASSERT_TRUE(made_mesh);
    const mesh::Mesh& mesh = made_mesh->mesh;
    expect_faces_kept(before, faces, mesh, made_mesh->face_of_triangle, threads.front());
    for (const mesh::MeshEdge& edge : mesh.edges) EXPECT_EQ(edge.count, 2);
    const double core = pi * radius * radius * height;
    EXPECT_NEAR(volume_of(mesh), internal ? plate - core : head + core, 0.005 * core);
    const surfaces::PartFaces made = surfaces::recognise_faces(mesh);
    const auto cylinder = std::find_if(made.faces.begin(), made.faces.end(), [&](const surfaces::PartFace& face) {
      return face.surface.kind == surfaces::SurfaceKind::cylinder && std::abs(face.surface.radius - radius) < 1e-6;
    });
    ASSERT_NE(cylinder, made.faces.end());
    EXPECT_EQ(cylinder->inwards, internal);
    EXPECT_NEAR(cylinder->to - cylinder->from, height, 1e-9);
    EXPECT_NEAR(cylinder->sweep, 360, 1e-6);
  }
}

}  // namespace
}  // namespace epura::test::helical_threads_test
