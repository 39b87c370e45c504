#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace parison::core {

/// The content followed by a line with its length and its digest, the 64-bit FNV-1a hash. Whatever changes a single
/// byte changes the digest for sure, since every step of the hash is one-to-one; any other damage is missed once in
/// 2^64.
std::string with_digest(std::string content);

/// What `with_digest` was given; nothing where the line is missing or does not fit, so that some byte has changed.
std::optional<std::string> without_digest(std::string text);

/// A group of an HDF5 file; every name is relative to it. Failures throw RunError with file and name.
class Hdf5Group {
 public:
  Hdf5Group(Hdf5Group&& other) noexcept;
  Hdf5Group(const Hdf5Group&) = delete;
  ~Hdf5Group();

  Hdf5Group create(const std::string& name);
  Hdf5Group open(const std::string& name) const;
  bool has(const std::string& name) const;

  void write(const std::string& name, const std::vector<double>& values, int columns = 1);
  void write(const std::string& name, const std::vector<int>& values, int columns = 1);
  void write(const std::string& name, const Eigen::VectorXd& values);
  void write(const std::string& name, double value);
  void write(const std::string& name, std::int64_t value);
  void write(const std::string& name, const std::string& value);

  std::vector<double> read_doubles(const std::string& name) const;
  std::vector<int> read_integers(const std::string& name) const;
  Eigen::VectorXd read_vector(const std::string& name) const;
  double read_double(const std::string& name) const;
  std::int64_t read_integer(const std::string& name) const;
  std::string read_string(const std::string& name) const;

 private:
  friend void write_hdf5(const std::string& path, const std::function<void(Hdf5Group& root)>& fill);
  friend Hdf5Group open_hdf5(const std::string& path);
  using Close = int (*)(std::int64_t);
  Hdf5Group(std::string file, std::int64_t id, Close close) : file_(std::move(file)), id_(id), close_(close) {}

  std::string file_;
  std::int64_t id_;  ///< of the library
  Close close_;
};

/// Makes a file of what `fill` writes into its root group, with a digest behind its end, which other readers of HDF5
/// files pass over. It is on the disk when this returns; until then the old file stays.
void write_hdf5(const std::string& path, const std::function<void(Hdf5Group& root)>& fill);

/// The largest file that is read, bytes.
inline constexpr std::size_t max_hdf5_bytes = 4'000'000'000;

/// A file of `write_hdf5` with every byte as it was written.
struct Hdf5Content {
  std::string image;    ///< without the digest
  std::string problem;  ///< empty, or why there is no image: "is damaged: ..."
};

/// Reads a file and compares its digest. The library, which may crash on damaged files, is not asked.
Hdf5Content read_hdf5(const std::string& path);

/// The root group of an existing file, of which only the copy in memory is used; throws where `read_hdf5` has a
/// problem.
Hdf5Group open_hdf5(const std::string& path);

}  // namespace parison::core
