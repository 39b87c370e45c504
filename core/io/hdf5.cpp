// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/hdf5.hpp"

#include <fmt/core.h>
#include <fmt/format.h>
#include <hdf5.h>

#include <mutex>
#include <utility>

#include "core/io/files.hpp"
#include "core/io/input_file.hpp"
#include "core/process/run_error.hpp"

namespace parison::core {

namespace {

std::string last_line(const std::string& content) {
  return fmt::format("\nlength {:016x} digest {}\n", content.size(), fingerprint_text(fingerprint(content)));
}

}  // namespace

std::string with_digest(std::string content) {
  content += last_line(content);
  return content;
}

std::optional<std::string> without_digest(std::string text) {
  const std::size_t length = last_line("").size();
  if (text.size() < length) return {};
  const std::string found = text.substr(text.size() - length);
  text.resize(text.size() - length);
  if (found != last_line(text)) return {};
  return text;
}

namespace {

using Id = std::int64_t;

[[noreturn]] void fail(const std::string& file, const std::string& what) {
  throw RunError(fmt::format("{}: {}", file, what));
}

/// A use of the library, which not every build of it allows to several threads at once: others wait. Meanwhile the
/// library prints nothing in this thread, as errors come as exceptions.
class LibraryCall {
 public:
  LibraryCall() : lock_(mutex()) {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~LibraryCall() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  LibraryCall(const LibraryCall&) = delete;
  LibraryCall& operator=(const LibraryCall&) = delete;

 private:
  static std::recursive_mutex& mutex() {
    static std::recursive_mutex the_only;
    return the_only;
  }
  std::lock_guard<std::recursive_mutex> lock_;
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// An identifier of the library, closed at the end of its scope.
struct Handle {
  hid_t id;
  herr_t (*close)(hid_t);
  ~Handle() {
    if (id >= 0) close(id);
  }
};

/// Where data goes to or comes from, for the sentence of an error.
struct Place {
  const std::string& file;
  hid_t group;
  const std::string& name;
};

void write_array(const Place& place, hid_t type, const void* data, std::size_t count, int columns = 1) {
  const LibraryCall call;
  const hsize_t size[2] = {count / columns, static_cast<hsize_t>(columns)};
  const Handle space{H5Screate_simple(columns > 1 ? 2 : 1, size, nullptr), H5Sclose};
  const Handle kind{H5Pcreate(H5P_DATASET_CREATE), H5Pclose};
  H5Pset_obj_track_times(kind.id, false);  // the same content makes the same file
  const Handle set{H5Dcreate2(place.group, place.name.c_str(), type, space.id, H5P_DEFAULT, kind.id, H5P_DEFAULT),
                   H5Dclose};
  if (set.id < 0 || (count > 0 && H5Dwrite(set.id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0))
    fail(place.file, fmt::format("\"{}\" cannot be written", place.name));
}

template <typename Value>
std::vector<Value> read_array(const Place& place, hid_t type) {
  const LibraryCall call;
  const Handle set{H5Dopen2(place.group, place.name.c_str(), H5P_DEFAULT), H5Dclose};
  if (set.id < 0) fail(place.file, fmt::format("\"{}\" is missing", place.name));
  const Handle space{H5Dget_space(set.id), H5Sclose};
  std::vector<Value> values(H5Sget_simple_extent_npoints(space.id));
  if (!values.empty() && H5Dread(set.id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    fail(place.file, fmt::format("\"{}\" cannot be read", place.name));
  return values;
}

template <typename Value>
Value only(const Place& place, const std::vector<Value>& values) {
  if (values.size() != 1) fail(place.file, fmt::format("\"{}\" is not a single value", place.name));
  return values[0];
}

}  // namespace

Hdf5Group::Hdf5Group(Hdf5Group&& other) noexcept
    : file_(std::move(other.file_)), id_(std::exchange(other.id_, -1)), close_(other.close_) {}

Hdf5Group::~Hdf5Group() {
  if (id_ < 0) return;
  const LibraryCall call;
  close_(id_);
}

Hdf5Group Hdf5Group::create(const std::string& name) {
  const LibraryCall call;
  const Id id = H5Gcreate2(id_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  if (id < 0) fail(file_, fmt::format("group \"{}\" cannot be made", name));
  return {file_, id, H5Gclose};
}

Hdf5Group Hdf5Group::open(const std::string& name) const {
  const LibraryCall call;
  const Id id = H5Gopen2(id_, name.c_str(), H5P_DEFAULT);
  if (id < 0) fail(file_, fmt::format("group \"{}\" is missing", name));
  return {file_, id, H5Gclose};
}

bool Hdf5Group::has(const std::string& name) const {
  const LibraryCall call;
  return H5Lexists(id_, name.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5Group::write(const std::string& name, const std::vector<double>& values, int columns) {
  write_array({file_, id_, name}, H5T_NATIVE_DOUBLE, values.data(), values.size(), columns);
}
void Hdf5Group::write(const std::string& name, const std::vector<int>& values, int columns) {
  write_array({file_, id_, name}, H5T_NATIVE_INT, values.data(), values.size(), columns);
}
void Hdf5Group::write(const std::string& name, const Eigen::VectorXd& values) {
  write_array({file_, id_, name}, H5T_NATIVE_DOUBLE, values.data(), values.size());
}
void Hdf5Group::write(const std::string& name, double value) {
  write_array({file_, id_, name}, H5T_NATIVE_DOUBLE, &value, 1);
}
void Hdf5Group::write(const std::string& name, std::int64_t value) {
  write_array({file_, id_, name}, H5T_NATIVE_INT64, &value, 1);
}
void Hdf5Group::write(const std::string& name, const std::string& value) {
  write_array({file_, id_, name}, H5T_NATIVE_CHAR, value.data(), value.size());
}

std::vector<double> Hdf5Group::read_doubles(const std::string& name) const {
  return read_array<double>({file_, id_, name}, H5T_NATIVE_DOUBLE);
}
std::vector<int> Hdf5Group::read_integers(const std::string& name) const {
  return read_array<int>({file_, id_, name}, H5T_NATIVE_INT);
}
Eigen::VectorXd Hdf5Group::read_vector(const std::string& name) const {
  const std::vector<double> values = read_doubles(name);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}
double Hdf5Group::read_double(const std::string& name) const {
  const Place place{file_, id_, name};
  return only(place, read_array<double>(place, H5T_NATIVE_DOUBLE));
}
std::int64_t Hdf5Group::read_integer(const std::string& name) const {
  const Place place{file_, id_, name};
  return only(place, read_array<std::int64_t>(place, H5T_NATIVE_INT64));
}
std::string Hdf5Group::read_string(const std::string& name) const {
  const auto text = read_array<char>({file_, id_, name}, H5T_NATIVE_CHAR);
  return {text.begin(), text.end()};
}

void write_hdf5(const std::string& path, const std::function<void(Hdf5Group& root)>& fill) {
  const LibraryCall call;
  const Handle access{H5Pcreate(H5P_FILE_ACCESS), H5Pclose};
  constexpr std::size_t growth = 1 << 20;
  H5Pset_fapl_core(access.id, growth, 0);  // in memory: a full disk meets plain writes alone
  const Id id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id);
  if (id < 0) fail(path, "cannot be made");
  Hdf5Group root(path, id, H5Fclose);
  fill(root);
  if (H5Fflush(id, H5F_SCOPE_GLOBAL) < 0) fail(path, "cannot be made");
  std::string image(H5Fget_file_image(id, nullptr, 0), 0);
  if (H5Fget_file_image(id, image.data(), image.size()) < 0) fail(path, "cannot be made");
  replace_file(path, with_digest(std::move(image)));
}

Hdf5Content read_hdf5(const std::string& path) {
  InputFile file = read_input_file(path, max_hdf5_bytes);
  if (!file.problem.empty()) return {"", std::move(file.problem)};
  auto image = without_digest(std::move(file.content));
  if (!image) return {"", "is damaged or of an earlier version: its digest is missing or does not fit its content"};
  return {std::move(*image), ""};
}

Hdf5Group open_hdf5(const std::string& path) {
  Hdf5Content content = read_hdf5(path);
  if (!content.problem.empty()) fail(path, content.problem);
  const LibraryCall call;
  const Handle access{H5Pcreate(H5P_FILE_ACCESS), H5Pclose};
  constexpr std::size_t growth = 1 << 20;
  H5Pset_fapl_core(access.id, growth, 0);  // the very bytes whose digest was found right
  H5Pset_file_image(access.id, content.image.data(), content.image.size());
  static long opened = 0;  // the library takes an image only under a name that no file has
  const Id id = H5Fopen(fmt::format("{}/{}", path, ++opened).c_str(), H5F_ACC_RDONLY, access.id);
  if (id < 0) fail(path, "is not an HDF5 file that can be read");
  return {path, id, H5Fclose};
}

}  // namespace parison::core
