// SPDX-License-Identifier: Apache-2.0
// The PHIGS viewing model: all view parameters in one projection, central or parallel.
#include "../upright.hpp"
#include "perspective.hpp"

using namespace perspective;

struct Phigs {
  static constexpr auto name = "phigs";
  static constexpr auto family = "perspective";
  static constexpr auto summary = "the PHIGS view: reference point, normal, up, PRP, window, clipping planes";
  static constexpr auto reference = "ISO/IEC 9592-1 (PHIGS)";
  static constexpr double any = unlimited;
  static constexpr std::array parameters{
      choice("kind", "central, or parallel along PRP - window centre", "parallel|perspective", 1),
      vector<3>("vrp", "model units", "view reference point; the model's centre unless given"),
      vector<3>("vpn", "1", "view plane normal, towards the viewer", {1, -1, 1}),
      vector<3>("vup", "1", "upward direction of the view; seen end-on, z stands for that of top or bottom", {0, 0, 1}),
      vector<3>("prp", "model units", "projection reference point, in u, v, n from vrp"),
      vector<4>("window", "model units", "umin, vmin, umax, vmax on the view plane; zeros: everything", {0, 0, 0, 0}),
      number("vpd", "model units", "n of the view plane", 0, -any, any),
      number("f", "model units", "n of the front clipping plane; no limit unless given", any, -any, any),
      number("b", "model units", "n of the back clipping plane; no limit unless given", -any, -any, any),
  };

  static View project(const Scene& scene, bool perspective, Vec3 vrp, Vec3 vpn, Vec3 vup, Vec3 prp,
                      const std::array<double, 4>& window, double vpd, double f, double b) {
    vrp = given_or(vrp, scene.centre());
    prp = given_or(prp, {0, 0, vpd + calm_distance * scene.diagonal()});
    if (!(prp.z > vpd)) throw std::invalid_argument("prp must lie before the view plane: its n above vpd");
    vup = upright(vup, vpn);
    const Vec3 across = cross(vup, vpn);
    if (!(length(across) > 0)) throw std::invalid_argument("vup must not be parallel to vpn");
    const Vec3 u = unit(across), n = unit(vpn), v = cross(n, u);
    const Vec3 centre{(window[0] + window[2]) / 2, (window[1] + window[3]) / 2, vpd};
    const Vec3 p = perspective ? prp : prp - centre;
    const Vec3 projector = p.x * u + p.y * v + p.z * n;
    return {.central = perspective,
            .point = vrp + vpd * n,
            .normal = n,
            .up = vup,
            .projector = perspective ? vrp + projector : projector,
            .window = window,
            .front = f - vpd,
            .back = b - vpd};
  }
};
EPURA_PROJECTION(Phigs)
