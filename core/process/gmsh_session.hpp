#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <memory>

namespace parison::core {

/// Exclusive use of gmsh, which has one state for the whole process: one session at a time, others wait. A session
/// works in a model of its own, on one thread, with gmsh silent and its errors in the log.
///
/// At its end everything is as it was before: the models, the current model and the options of the program around it,
/// the C library's random numbers, the locale, and the number of OpenMP threads. gmsh is initialised by the first
/// session that finds it is not, and never finalised. While a session lasts, other threads must call neither gmsh nor
/// std::rand. In the module of gmsh alone.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Replaces the session's model by an empty one.
  void renew_model();

  /// Sets a numeric option until the end of the session.
  void set_option(const char* name, double value);

  /// Starts the random numbers that gmsh takes from the C library anew, for the session alone, with seed 1.
  void restart_random_numbers();

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Does work in a session; in the module of gmsh.
extern "C" void parison_in_gmsh_session(const std::function<void()>& work);

}  // namespace parison::core
