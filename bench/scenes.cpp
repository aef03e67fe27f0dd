// Large scenes for measuring, written as binary PLY:  scenes KIND SIZE FILE
//
//   sphere N, torus N    smooth, about N triangles
//   plate K              a plate of K x K cells, each with a through hole of 32 sides
//   gears N              N^3 separate gears of 12 teeth with a bore, in three orientations
//   city N               N x N boxes of different heights on a ground plate
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace {

using Point = std::array<double, 3>;

constexpr double turn = 2 * std::numbers::pi;

struct Scene {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;

  int add(double x, double y, double z) {
    points.push_back({x, y, z});
    return static_cast<int>(points.size()) - 1;
  }
  void quad(int a, int b, int c, int d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
};

Scene torus(double count) {
  const int n = static_cast<int>(std::sqrt(count / 2));
  Scene scene;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = turn * i / n, b = turn * j / n, radius = 100 + 40 * std::cos(b);
      scene.add(radius * std::cos(a), radius * std::sin(a), 40 * std::sin(b));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int k = (i + 1) % n, l = (j + 1) % n;
      scene.quad(i * n + j, k * n + j, k * n + l, i * n + l);
    }
  return scene;
}

Scene sphere(double count) {
  const int bands = static_cast<int>(std::sqrt(count / 4)), n = 2 * bands;
  Scene scene;
  const int south = scene.add(0, 0, -100), north = scene.add(0, 0, 100);
  for (int j = 1; j < bands; ++j)
    for (int i = 0; i < n; ++i) {
      const double a = turn * i / n, b = turn / 2 * j / bands - turn / 4;
      scene.add(100 * std::cos(b) * std::cos(a), 100 * std::cos(b) * std::sin(a), 100 * std::sin(b));
    }
  const auto at = [n](int j, int i) { return 2 + (j - 1) * n + i % n; };
  for (int i = 0; i < n; ++i) {
    scene.triangles.push_back({south, at(1, i + 1), at(1, i)});
    for (int j = 1; j + 1 < bands; ++j) scene.quad(at(j, i), at(j, i + 1), at(j + 1, i + 1), at(j + 1, i));
    scene.triangles.push_back({north, at(bands - 1, i), at(bands - 1, i + 1)});
  }
  return scene;
}

// The ring between a square cell and its round hole: each corner of the square sees a quarter of the hole.
void ring(Scene& scene, const std::array<int, 4>& square, const std::vector<int>& hole, bool up) {
  const auto triangle = [&](int a, int b, int c) {
    if (up)
      scene.triangles.push_back({a, b, c});
    else
      scene.triangles.push_back({a, c, b});
  };
  const int quarter = static_cast<int>(hole.size()) / 4;
  for (int corner = 0; corner < 4; ++corner) {
    for (int i = 0; i < quarter; ++i)
      triangle(square[corner], hole[(corner * quarter + i + 1) % hole.size()], hole[corner * quarter + i]);
    triangle(square[corner], square[(corner + 1) % 4], hole[(corner + 1) * quarter % hole.size()]);
  }
}

Scene plate(int k) {
  constexpr int sides = 32;
  Scene scene;
  for (const double z : {0.0, 4.0})
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i <= k; ++i) scene.add(10 * i, 10 * j, z);
  const auto at = [k](int i, int j, int level) { return (level * (k + 1) + j) * (k + 1) + i; };
  for (int j = 0; j < k; ++j)
    for (int i = 0; i < k; ++i) {
      std::array<std::vector<int>, 2> hole;
      for (int level = 0; level < 2; ++level) {
        for (int s = 0; s < sides; ++s) {
          const double a = turn * s / sides - turn / 2;
          hole[level].push_back(scene.add(10 * i + 5 + 3 * std::cos(a), 10 * j + 5 + 3 * std::sin(a), 4.0 * level));
        }
        ring(scene, {at(i, j, level), at(i + 1, j, level), at(i + 1, j + 1, level), at(i, j + 1, level)}, hole[level],
             level == 1);
      }
      for (int s = 0; s < sides; ++s) {
        const int t = (s + 1) % sides;
        scene.quad(hole[0][s], hole[1][s], hole[1][t], hole[0][t]);
      }
    }
  for (int i = 0; i < k; ++i) {
    scene.quad(at(i, 0, 0), at(i + 1, 0, 0), at(i + 1, 0, 1), at(i, 0, 1));
    scene.quad(at(i, k, 1), at(i + 1, k, 1), at(i + 1, k, 0), at(i, k, 0));
    scene.quad(at(0, i, 1), at(0, i + 1, 1), at(0, i + 1, 0), at(0, i, 0));
    scene.quad(at(k, i, 0), at(k, i + 1, 0), at(k, i + 1, 1), at(k, i, 1));
  }
  return scene;
}

void gear(Scene& scene, const Point& middle, int axis) {
  constexpr int corners = 48;  // four to a tooth
  const auto add = [&](double radius, int corner, double height) {
    const double a = turn * corner / corners;
    Point p{};
    p[axis] = middle[axis] + height;
    p[(axis + 1) % 3] = middle[(axis + 1) % 3] + radius * std::cos(a);
    p[(axis + 2) % 3] = middle[(axis + 2) % 3] + radius * std::sin(a);
    return scene.add(p[0], p[1], p[2]);
  };
  std::array<std::vector<int>, 4> loops;  // outside below and above, bore below and above
  for (int c = 0; c < corners; ++c) {
    const double outside = c % 4 < 2 ? 4.5 : 3.6;
    loops[0].push_back(add(outside, c, -1));
    loops[1].push_back(add(outside, c, 1));
    loops[2].push_back(add(1.5, c, -1));
    loops[3].push_back(add(1.5, c, 1));
  }
  for (int c = 0; c < corners; ++c) {
    const int d = (c + 1) % corners;
    scene.quad(loops[0][c], loops[0][d], loops[1][d], loops[1][c]);
    scene.quad(loops[2][d], loops[2][c], loops[3][c], loops[3][d]);
    scene.quad(loops[1][c], loops[1][d], loops[3][d], loops[3][c]);
    scene.quad(loops[0][d], loops[0][c], loops[2][c], loops[2][d]);
  }
}

Scene gears(int n) {
  Scene scene;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) gear(scene, {10.0 * i, 10.0 * j, 10.0 * k}, (i + j + k) % 3);
  return scene;
}

void box(Scene& scene, const Point& least, const Point& most) {
  std::array<int, 8> v{};
  for (int i = 0; i < 8; ++i)
    v[i] = scene.add((i & 1) != 0 ? most[0] : least[0], (i & 2) != 0 ? most[1] : least[1],
                     (i & 4) != 0 ? most[2] : least[2]);
  for (const auto& f : std::array<std::array<int, 4>, 6>{
           {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}})
    scene.quad(v[f[0]], v[f[1]], v[f[2]], v[f[3]]);
}

Scene city(int n) {
  Scene scene;
  box(scene, {-10, -10, -2}, {10.0 * n + 4, 10.0 * n + 4, 0});
  std::uint32_t random = 1;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      random = random * 1664525 + 1013904223;
      box(scene, {10.0 * i, 10.0 * j, 0}, {10.0 * i + 6, 10.0 * j + 6, 4 + (random >> 16) % 40 * 1.0});
    }
  return scene;
}

template <class Value>
void append(std::string& bytes, Value value) {
  static_assert(std::endian::native == std::endian::little);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

bool write(const Scene& scene, const std::string& path) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(scene.points.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(scene.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point& p : scene.points)
    for (const double c : p) append(bytes, c);
  for (const auto& t : scene.triangles) {
    append(bytes, std::uint8_t{3});
    for (const int v : t) append(bytes, std::int32_t{v});
  }
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file.flush().good();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view kind = argc == 4 ? argv[1] : "";
  int size = 0;
  if (argc == 4) std::from_chars(argv[2], argv[2] + std::string_view(argv[2]).size(), size);
  Scene scene;
  if (size > 0 && kind == "sphere") scene = sphere(size);
  if (size > 0 && kind == "torus") scene = torus(size);
  if (size > 0 && kind == "plate") scene = plate(size);
  if (size > 0 && kind == "gears") scene = gears(size);
  if (size > 0 && kind == "city") scene = city(size);
  if (scene.triangles.empty()) {
    std::fputs("usage: scenes sphere|torus|plate|gears|city SIZE FILE\n", stderr);
    return 2;
  }
  if (write(scene, argv[3])) return 0;
  std::fprintf(stderr, "scenes: cannot write %s\n", argv[3]);
  return 4;
}
