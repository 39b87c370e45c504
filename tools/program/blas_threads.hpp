#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

namespace parison::tools {

/// Keeps the linear algebra to one thread: at these sizes a second gains nothing and changes round-off from run to run.
void use_one_blas_thread();

}  // namespace parison::tools
