// What no two faces show of a mesh: a shell that was turned inside out, or came to lie in another.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "sectile/mesh.h"

namespace sectile {

/// A face of such a shell, if there is one. The faces must not cross each other.
std::optional<std::uint32_t> face_of_wrong_shell(const PolygonMesh& mesh,
                                                 const std::atomic<bool>* cancel);

}  // namespace sectile
