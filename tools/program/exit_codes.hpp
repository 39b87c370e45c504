#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

namespace parison::tools {

/// Exit codes of the program other than 0.
enum ExitCode {
  run_failed = 1,       ///< a run did not come to its end, or the system refused something
  case_wrong = 2,       ///< the case file or the command line is wrong
  not_trustworthy = 3,  ///< a run completed, but a check of its results is far beyond its limit
  internal_error = 4    ///< a mistake in the program, or no memory left
};

}  // namespace parison::tools
