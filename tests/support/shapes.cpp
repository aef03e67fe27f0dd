#include "shapes.hpp"

#include <cmath>

namespace epura::test {

void Shape::add(const Shape& other) {
  const int first = static_cast<int>(points.size());
  points.insert(points.end(), other.points.begin(), other.points.end());
  for (std::vector<int> face : other.faces) {
    for (int& v : face) v += first;
    faces.push_back(face);
  }
  bodies.insert(bodies.end(), other.bodies.begin(), other.bodies.end());
}

Shape Shape::moved(double x, double y, double z) const {
  Shape result = *this;
  for (Point& p : result.points) p = {p[0] + x, p[1] + y, p[2] + z};
  return result;
}

Shape Shape::scaled(double factor) const {
  Shape result = *this;
  for (Point& p : result.points)
    for (double& c : p) c *= factor;
  return result;
}

Shape box(const Point& a, const Point& b) {
  Shape shape;
  for (int i = 0; i < 8; ++i)
    shape.points.push_back({(i & 1) ? b[0] : a[0], (i & 2) ? b[1] : a[1], (i & 4) ? b[2] : a[2]});
  shape.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return shape;
}

Shape triangulated_cube(bool other) {
  Shape cube = box({0, 0, 0}, {1, 1, 1});
  std::vector<std::vector<int>> triangles;
  for (const auto& f : cube.faces) {
    const int k = other ? 1 : 0;
    triangles.push_back({f[k], f[k + 1], f[k + 2]});
    triangles.push_back({f[k], f[k + 2], f[(k + 3) % 4]});
  }
  cube.faces = triangles;
  return cube;
}

Shape plate(double x0, double y0, double x1, double y1, double height) {
  return {{{x0, y0, height}, {x1, y0, height}, {x1, y1, height}, {x0, y1, height}}, {{0, 1, 2, 3}}, {}};
}

Shape moebius(int n) {
  Shape strip;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n;
    for (const double s : {-0.3, 0.3}) {
      const double radius = 1 + s * std::cos(a / 2);
      strip.points.push_back({radius * std::cos(a), radius * std::sin(a), s * std::sin(a / 2)});
    }
    // Once around, the sides change places.
    const int c = i == n - 1 ? 1 : 2 * i + 2, d = i == n - 1 ? 0 : 2 * i + 3;
    strip.faces.push_back({2 * i, c, d});
    strip.faces.push_back({2 * i, d, 2 * i + 1});
  }
  return strip;
}

Mesh mesh_of(const Shape& shape) {
  Soup soup;
  soup.points = shape.points;
  soup.face_body = shape.bodies;
  soup.format = "test";
  for (const auto& face : shape.faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.face_ends.push_back(static_cast<int>(soup.corners.size()));
  }
  return build_mesh(std::move(soup), "shape");
}

World world_of(const std::vector<Shape>& shapes) {
  std::vector<Placed> models;
  for (const Shape& shape : shapes) models.push_back({std::make_shared<const Mesh>(mesh_of(shape)), Mat4(1.0)});
  return make_world(std::move(models));
}

Projection orthographic(const Vec3& towards_viewer, const Vec3& up) {
  Projection p;
  p.name = "test";
  p.point = Vec3(0);
  p.n = glm::normalize(towards_viewer);
  p.u = glm::normalize(glm::cross(up, p.n));
  p.v = glm::cross(p.n, p.u);
  p.projector = p.n;
  return p;
}

Projection from_above() { return orthographic({0, 0, 1}, {0, 1, 0}); }

Projection perspective(const Vec3& eye, const Vec3& point, const Vec3& normal, const Vec3& up) {
  Projection p = orthographic(normal, up);
  p.central = true;
  p.point = point;
  p.projector = eye;
  return p;
}

int Result::pieces(bool visible) const {
  int count = 0;
  for (const Segment& s : drawing.segments) count += s.visible == visible ? 1 : 0;
  return count;
}

double Result::length(bool visible) const {
  double sum = 0;
  for (const Segment& s : drawing.segments)
    if (s.visible == visible) sum += glm::length(s.to - s.from);
  return sum * unit;
}

Result draw(World world, const Projection& projection, const EdgeWishes& wishes, const ViewLimits& limits) {
  Result r{std::move(world), {}, {}, {}, {}, 1};
  r.view = make_view(r.world, projection, limits);
  r.unit = 1 / r.view.map.shrink;
  r.drawn = find_drawn_edges(r.world, r.view, wishes, contact_in_space(r.world, r.view, std::nullopt));
  const Contact contact = contact_of(r.world, r.view, std::nullopt);
  r.hidden = find_hidden(r.world, r.view, r.drawn, contact);
  r.drawing = make_drawing(r.world, r.view, r.drawn, r.hidden, contact, {1, Vec2(0)}, {"test", true});
  return r;
}

std::vector<std::array<double, 2>> hidden_of_line(const World& world, const Projection& projection, const Vec3& from,
                                                  const Vec3& to) {
  View view = make_view(world, projection, {});
  const int a = add_point(view, from);
  const int b = add_point(view, to);
  DrawnEdges drawn;
  drawn.edges.push_back({{a, b}, {0, 1}, EdgeKind::intersection, 0, -1, 0});
  drawn.crossings.push_back({{from, to}, {-1, -1}, 90});
  return find_hidden(world, view, drawn, contact_of(world, view, std::nullopt)).spans;
}

}  // namespace epura::test
