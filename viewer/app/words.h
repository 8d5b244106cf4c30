// How things are called in the interface.
#pragma once

#include <string>

#include "scene/scene.h"
#include "sectile/trace.h"

namespace sectile::viewer {

std::string name_of(Operation operation);
std::string sign_of(Operation operation);  ///< ∪ ∩ \ in UTF-8
std::string icon_of(Operation operation);  ///< the same as a Venn diagram
std::string kind_of(const Node& node);     ///< "block", "union", …
std::string title_of(Phase phase);         ///< for the time line
std::string capitalised(std::string text);
std::string number(double value);  ///< short, and says "about" nothing
std::string count(std::size_t n);  ///< thousands apart
/// "1 face", "12 faces".
std::string counted(std::size_t n, const std::string& thing);

inline constexpr Phase all_phases[] = {Phase::reduction,  Phase::vertex_face, Phase::vertex_vertex,
                                       Phase::null_edges, Phase::joining,     Phase::components,
                                       Phase::gluing,     Phase::cleanup};

}  // namespace sectile::viewer
