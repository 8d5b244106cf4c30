// Parts of scenes as texts, for the clipboard: what is copied in one window can be pasted in
// another.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace sectile::viewer {

/// The nodes and all below them, where they are in the world (up to rounding, if a node above them
/// was turned or stretched). Throws FileError.
std::string copied_text(const Scene& scene, const std::vector<NodeId>& nodes);
/// The same as a scene. Throws FileError if the text is none.
Scene copied_scene(std::string_view text);
/// Adds all of another scene at the top; gives its roots' new ids.
std::vector<NodeId> insert(Scene& scene, const Scene& added);

}  // namespace sectile::viewer
