#include "io/pending_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "error.h"
#include "io/descriptor_stream.h"

namespace partwise::io {
namespace {

constexpr mode_t kMode = 0666;  // the user's umask takes its share

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

void run_writer(DescriptorStream& stream, const std::function<void(std::ostream&)>& writer) {
  try {
    writer(stream);
  } catch (const IoError&) {
    stream.require_good();  // knows better why
    throw;
  }
  stream.require_good();
}

void sync_folder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

PendingFile::PendingFile(std::string path) : path_(std::move(path)) {
  const std::filesystem::path target(path_);
  const std::string name = "." + target.filename().string() + "." + std::to_string(::getpid()) + ".part";
  temporary_ = (target.parent_path() / name).string();
  descriptor_ = ::open(folder_of(path_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kMode);
  nameless_ = descriptor_ >= 0;
  if (!nameless_) {
    descriptor_ = ::open(temporary_.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, kMode);
  }
  if (descriptor_ < 0) fail("cannot be made");
}

PendingFile::~PendingFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!nameless_ && !temporary_.empty()) ::unlink(temporary_.c_str());
}

void PendingFile::fail(const std::string& what) const {
  throw IoError(path_ + ": " + what + ": " + std::strerror(errno));
}

void PendingFile::fill(const std::function<void(std::ostream&)>& writer) {
  DescriptorStream stream(descriptor_, path_);
  run_writer(stream, writer);
  if (::fsync(descriptor_) != 0) fail("cannot be flushed to the disk");
}

void PendingFile::commit(bool overwrite) {
  if (nameless_) {
    const std::string self = "/proc/self/fd/" + std::to_string(descriptor_);
    ::unlink(temporary_.c_str());
    if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) != 0) {
      fail("cannot be named");
    }
    nameless_ = false;
  }
  if (!overwrite) {
    if (::link(temporary_.c_str(), path_.c_str()) != 0) fail("cannot be made");
  } else {
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot be replaced");
    temporary_.clear();
  }
  sync_folder(folder_of(path_));
}

bool is_special_file(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  return std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status) ||
         std::filesystem::is_socket(status);
}

void write_through(const std::string& path, const std::function<void(std::ostream&)>& writer) {
  if (path == "-") {
    DescriptorStream stream(STDOUT_FILENO, "standard output");
    run_writer(stream, writer);
    return;
  }
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) throw IoError(path + ": cannot be opened: " + std::strerror(errno));
  try {
    DescriptorStream stream(descriptor, path);
    run_writer(stream, writer);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  ::close(descriptor);
}

void write_file(const std::string& path, bool overwrite, const std::function<void(std::ostream&)>& writer) {
  if (path == "-" || is_special_file(path)) {
    write_through(path, writer);
    return;
  }
  std::error_code ignored;
  if (!overwrite && std::filesystem::exists(path, ignored)) {
    throw IoError(path + ": exists already: give --force to replace it");
  }
  PendingFile file(path);
  file.fill(writer);
  file.commit(overwrite);
}

}  // namespace partwise::io
