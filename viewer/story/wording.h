// Names and turns of phrase that the texts of all phases share.
#pragma once

#include <string>
#include <string_view>

#include "story/story_record.h"

namespace sectile::viewer {

/// "vertex v3", "edge e2", "face f1".
std::string with_kind(const TraceEntity& entity);
/// The same with "of A" or "of B".
std::string of_solid(int solid, const TraceEntity& entity);
/// "∪", "∩" or "\".
std::string sign(Operation operation);
/// "A ∪ B", …
std::string formula(Operation operation);
/// Equation (4) for an operation, as a sentence.
std::string equation_4(Operation operation);
/// "1 face", "2 faces".
std::string counted(std::size_t number, std::string_view one);
std::string capital(std::string text);
/// "(1, 2.5, 3)".
std::string coordinates(const Vec3& point);

}  // namespace sectile::viewer
