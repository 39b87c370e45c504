// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>

#include "core/case/case_error.hpp"
#include "core/process/run_error.hpp"
#include "tools/commands/commands.hpp"
#include "tools/program/blas_threads.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/kept_memory.hpp"

namespace {

using namespace parison;

int fail(tools::ExitCode code, const char* what) {
  fmt::print(stderr, "parison: {}\n", what);
  return code;
}

/// What the system refuses is a mistake in the command line where it is about the path that was given.
tools::ExitCode code_of(const std::error_code& error) {
  for (const std::errc wrong :
       {std::errc::permission_denied, std::errc::operation_not_permitted, std::errc::no_such_file_or_directory,
        std::errc::not_a_directory, std::errc::is_a_directory, std::errc::filename_too_long,
        std::errc::too_many_symbolic_link_levels, std::errc::read_only_file_system})
    if (error == wrong) return tools::case_wrong;
  return tools::run_failed;
}

/// Opens standard input, output and error on /dev/null where they are closed. A file opened later would otherwise get
/// the number of standard output, and what is printed would go into the results.
void open_standard_streams() {
  int file = 0;
  while (file >= 0 && file <= STDERR_FILENO) file = ::open("/dev/null", O_RDWR);
  if (file > STDERR_FILENO) ::close(file);
}

/// Runs the command; its results may be there, yet what it printed is lost where that could not be written.
int run(const tools::Command& command) {
  const int code = command();
  const bool was_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (was_written || code != 0) return code;
  return fail(tools::run_failed, "not all that was printed could be written to the standard output");
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  CLI::App app("Parison: forming of glass containers, from the gob to the take-out.");
  app.set_version_flag("--version", PARISON_VERSION);
  tools::Command command;
  tools::add_commands(app, command);
  tools::use_one_blas_thread();
  tools::keep_freed_memory();
  try {
    tools::check_command(app, argc, argv);
    app.parse(argc, argv);
    return run(command);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : tools::case_wrong;
  } catch (const core::CaseError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return tools::case_wrong;
  } catch (const core::SystemError& error) {
    return fail(code_of({error.code, std::generic_category()}), error.what());
  } catch (const core::RunError& error) {
    return fail(tools::run_failed, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string what = fmt::format("{}: {}; allowed is a file or folder that can be used", error.path1().string(),
                                         error.code().message());
    return fail(code_of(error.code()), what.c_str());
  } catch (const std::system_error& error) {
    return fail(tools::run_failed, error.what());
  } catch (const std::bad_alloc&) {
    return fail(tools::internal_error, "out of memory; a run can be resumed from its last checkpoint");
  } catch (const std::exception& error) {
    fmt::print(stderr,
               "parison: an error in the program, not in the case: {}; a run can be resumed from its last "
               "checkpoint\n",
               error.what());
    return tools::internal_error;
  }
}
