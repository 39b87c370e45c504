// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/server/page_rules.hpp"

#include <boost/beast/http/field.hpp>
#include <cctype>
#include <fstream>

#include "core/io/json.hpp"
#include "core/process/run_error.hpp"

namespace parison::tools {
namespace {

namespace http = boost::beast::http;

std::string header(const HttpRequest& request, http::field field) {
  return std::string(request[field]);
}

/// Whether a request names this machine: a page of another site could otherwise reach the server by a name of its own.
bool is_local(const std::string& host) {
  const std::string name = host.substr(0, host.rfind(':'));
  return name == "127.0.0.1" || name == "localhost";
}

/// Whether a page of this server asks, as far as the browser says it.
bool is_own_page(const HttpRequest& request) {
  const std::string origin = header(request, http::field::origin);
  return origin.empty() || origin == "http://" + header(request, http::field::host);
}

/// The address behind the token, as it was sent, without a question; nothing where the token is another one.
std::optional<std::string> behind_token(const PageService& service, const HttpRequest& request) {
  const std::string target(request.target()), begin = service.token.empty() ? "/" : "/" + service.token + "/";
  if (target.compare(0, begin.size(), begin) != 0) return {};
  return target.substr(begin.size(), target.find('?') - begin.size());
}

/// "%20" and the like as what they stand for.
std::string decoded(const std::string& text) {
  std::string found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_code = text[i] == '%' && i + 2 < text.size() &&
                         std::isxdigit(static_cast<unsigned char>(text[i + 1])) &&
                         std::isxdigit(static_cast<unsigned char>(text[i + 2]));
    found += is_code ? static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16)) : text[i];
    if (is_code) i += 2;
  }
  return found;
}

}  // namespace

std::string random_token() {
  std::ifstream random("/dev/urandom", std::ios::binary);
  constexpr int bytes = 16;
  constexpr const char* digits = "0123456789abcdef";
  std::string token;
  for (int i = 0; i < bytes; ++i) {
    const int byte = random.get();
    if (!random) throw core::RunError("/dev/urandom: no random numbers can be read");
    token += {digits[byte / 16], digits[byte % 16]};
  }
  return token;
}

PageAnswer refusal(int status, const std::string& sentence) {
  core::JsonWriter json;
  json.add("error", sentence);
  PageAnswer answer;
  answer.status = status;
  answer.body = json.finish();
  return answer;
}

std::optional<PageAnswer> refused(const PageService& service, const HttpRequest& request) {
  if (!is_local(header(request, http::field::host))) return refusal(403, "another host name was found");
  if (!is_own_page(request)) return refusal(403, "a page of another site asked");
  if (!behind_token(service, request))
    return service.token.empty() ? refusal(404, "no such address")
                                 : refusal(403, "the address has another token than the server printed");
  const bool posts = request.method() == http::verb::post;
  if (posts && service.largest_body > 0) {
    const std::string type = header(request, http::field::content_type);
    if (type.substr(0, type.find(';')) != "application/json") return refusal(415, "allowed is application/json");
  } else if (posts || (request.method() != http::verb::get && request.method() != http::verb::head)) {
    return refusal(405, "this method is not allowed");
  }
  return {};
}

PageRequest page_request(const PageService& service, const HttpRequest& request) {
  return {request.method() == http::verb::post, decoded(behind_token(service, request).value_or("")), request.body()};
}

}  // namespace parison::tools
