#include "scene/scene_file.hpp"
namespace epura {
SceneDescription read_scene_file(const std::filesystem::path&) { return {}; }
}  // namespace epura
