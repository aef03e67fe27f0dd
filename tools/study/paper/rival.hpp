// SPDX-License-Identifier: Apache-2.0
// Other programs that remove hidden lines from meshes, for comparison.
#pragma once

#include <string>
#include <vector>

#include "mesh/soup.hpp"
#include "study/accuracy/ink_distance.hpp"

namespace epura::study {

/// Started by a shell as `command MESH.off LINES.txt`. It writes a row "x0 y0 x1 y1" for each visible line of the
/// isometric view, in units of the mesh, x to the right and y upwards through its origin; and prints on stderr rows
/// "STAGE SECONDS s", as `epura draw --timings` does. All stages count but `read` and `write`. Beside the mesh lies
/// bodies.txt with the surfaces (describe_bodies), for programs that draw these. Exit code 77: it cannot draw them.
struct Rival {
  std::string name, command;
};

/// Of "NAME=COMMAND". Throws Error{input} for other texts.
Rival parse_rival(const std::string& text);

struct RivalDrawing {
  std::vector<InkLine> lines;
  double seconds = 0;
  bool can = true;  ///< whether it draws such bodies
};

/// Throws Error{input} with the program's last words if it fails, or if its files are not as described.
RivalDrawing draw_by(const Rival& rival, const mesh::Soup& mesh, const std::string& bodies);

}  // namespace epura::study
