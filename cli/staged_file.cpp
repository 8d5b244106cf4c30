#include "staged_file.h"

#include <unistd.h>

#include <string>

#include "sectile/errors.h"
#include "sectile/files.h"

namespace sectile::cli {
namespace {

namespace fs = std::filesystem;

// Renaming replaces a link itself, but its user means the file behind it.
fs::path behind_links(const fs::path& path) {
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(path, error);
  return error ? path : resolved;
}

fs::path beside(const fs::path& target, const char* what) {
  return target.string() + "." + std::to_string(getpid()) + what;
}

[[noreturn]] void fail(const fs::path& named, const std::string& why) {
  throw FileError(named.string() + ": cannot write: " + why);
}

}  // namespace

StagedFile::StagedFile(const fs::path& target, std::string_view content)
    : named_(target),
      target_(behind_links(target)),
      staged_(beside(target_, ".new")),
      old_(beside(target_, ".old")) {
  try {
    write_whole(staged_, content);
  } catch (const FileError& error) {
    // The user knows the file by another name.
    const std::string message = error.what(), name = staged_.string();
    if (!message.starts_with(name)) throw;
    throw FileError(named_.string() + message.substr(name.size()));
  }
}

StagedFile::~StagedFile() {
  std::error_code ignored;
  if (!placed_) fs::remove(staged_, ignored);
  if (had_old_) fs::remove(old_, ignored);
}

void StagedFile::place(bool keep_old) {
  if (keep_old) keep_old_content();
  std::error_code error;
  fs::rename(staged_, target_, error);
  if (error) fail(named_, error.message());
  placed_ = true;
}

void StagedFile::undo() noexcept {
  if (!placed_) return;
  std::error_code ignored;
  if (had_old_)
    fs::rename(old_, target_, ignored);
  else
    fs::remove(target_, ignored);
  had_old_ = false;
}

void StagedFile::keep_old_content() {
  std::error_code error;
  if (!fs::exists(target_, error)) return;
  fs::create_hard_link(target_, old_, error);
  // Not every file system has links.
  if (error) fs::copy_file(target_, old_, error);
  if (error) fail(named_, error.message());
  had_old_ = true;
}

}  // namespace sectile::cli
