#include "files/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#include "sectile/errors.h"
#include "sectile/files.h"

namespace sectile {
namespace {

namespace fs = std::filesystem;

// Renaming replaces a link itself, but its user means the file behind it.
fs::path behind_links(const fs::path& path) {
  std::error_code error;
  const fs::path resolved = fs::canonical(path, error);
  return error ? path : resolved;
}

fs::path beside(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  return target.parent_path() /
         (".sectile-" + std::to_string(getpid()) + "-" + std::to_string(count++));
}

}  // namespace

WholeFile::WholeFile(const fs::path& path) : named_(path.string()), target_(behind_links(path)) {
  struct stat old {};
  const bool exists = stat(target_.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) fail(EISDIR);
  if (exists && !S_ISREG(old.st_mode)) {
    open_device();
    return;
  }
  open_beside();
  if (!exists || fchmod(file_, old.st_mode & 07777) == 0) return;
  const int error = errno;
  close(file_);
  unlink(staged_.c_str());
  fail(error);
}

WholeFile::~WholeFile() {
  if (file_ >= 0) close(file_);
  if (!staged_.empty()) unlink(staged_.c_str());
  if (!old_.empty()) unlink(old_.c_str());
}

void WholeFile::open_beside() {
  do {
    staged_ = beside(target_);
    file_ = open(staged_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (file_ < 0 && (errno == EEXIST || errno == EINTR));
  if (file_ < 0) fail(errno);
}

void WholeFile::open_device() {
  do file_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  while (file_ < 0 && errno == EINTR);
  if (file_ < 0) fail(errno);
}

void WholeFile::write(std::string_view content) {
  while (!content.empty()) {
    const ssize_t done = ::write(file_, content.data(), content.size());
    if (done < 0 && errno != EINTR) fail(errno);
    if (done > 0) content.remove_prefix(static_cast<std::size_t>(done));
  }
}

void WholeFile::finish() {
  if (file_ < 0) return;
  if (!staged_.empty() && fsync(file_) != 0) fail(errno);
  const int file = file_;
  file_ = -1;
  if (close(file) != 0) fail(errno);
}

void WholeFile::place(bool keep_old) {
  finish();
  if (staged_.empty()) return;
  if (keep_old) keep_old_content();
  if (rename(staged_.c_str(), target_.c_str()) != 0) fail(errno);
  staged_.clear();
  placed_ = true;
}

void WholeFile::keep_old_content() {
  std::error_code error;
  if (!fs::exists(target_, error)) return;
  const fs::path old = beside(target_);
  fs::create_hard_link(target_, old, error);
  // Not every file system has links.
  if (error) fs::copy_file(target_, old, error);
  if (error) fail(error.value());
  old_ = old;
}

void WholeFile::undo() noexcept {
  if (!placed_) return;
  placed_ = false;
  if (old_.empty()) {
    unlink(target_.c_str());
  } else if (rename(old_.c_str(), target_.c_str()) == 0) {
    old_.clear();
  }
}

void WholeFile::fail(int error) const {
  throw FileError(named_ + ": cannot write: " + std::strerror(error));
}

WholeFiles::WholeFiles() = default;
WholeFiles::~WholeFiles() = default;

void WholeFiles::add(const fs::path& path, std::string_view content) {
  files_.push_back(std::make_unique<WholeFile>(path));
  files_.back()->write(content);
  files_.back()->finish();
}

void WholeFiles::place() {
  try {
    for (const auto& file : files_) file->place(files_.size() > 1);
  } catch (...) {
    for (const auto& file : files_) file->undo();
    throw;
  }
}

void write_whole(const fs::path& path, std::string_view content) {
  WholeFile file(path);
  file.write(content);
  file.place();
}

}  // namespace sectile
