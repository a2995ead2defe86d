// Firefox's Marionette protocol: "length:[type, id, name, parameters]" over a local socket.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <sstream>
#include <thread>

#include "browser/browser.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::test {

namespace {

class Firefox : public Browser {
 public:
  explicit Firefox(const std::string& program) {
    // Port 0: Firefox takes a free one and leaves its number in the profile.
    put(folder_.file("user.js"),
        "user_pref('marionette.port', 0);\nuser_pref('webgl.force-enabled', true);\n"
        "user_pref('devtools.console.stdout.content', true);\n"
        "user_pref('browser.shell.checkDefaultBrowser', false);\n"
        "user_pref('datareporting.policy.dataSubmissionEnabled', false);\n"
        "user_pref('app.update.enabled', false);\n");
    const std::string folder = std::filesystem::path(folder_.file("user.js")).parent_path();
    std::vector<std::string> words{
        program, "--marionette", "--no-remote", "--window-size=500,360", "--profile", folder};
    // Without a display Firefox has no WebGL.
    if (const auto display = find_program({"xvfb-run"})) {
      words.insert(words.begin(), {*display, "-a"});
    } else {
      words.push_back("--headless");
    }
    child_ = std::make_unique<Child>(words, folder_.file("log"));
    if (!connect_to(wait_for_port())) return;
    if (!next()) return;  // the greeting
    ready_ = command("WebDriver:NewSession").has("sessionId");
  }
  ~Firefox() override { close(socket_); }

  [[nodiscard]] bool ready() const { return ready_; }

  void open(const std::string& url) override {
    command("WebDriver:Navigate", R"({"url":)" + json_quoted(url) + '}');
  }
  JsonValue evaluate(const std::string& expression) override {
    return command("WebDriver:ExecuteScript",
                   R"({"args":[],"script":)" + json_quoted("return " + expression) + '}')
        .at("value");
  }
  void resize(int width, int height) override {
    command("WebDriver:SetWindowRect", R"({"width":)" + std::to_string(width) + R"(,"height":)" +
                                           std::to_string(height) + '}');
  }
  std::vector<std::string> errors() override {
    std::vector<std::string> found;
    std::istringstream log(get(folder_.file("log")));
    for (std::string line; std::getline(log, line);) {
      if (line.find("file://") == std::string::npos) continue;  // the browser's own
      if (line.find("JavaScript error") != std::string::npos ||
          line.find("console.error") != std::string::npos) {
        found.push_back(line);
      }
    }
    return found;
  }
  std::string screenshot() override {
    return command("WebDriver:TakeScreenshot", R"({"full":false})").at("value").string;
  }

 private:
  int wait_for_port() {
    for (int waited = 0; waited < kPatience; waited += 100) {
      const std::string text = get(folder_.file("MarionetteActivePort"));
      if (!text.empty()) return std::stoi(text);
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return -1;
  }

  bool connect_to(int port) {
    if (port <= 0) return false;
    socket_ = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }

  JsonValue command(const std::string& name, const std::string& parameters = "{}") {
    const int number = ++last_;
    const std::string body =
        "[0," + std::to_string(number) + ',' + json_quoted(name) + ',' + parameters + ']';
    const std::string message = std::to_string(body.size()) + ':' + body;
    if (send(socket_, message.data(), message.size(), MSG_NOSIGNAL) !=
        static_cast<ssize_t>(message.size())) {
      return {};
    }
    const auto answer = next();
    if (!answer || answer->array.size() != 4) return {};
    return answer->array[3];
  }

  std::optional<JsonValue> next() {
    for (;;) {
      const std::size_t colon = buffer_.find(':');
      if (colon != std::string::npos) {
        const std::size_t length = std::stoul(buffer_.substr(0, colon));
        if (buffer_.size() >= colon + 1 + length) {
          const auto message = parse_json(buffer_.substr(colon + 1, length));
          buffer_.erase(0, colon + 1 + length);
          return message;
        }
      }
      pollfd waiting{socket_, POLLIN, 0};
      if (poll(&waiting, 1, kPatience) <= 0) return std::nullopt;
      char bytes[65536];
      const ssize_t n = recv(socket_, bytes, sizeof bytes, 0);
      if (n <= 0) return std::nullopt;
      buffer_.append(bytes, static_cast<std::size_t>(n));
    }
  }

  TempFolder folder_;
  std::unique_ptr<Child> child_;
  int socket_ = -1;
  bool ready_ = false;
  std::string buffer_;
  int last_ = 0;
};

}  // namespace

std::unique_ptr<Browser> start_firefox() {
  const auto program = find_program({"firefox", "firefox-esr"});
  if (!program) return nullptr;
  auto browser = std::make_unique<Firefox>(*program);
  if (!browser->ready()) return nullptr;
  return browser;
}

}  // namespace tetloft::test
