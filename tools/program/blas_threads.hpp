#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

namespace parison::tools {

/// Keeps the linear algebra to one thread: at these sizes a second gains nothing and changes round-off from run to run.
void use_one_blas_thread();

/// The same while one of these lives, in any thread of the program; after the last the number that was before comes
/// back.
class OneBlasThread {
 public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;
};

}  // namespace parison::tools
