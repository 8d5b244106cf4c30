// A whole file or stream in memory.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

namespace sectile {

/// Throws FileError with the system's reason; also for a file without a single byte.
std::string content_of(const std::filesystem::path& path);
std::string content_of(std::istream& in, std::string_view name);

}  // namespace sectile
