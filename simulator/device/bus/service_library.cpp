#include "simulator/device/bus/service_library.h"

#include <libwebsockets.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <thread>
#include <utility>
#include <vector>

namespace hallux::simulator {

namespace {

constexpr const char* this_machine = "127.0.0.1";
constexpr std::chrono::milliseconds opened_within{300}, answered_within{300}, said_within{20};
constexpr std::chrono::milliseconds turn_every{1};
/// Its own, a waker and a spare.
constexpr unsigned files_at_once = 8;

/// What the library tells of a connection.
class Conversation {
 public:
  enum class State { Connecting, Open, Over };

  State state = State::Connecting;
  /// That still is to go out.
  std::vector<unsigned char> to_say;
  /// Of the message that is being heard; whole once `is_whole`.
  std::string heard;
  bool is_whole = false, is_too_long = false;
  int status = 0;

  void take(const void* bytes, std::size_t count) {
    is_too_long = is_too_long || heard.size() + count > service_message_bytes;
    if (!is_too_long) heard.append(static_cast<const char*>(bytes), count);
  }
  void forget() {
    heard.clear();
    is_whole = is_too_long = false;
  }
};

/// Sends what is to be sent; -1 ends the connection.
int send(Conversation& talk, lws* connection) {
  if (talk.to_say.empty()) return 0;
  const std::size_t count = talk.to_say.size() - LWS_PRE;
  const int sent = ::lws_write(connection, talk.to_say.data() + LWS_PRE, count, LWS_WRITE_TEXT);
  talk.to_say.clear();
  return sent < static_cast<int>(count) ? -1 : 0;
}

/// Reads what a page holds as it comes.
int read_page(lws* connection) {
  constexpr std::size_t at_once = 2048;
  std::array<char, LWS_PRE + at_once> bytes{};
  char* begin = bytes.data() + LWS_PRE;
  int room = static_cast<int>(at_once);
  return ::lws_http_client_read(connection, &begin, &room);
}

int on_event(lws* connection, lws_callback_reasons reason, void*, void* in, std::size_t length) {
  auto* talk = connection == nullptr
                   ? nullptr
                   : static_cast<Conversation*>(::lws_get_opaque_user_data(connection));
  if (talk == nullptr) return 0;
  switch (reason) {
    case LWS_CALLBACK_CLIENT_ESTABLISHED:
      talk->state = Conversation::State::Open;
      return 0;
    case LWS_CALLBACK_ESTABLISHED_CLIENT_HTTP:
      talk->status = static_cast<int>(::lws_http_client_http_response(connection));
      return 0;
    case LWS_CALLBACK_CLIENT_WRITEABLE:
      return send(*talk, connection);
    case LWS_CALLBACK_CLIENT_RECEIVE:
      // Of several at once the newest counts.
      if (talk->is_whole) talk->forget();
      talk->take(in, length);
      talk->is_whole = ::lws_is_final_fragment(connection) != 0 &&
                       ::lws_remaining_packet_payload(connection) == 0;
      return 0;
    case LWS_CALLBACK_RECEIVE_CLIENT_HTTP:
      return read_page(connection);
    case LWS_CALLBACK_RECEIVE_CLIENT_HTTP_READ:
      talk->take(in, length);
      return 0;
    case LWS_CALLBACK_COMPLETED_CLIENT_HTTP:
      talk->is_whole = true;
      talk->state = Conversation::State::Over;
      return -1;
    case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
    case LWS_CALLBACK_CLIENT_CLOSED:
    case LWS_CALLBACK_CLOSED_CLIENT_HTTP:
    case LWS_CALLBACK_WSI_DESTROY:
      talk->state = Conversation::State::Over;
      return 0;
    default:
      return 0;
  }
}

constexpr std::size_t piece_bytes = 16384;
const std::array<lws_protocols, 2> protocols{{
    {"", on_event, 0, piece_bytes, 0, nullptr, 0},
    {nullptr, nullptr, 0, 0, 0, nullptr, 0},
}};

/// A context of the library with one connection; used by one thread at a time.
class Connection {
 public:
  Connection(std::uint16_t port, const std::string& path, const char* method) {
    ::lws_set_log_level(0, nullptr);
    lws_context_creation_info info{};
    info.port = CONTEXT_PORT_NO_LISTEN;
    info.protocols = protocols.data();
    info.gid = static_cast<decltype(info.gid)>(-1);
    info.uid = static_cast<decltype(info.uid)>(-1);
    info.fd_limit_per_thread = files_at_once;
    // Whatever the environment says of proxies: they are for other machines.
    info.http_proxy_address = "";
    context_.reset(::lws_create_context(&info));
    if (!context_) {
      talk_.state = Conversation::State::Over;
      return;
    }
    lws_client_connect_info wanted{};
    wanted.context = context_.get();
    wanted.address = this_machine;
    wanted.host = this_machine;
    wanted.port = port;
    wanted.path = path.c_str();
    wanted.method = method;
    wanted.local_protocol_name = "";
    // It might lead to another machine.
    wanted.ssl_connection = LCCSCF_HTTP_NO_FOLLOW_REDIRECT;
    wanted.opaque_user_data = &talk_;
    wanted.pwsi = &connection_;
    if (::lws_client_connect_via_info(&wanted) == nullptr) talk_.state = Conversation::State::Over;
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  Conversation& talk() noexcept { return talk_; }
  bool is_over() const noexcept { return talk_.state == Conversation::State::Over; }
  void ask_to_write() noexcept { ::lws_callback_on_writable(connection_); }

  /// Lets the library work until `is_done`, the end of the connection, or so long; false: not done.
  template <typename IsDone>
  bool work_until(IsDone&& is_done, std::chrono::milliseconds longest) noexcept {
    alarm_.rang = false;
    alarm_.context = context_.get();
    ::lws_sul_schedule(context_.get(), 0, &alarm_.timer, ring,
                       std::chrono::microseconds(longest).count());
    while (!is_done() && !is_over() && !alarm_.rang) {
      if (::lws_service(context_.get(), 0) < 0) break;
    }
    ::lws_sul_schedule(context_.get(), 0, &alarm_.timer, nullptr, LWS_SET_TIMER_USEC_CANCEL);
    return is_done();
  }

 private:
  struct Alarm {
    lws_sorted_usec_list_t timer{};
    bool rang = false;
    lws_context* context = nullptr;
  };
  /// The library would wait for the next event after it: it is woken.
  static void ring(lws_sorted_usec_list_t* timer) {
    Alarm* alarm = lws_container_of(timer, Alarm, timer);
    alarm->rang = true;
    ::lws_cancel_service(alarm->context);
  }

  struct Destroy {
    void operator()(lws_context* context) const noexcept { ::lws_context_destroy(context); }
  };

  Alarm alarm_;
  Conversation talk_;
  lws* connection_ = nullptr;
  /// Last: what it tells while it goes is still heard.
  std::unique_ptr<lws_context, Destroy> context_;
};

class OpenServiceChannel final : public ServiceChannel {
 public:
  explicit OpenServiceChannel(std::uint16_t port) : connection_(port, "/", nullptr) {}

  bool opens() {
    return connection_.work_until(
        [this] { return connection_.talk().state == Conversation::State::Open; }, opened_within);
  }

  /// One message each millisecond at most: a service answers as fast as it is asked.
  BusAnswer say(std::string_view text) noexcept override {
    wait_for_turn();
    if (connection_.is_over()) return BusAnswer::Gone;
    forget_what_was_heard();
    std::vector<unsigned char>& to_say = connection_.talk().to_say;
    to_say.resize(LWS_PRE + text.size());
    std::memcpy(to_say.data() + LWS_PRE, text.data(), text.size());
    connection_.ask_to_write();
    const bool is_said = connection_.work_until([&] { return to_say.empty(); }, said_within);
    if (connection_.is_over()) return BusAnswer::Gone;
    return is_said ? BusAnswer::Done : BusAnswer::Nothing;
  }

  HeardMessage hear(std::chrono::milliseconds wait) noexcept override {
    Conversation& talk = connection_.talk();
    forget_what_was_heard();
    was_heard_ = connection_.work_until([&] { return talk.is_whole; }, wait);
    if (was_heard_) {
      return talk.is_too_long ? HeardMessage{BusAnswer::Refused, {}}
                              : HeardMessage{BusAnswer::Done, talk.heard};
    }
    return {connection_.is_over() ? BusAnswer::Gone : BusAnswer::Nothing, {}};
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// What comes from now on is another message, also while one is said.
  void forget_what_was_heard() noexcept {
    if (was_heard_) connection_.talk().forget();
    was_heard_ = false;
  }

  void wait_for_turn() noexcept {
    const auto now = Clock::now();
    if (turn_ > now) std::this_thread::sleep_until(turn_);
    turn_ = std::max(turn_, now) + turn_every;
  }

  Connection connection_;
  /// When the next message may go out.
  Clock::time_point turn_;
  /// The message at hand was told: the next one begins anew.
  bool was_heard_ = false;
};

}  // namespace

OpenedService open_service(std::uint16_t port) {
  auto channel = std::make_unique<OpenServiceChannel>(port);
  if (channel->opens()) return {std::move(channel), {}};
  return {nullptr, {DeviceTrouble::NoService, std::to_string(port), {}}};
}

std::optional<std::string> service_page(std::uint16_t port, const std::string& path) {
  Connection connection(port, path, "GET");
  Conversation& talk = connection.talk();
  constexpr int found = 200;
  connection.work_until([&] { return talk.is_whole; }, answered_within);
  if (!talk.is_whole || talk.is_too_long || talk.status != found) return std::nullopt;
  return std::move(talk.heard);
}

std::string service_library_version() { return ::lws_get_library_version(); }

}  // namespace hallux::simulator
