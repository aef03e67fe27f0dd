#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# OpenMesh 9.0: a mesh whose Point is Vec3d passes through float when it is read from OBJ, OFF, PLY (properties of type double, too) or
# STL, and when it is written to them, even with precision 17. Its own OM keeps doubles. Believed: the type of the mesh decides.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libopenmesh-dev=9.0-4+b1
cat >doubles.cpp <<'CPP'
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cstdio>
#include <fstream>
#include <string>

struct Doubles : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Doubles>;

int main() {
  const std::string points = "1234.56789012 0 0\n1 0 0\n0 1 0\n";
  std::ofstream("read.obj") << "v 1234.56789012 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream("read.off") << "OFF\n3 1 0\n" << points << "3 0 1 2\n";
  std::ofstream("read.ply") << "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
                               "element face 1\nproperty list uchar int vertex_indices\nend_header\n" << points << "3 0 1 2\n";
  for (const char* format : {"obj", "off", "ply"}) {
    Mesh mesh;
    OpenMesh::IO::read_mesh(mesh, std::string("read.") + format);
    std::printf("read %s: %.12g\n", format, mesh.point(mesh.vertex_handle(0))[0]);
  }
  Mesh mesh;
  const auto first = mesh.add_vertex({1234.56789012, 0, 0}), second = mesh.add_vertex({1, 0, 0}), third = mesh.add_vertex({0, 1, 0});
  mesh.add_face(first, second, third);
  for (const char* format : {"obj", "off", "ply", "om"}) {
    const std::string file = std::string("written.") + format;
    OpenMesh::IO::write_mesh(mesh, file, OpenMesh::IO::Options::Default, 17);
    Mesh again;
    OpenMesh::IO::read_mesh(again, file);
    std::printf("written %s: %.12g\n", format, again.point(again.vertex_handle(0))[0]);
  }
}
CPP
c++ -std=c++17 -I root/usr/include doubles.cpp -L root/usr/lib/x86_64-linux-gnu -lOpenMeshCore -o doubles
./doubles 2>/dev/null | grep : >seen
expect_in seen <<'END'
read obj: 1234.56787109
read off: 1234.56787109
read ply: 1234.56787109
written obj: 1234.56787109
written off: 1234.56787109
written ply: 1234.56787109
written om: 1234.56789012
END
