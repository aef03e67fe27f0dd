// Why an edge is drawn.
#pragma once

#include <cstdint>
#include <string_view>

namespace epura {

/// In order of priority where several fall on one line of the page.
enum class EdgeKind : std::uint8_t { contour, boundary, crease, intersection, section, smooth };

std::string_view name_of(EdgeKind kind);

}  // namespace epura
