// The symbol that tells first angle from third angle projection. ISO 5456-2.
#pragma once

namespace epura {

/// In first angle projection each view stands on the side away from which it is seen: the view from above below the
/// front view. In third angle projection it stands on the side from which it is seen.
enum class ProjectionAngle { first, third };

}  // namespace epura
