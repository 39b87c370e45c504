// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/process/run_error.hpp"
#include "tools/program/stop_request.hpp"
#include "tools/report/data/result_folder.hpp"
#include "tools/report/data/run_data.hpp"
#include "tools/report/data/run_names.hpp"
#include "tools/report/report.hpp"

namespace parison::tools {

namespace {

/// A result folder that may grow, end, vanish and begin anew while it is looked at.
class WatchedFolder {
 public:
  explicit WatchedFolder(std::string path) : path_(std::move(path)) {}

  /// A text that changes with what the folder shows.
  std::string stamp() const;

  /// The data of its page, of the last moment at which it could be read; `null` before there is a run.
  const std::string& data();

 private:
  std::string path_, data_ = "null", stamp_of_data_;
  ReportCache cache_;
};

namespace fs = std::filesystem;

std::string WatchedFolder::stamp() const {
  std::string text;
  for (const char* name : {"history.csv", "glass.pvd", "summary.json", "case/command.txt"}) {
    std::error_code missing;
    const fs::path file = fs::path(path_) / name;
    const auto size = fs::file_size(file, missing);
    const auto time = fs::last_write_time(file, missing);
    text += missing ? "-" : fmt::format("{} {},", size, time.time_since_epoch().count());
  }
  std::error_code unreadable;  // as of a link to itself
  const bool ended = fs::exists(fs::path(path_) / "summary.json", unreadable);
  return core::fingerprint_text(core::fingerprint(text + (ended || is_written(path_) ? "1" : "0")));
}

const std::string& WatchedFolder::data() {
  const std::string now = stamp();
  if (now == stamp_of_data_) return data_;
  try {
    data_ = is_result_folder(path_) ? report_data({path_}, true, cache_) : "null";
    stamp_of_data_ = now;
  } catch (const core::CaseError&) {  // the folder is being made or removed: the next look shows it
  } catch (const core::RunError&) {
  } catch (const fs::filesystem_error&) {
  }
  return data_;
}

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using Tcp = asio::ip::tcp;
using Request = http::request<http::empty_body>;
using Response = http::response<http::string_body>;

constexpr auto patience = std::chrono::seconds(20);  ///< with a browser that is silent
constexpr int tried_ports = 20;
constexpr const char* policy =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; connect-src 'self'; img-src data:; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Whether a request names this machine: a page of another site could otherwise reach the server by a name of its own.
bool is_local(const std::string& host) {
  const std::string name = host.substr(0, host.rfind(':'));
  return name == "127.0.0.1" || name == "localhost";
}

Response answer(const Request& request, WatchedFolder& folder, const std::string& page) {
  Response response(http::status::ok, request.version());
  response.set(http::field::cache_control, "no-store");
  response.set("Content-Security-Policy", policy);
  response.set("X-Content-Type-Options", "nosniff");
  response.set(http::field::content_type, "application/json");
  const std::string target(request.target());
  if (!is_local(std::string(request[http::field::host]))) {
    response.result(http::status::forbidden);
  } else if (request.method() != http::verb::get && request.method() != http::verb::head) {
    response.result(http::status::method_not_allowed);
  } else if (target == "/") {
    response.set(http::field::content_type, "text/html; charset=utf-8");
    response.body() = page;
  } else if (target == "/stamp") {
    response.body() = '"' + folder.stamp() + '"';
  } else if (target == "/data") {
    response.body() = folder.data();
  } else {
    response.result(http::status::not_found);
  }
  response.keep_alive(request.keep_alive());
  response.prepare_payload();
  if (request.method() == http::verb::head) response.body().clear();
  return response;
}

/// One connection of a browser; it lives as long as one of its operations waits.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(Tcp::socket&& socket, WatchedFolder& folder, const std::string& page)
      : stream_(std::move(socket)), folder_(folder), page_(page) {}

  void read() {
    request_ = {};
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, request_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (!error) self->write();
    });
  }

 private:
  void write() {
    response_ = answer(request_, folder_, page_);
    stream_.expires_after(patience);
    http::async_write(stream_, response_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (!error && self->response_.keep_alive()) self->read();
    });
  }

  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{8192};
  Request request_;
  Response response_;
  WatchedFolder& folder_;
  const std::string& page_;
};

void accept(Tcp::acceptor& acceptor, WatchedFolder& folder, const std::string& page) {
  acceptor.async_accept([&](beast::error_code error, Tcp::socket socket) {
    if (!error) std::make_shared<Session>(std::move(socket), folder, page)->read();
    accept(acceptor, folder, page);
  });
}

/// Listens on the loopback address at the first free port from the one asked for.
Tcp::acceptor listen(asio::io_context& context, int port) {
  for (int i = 0; i < tried_ports && port + i < 65536; ++i) {
    const Tcp::endpoint endpoint(asio::ip::address_v4::loopback(), static_cast<unsigned short>(port + i));
    Tcp::acceptor acceptor(context, endpoint.protocol());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    beast::error_code error;
    acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (!error) return acceptor;
  }
  throw core::RunError(fmt::format("--live: ports {} to {} are taken, give another one with --port", port,
                                   std::min(port + tried_ports, 65536) - 1));
}

}  // namespace

int watch(const LiveReportRequest& request) {
  if (request.folders.size() != 1)
    throw core::CaseError(fmt::format("--live: {} folders were found, allowed is one", request.folders.size()));
  const std::string& given = request.folders.front();
  std::error_code error;
  const auto found = std::filesystem::status(given, error).type();
  if (found != std::filesystem::file_type::not_found && found != std::filesystem::file_type::directory)
    throw core::CaseError(
        fmt::format("{}: is no folder, allowed is the result folder of a run, also one that is still to come", given));
  if (const std::string runs = run_folders_hint(given); !runs.empty())
    throw core::CaseError(fmt::format("{}: is the folder of several runs, allowed is that of one; {}", given, runs));
  WatchedFolder folder(given);
  const std::string page = page_text(given, "null");
  asio::io_context context(1);
  Tcp::acceptor acceptor = listen(context, request.port);
  accept(acceptor, folder, page);
  fmt::print("{} at http://127.0.0.1:{}/ on this machine only, until Ctrl-C\n", given,
             acceptor.local_endpoint().port());
  std::fflush(stdout);
  catch_signals();
  while (!stop_requested()) context.run_for(std::chrono::milliseconds(200));
  return 0;
}

}  // namespace parison::tools
