// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/server/page_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <memory>
#include <utility>

#include "core/process/run_error.hpp"
#include "tools/program/stop_request.hpp"
#include "tools/server/page_rules.hpp"

namespace parison::tools {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using Tcp = asio::ip::tcp;
using Parser = http::request_parser<http::string_body>;
using Response = http::response<http::string_body>;

constexpr auto patience = std::chrono::seconds(20);  ///< with a browser that is silent
constexpr int tried_ports = 20;

/// What answers, in threads of its own.
struct Workers {
  const PageService& service;
  asio::thread_pool quick{1}, slow{1};

  asio::thread_pool& of(const PageRequest& request) {
    return service.takes_long && service.takes_long(request) ? slow : quick;
  }
};

/// The answer, whatever happens: one that fails must not end the server.
PageAnswer answer_of(const PageService& service, const PageRequest& request) {
  try {
    return service.answer(request);
  } catch (const std::exception& error) {
    return refusal(500, error.what());
  }
}

/// One connection of a browser; it lives as long as one of its operations waits.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(Tcp::socket&& socket, Workers& workers) : stream_(std::move(socket)), workers_(workers) {}

  void read() {
    parser_ = std::make_unique<Parser>();
    parser_->body_limit(std::max<std::size_t>(workers_.service.largest_body, 1));
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error == http::error::body_limit)
        self->refuse_body();
      else if (!error)
        self->take();
    });
  }

 private:
  void refuse_body() {
    ends_ = true;
    write(refusal(
        413, fmt::format("more than {} MB were sent, allowed are so many", workers_.service.largest_body / 1'000'000)));
  }

  void take() {
    ends_ = !parser_->get().keep_alive();
    if (const auto no = refused(workers_.service, parser_->get())) return write(*no);
    auto request = page_request(workers_.service, parser_->get());
    asio::thread_pool& pool = workers_.of(request);
    stream_.expires_never();
    asio::post(pool, [self = shared_from_this(), request = std::move(request)] {
      asio::post(self->stream_.get_executor(),
                 [self, answer = answer_of(self->workers_.service, request)] { self->write(answer); });
    });
  }

  void write(const PageAnswer& answer) {
    response_ = Response(static_cast<http::status>(answer.status), 11);
    response_.set(http::field::cache_control, "no-store");
    response_.set("Content-Security-Policy", answer.policy.empty() ? "default-src 'none'" : answer.policy);
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Referrer-Policy", "no-referrer");
    response_.set(http::field::content_type, answer.type);
    response_.body() = answer.body;
    response_.keep_alive(!ends_);
    response_.prepare_payload();
    if (parser_->get().method() == http::verb::head) response_.body().clear();
    stream_.expires_after(patience);
    http::async_write(stream_, response_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return;
      if (self->ends_)
        self->end();
      else
        self->read();
    });
  }

  /// Lets the other side read the answer before the connection goes, whatever it still sends.
  void end() {
    beast::error_code ignored;
    stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
    drain();
  }
  void drain() {
    stream_.async_read_some(asio::buffer(rest_), [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (!error) self->drain();
    });
  }

  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{65536};
  std::unique_ptr<Parser> parser_;
  Response response_;
  std::array<char, 65536> rest_;
  bool ends_ = false;
  Workers& workers_;
};

void accept(Tcp::acceptor& acceptor, Workers& workers) {
  acceptor.async_accept([&](beast::error_code error, Tcp::socket socket) {
    if (!error) std::make_shared<Session>(std::move(socket), workers)->read();
    accept(acceptor, workers);
  });
}

/// Listens on the loopback address at the first free port from the one asked for.
Tcp::acceptor listen(asio::io_context& context, const std::string& option, int port) {
  for (int i = 0; i < tried_ports && port + i < 65536; ++i) {
    const Tcp::endpoint endpoint(asio::ip::address_v4::loopback(), static_cast<unsigned short>(port + i));
    Tcp::acceptor acceptor(context, endpoint.protocol());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    beast::error_code error;
    acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (!error) return acceptor;
  }
  throw core::RunError(fmt::format("{}: ports {} to {} are taken, give another one with --port", option, port,
                                   std::min(port + tried_ports, 65536) - 1));
}

}  // namespace

void serve(const PageService& service, int port, const std::function<void(const std::string&)>& begun) {
  asio::io_context context(1);
  Workers workers{service};
  Tcp::acceptor acceptor = listen(context, service.option, port);
  accept(acceptor, workers);
  catch_signals();
  begun(fmt::format("http://127.0.0.1:{}/{}", acceptor.local_endpoint().port(),
                    service.token.empty() ? "" : service.token + "/"));
  while (!stop_requested()) context.run_for(std::chrono::milliseconds(200));
  workers.quick.join();
  workers.slow.join();
}

}  // namespace parison::tools
