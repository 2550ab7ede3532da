#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace partwise::io {

/// A file that gets its name only when it is complete.
///
/// Where the file system can, it is written without any name, so that nothing remains of it even when the
/// process is killed; elsewhere under a temporary name beside, which is removed on failure.
class PendingFile {
 public:
  /// \throws IoError when no file can be made in the folder of `path`.
  explicit PendingFile(std::string path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Lets `writer` write and flushes to the disk. \throws IoError; what `writer` throws
  void fill(const std::function<void(std::ostream&)>& writer);

  /// Gives the file its name, replacing a file of that name when `overwrite`. \throws IoError
  void commit(bool overwrite);

 private:
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;
  std::string temporary_;  ///< name beside the output; of no file yet when `nameless_`
  int descriptor_ = -1;
  bool nameless_ = false;
};

/// Writes one file whole or not at all, or into a FIFO or device of that name.
/// \throws IoError, also when it exists and `overwrite` is false; what `writer` throws
void write_file(const std::string& path, bool overwrite, const std::function<void(std::ostream&)>& writer);

/// Whether `path` exists and is a FIFO or device, into which one writes directly.
bool is_special_file(const std::string& path);

/// Writes straight to standard output ("-") or a special file. \throws BrokenPipe, IoError
void write_through(const std::string& path, const std::function<void(std::ostream&)>& writer);

}  // namespace partwise::io
