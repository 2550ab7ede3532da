#pragma once

#include <stdexcept>
#include <string>

namespace partwise {

/// Base of every error the project throws. The message says what is wrong, where (vertex, facet, line), and
/// what to do; the tool adds its own name and the file's.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// Exit code of a tool that ends with this error.
  virtual int exit_code() const = 0;
};

/// A computation did not reach its result although its input was valid.
class ComputationError : public Error {
 public:
  using Error::Error;
  int exit_code() const override { return 1; }
};

/// The command line is wrong.
class UsageError : public Error {
 public:
  using Error::Error;
  int exit_code() const override { return 2; }
};

/// An input violates its schema or a precondition.
class InputError : public Error {
 public:
  using Error::Error;
  int exit_code() const override { return 3; }
};

/// A file cannot be read or written.
class IoError : public Error {
 public:
  using Error::Error;
  int exit_code() const override { return 4; }
};

/// The reader of our output has ended: nobody is left to be told.
class BrokenPipe : public IoError {
 public:
  using IoError::IoError;
};

}  // namespace partwise
