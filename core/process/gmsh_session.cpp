// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/gmsh_session.hpp"

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

/// Of OpenMP, where gmsh is built with it.
extern "C" __attribute__((weak)) int omp_get_max_threads();
extern "C" __attribute__((weak)) void omp_set_num_threads(int count);

namespace parison::core {

namespace {

std::mutex& gmsh_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// The number of OpenMP threads of this thread, which initialising gmsh sets to one.
class OpenMpThreads {
 public:
  OpenMpThreads() : count_(omp_get_max_threads ? omp_get_max_threads() : 0) {}
  ~OpenMpThreads() {
    if (omp_set_num_threads) omp_set_num_threads(count_);
  }
  OpenMpThreads(const OpenMpThreads&) = delete;
  OpenMpThreads& operator=(const OpenMpThreads&) = delete;

 private:
  int count_;
};

/// The locale of the process, which initialising gmsh sets to that of the environment.
class Locale {
 public:
  Locale() : name_(std::setlocale(LC_ALL, nullptr)) {}
  ~Locale() {
    if (name_ != std::setlocale(LC_ALL, nullptr)) std::setlocale(LC_ALL, name_.c_str());
  }
  Locale(const Locale&) = delete;
  Locale& operator=(const Locale&) = delete;

 private:
  std::string name_;
};

/// A stream of std::rand of its own; that of the program continues where it was at the end of the scope.
class RandomNumbers {
 public:
  RandomNumbers() : before_(initstate(1, state_.data(), state_.size())) {}
  ~RandomNumbers() { setstate(before_); }
  RandomNumbers(const RandomNumbers&) = delete;
  RandomNumbers& operator=(const RandomNumbers&) = delete;
  void restart() { std::srand(1); }

 private:
  alignas(long) std::array<char, 128> state_{};  ///< as many bytes as the C library's own state has: the same numbers
  char* before_;
};

/// Whether gmsh is initialised. Version 4.8 has no query for it: where it is not, asking for an option leaves the value
/// untouched or, after a gmsh::finalize, prints a line and throws.
bool is_initialised() {
  double terminal = -1;
  try {
    gmsh::option::getNumber("General.Terminal", terminal);
  } catch (const std::string&) {
    return false;
  }
  return terminal >= 0;
}

/// gmsh, initialised where it is not. It stays so: whether it is could not be asked silently after gmsh::finalize.
struct Initialised {
  Initialised() {
    if (!is_initialised()) gmsh::initialize(0, nullptr, false);
  }
};

}  // namespace

/// The extent of the model that was synchronised last, from which gmsh takes the default size of elements in every
/// model. Its options are read-only; a model of two points gives them their values back.
struct Extent {
  std::array<double, 3> low{}, high{};

  Extent() {
    constexpr std::array<const char*, 3> low_names{"General.MinX", "General.MinY", "General.MinZ"};
    constexpr std::array<const char*, 3> high_names{"General.MaxX", "General.MaxY", "General.MaxZ"};
    for (std::size_t i = 0; i < low.size(); ++i) {
      gmsh::option::getNumber(low_names[i], low[i]);
      gmsh::option::getNumber(high_names[i], high[i]);
    }
  }
  template <typename Owner>
  void restore(const Owner& owner) const {
    owner.add_model();
    for (const auto& [x, y, z] : {low, high}) gmsh::model::geo::addPoint(x, y, z);
    gmsh::model::geo::synchronize();
    gmsh::model::remove();
  }
};

/// Members in the order in which they are taken; they are given back in the reverse order.
struct GmshSession::Data {
  std::lock_guard<std::mutex> lock{gmsh_mutex()};
  OpenMpThreads threads;
  Locale locale;
  RandomNumbers random;
  Initialised initialised;
  Extent extent;
  std::vector<std::pair<std::string, double>> options;  ///< with the values they had before, in the order of setting
  std::string model_before;

  ~Data() {
    gmsh::model::remove();
    extent.restore(*this);
    gmsh::model::setCurrent(model_before);
    for (auto option = options.rbegin(); option != options.rend(); ++option)
      gmsh::option::setNumber(option->first, option->second);
  }
  void set_option(const char* name, double value) {
    double before = 0;
    gmsh::option::getNumber(name, before);
    options.emplace_back(name, before);
    gmsh::option::setNumber(name, value);
  }
  /// Makes a model under a name that no other has.
  void add_model() const {
    std::vector<std::string> names;
    gmsh::model::list(names);
    std::string name = "parison";
    while (std::count(names.begin(), names.end(), name) > 0) name += '_';
    gmsh::model::add(name);
  }
};

GmshSession::GmshSession() : data_(std::make_unique<Data>()) {
  for (const char* off : {"General.Terminal", "General.AbortOnError"}) set_option(off, 0);
  set_option("General.NumThreads", 1);
  gmsh::model::getCurrent(data_->model_before);
  data_->add_model();
}

GmshSession::~GmshSession() = default;

void GmshSession::renew_model() {
  gmsh::model::remove();
  data_->add_model();
}

void GmshSession::set_option(const char* name, double value) {
  data_->set_option(name, value);
}

void GmshSession::restart_random_numbers() {
  data_->random.restart();
}

extern "C" void parison_in_gmsh_session(const std::function<void()>& work) {
  const GmshSession session;
  work();
}

}  // namespace parison::core
