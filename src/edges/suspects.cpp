#include "edges/suspects.hpp"

#include <numeric>

#include "base/parallel.hpp"
#include "edges/convex_bodies.hpp"
#include "edges/intersections.hpp"
#include "edges/triangle_tree.hpp"

namespace epura {

namespace {

// Marks bodies whose box meets that of no other body.
std::vector<char> lonely_bodies(const std::vector<Box>& boxes, const Progress& progress) {
  std::vector<char> lonely(boxes.size(), 1);
  std::vector<int> there;  // a cut may take bodies away
  for (std::size_t b = 0; b < boxes.size(); ++b)
    if (!boxes[b].empty()) there.push_back(static_cast<int>(b));
  if (there.size() < 2) return lonely;
  const TriangleTree tree(there.size(), [&](int i) { return boxes[there[i]]; });
  const auto tasks = tree.tasks(256);
  std::vector<std::vector<int>> met(tasks.size());
  parallel_for(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t task = begin; task < end; ++task)
      tree.search(tasks[task], [&](int i, int j) {
        progress.expect_time();
        if (boxes_overlap(boxes[there[i]], boxes[there[j]])) met[task].insert(met[task].end(), {there[i], there[j]});
      });
  });
  for (const std::vector<int>& part : met)
    for (const int body : part) lonely[body] = 0;
  return lonely;
}

}  // namespace

std::vector<int> crossing_suspects(const World& world, double shrink, double contact, const Progress& progress) {
  progress.expect_time();
  const UnsetVector<Vec3> points = shrunk_points(world, shrink);
  const BodyTable bodies = bodies_of(world, points);
  std::vector<char> apart = lonely_bodies(bodies.box, progress);
  progress.expect_time();
  keep_convex(world, points, bodies, contact, apart);
  std::vector<int> suspects;
  for (int t = 0; t < static_cast<int>(world.triangles.size()); ++t)
    if (apart[bodies.of_triangle[t]] == 0) suspects.push_back(t);
  return suspects;
}

std::vector<int> all_triangles(const World& world) {
  std::vector<int> all(world.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace epura
