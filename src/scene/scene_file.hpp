#pragma once
#include <filesystem>

#include "scene/description.hpp"
namespace epura {
SceneDescription read_scene_file(const std::filesystem::path& path);
}
