// Chromium's debugging protocol over a pipe: JSON messages that end with a zero byte.
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>

#include "browser/browser.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::test {

namespace {

class Chromium : public Browser {
 public:
  explicit Chromium(const std::string& program) {
    if (pipe(commands_) != 0 || pipe(answers_) != 0) return;
    child_ = std::make_unique<Child>(
        std::vector<std::string>{
            program, "--headless=new", "--no-sandbox", "--no-first-run", "--disable-dev-shm-usage",
            "--remote-debugging-pipe", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
            "--window-size=500,360", "--user-data-dir=" + folder_.file("user"), "about:blank"},
        folder_.file("log"), std::vector<std::pair<int, int>>{{commands_[0], 3}, {answers_[1], 4}});
    close(commands_[0]);
    close(answers_[1]);
    const JsonValue target = command("Target.createTarget", R"({"url":"about:blank"})");
    const std::string id = target.at("targetId").string;
    if (id.empty()) return;
    session_ = command("Target.attachToTarget",
                       R"({"targetId":)" + json_quoted(id) + R"(,"flatten":true})")
                   .at("sessionId")
                   .string;
    command("Page.enable");
    command("Runtime.enable");
    command("Log.enable");
  }
  ~Chromium() override {
    close(commands_[1]);
    close(answers_[0]);
  }

  [[nodiscard]] bool ready() const { return !session_.empty(); }

  void open(const std::string& url) override {
    command("Page.navigate", R"({"url":)" + json_quoted(url) + '}');
  }
  JsonValue evaluate(const std::string& expression) override {
    return command("Runtime.evaluate",
                   R"({"returnByValue":true,"awaitPromise":true,"expression":)" +
                       json_quoted(expression) + '}')
        .at("result")
        .at("value");
  }
  void resize(int width, int height) override {
    command("Emulation.setDeviceMetricsOverride", R"({"width":)" + std::to_string(width) +
                                                      R"(,"height":)" + std::to_string(height) +
                                                      R"(,"deviceScaleFactor":1,"mobile":false})");
  }
  std::vector<std::string> errors() override { return errors_; }
  std::string screenshot() override { return command("Page.captureScreenshot").at("data").string; }

 private:
  JsonValue command(const std::string& method, const std::string& parameters = "{}") {
    const int number = ++last_;
    std::string message = "{\"id\":" + std::to_string(number) +
                          ",\"method\":" + json_quoted(method) + ",\"params\":" + parameters;
    if (!session_.empty()) message += ",\"sessionId\":" + json_quoted(session_);
    message += '}';
    message += '\0';
    if (write(commands_[1], message.data(), message.size()) !=
        static_cast<ssize_t>(message.size())) {
      return {};
    }
    for (;;) {
      const auto answer = next();
      if (!answer) return {};
      if (answer->at("id").number == number) return answer->at("result");
      note(*answer);
    }
  }

  void note(const JsonValue& event) {
    const std::string& method = event.at("method").string;
    const JsonValue& what = event.at("params");
    if (method == "Runtime.exceptionThrown") {
      errors_.push_back(what.at("exceptionDetails").at("exception").at("description").string);
    } else if (method == "Runtime.consoleAPICalled" && what.at("type").string == "error") {
      errors_.push_back("console.error");
    } else if (method == "Log.entryAdded" && what.at("entry").at("level").string == "error") {
      errors_.push_back(what.at("entry").at("text").string);
    }
  }

  // The next message; empty where there is none in time.
  std::optional<JsonValue> next() {
    for (;;) {
      const std::size_t end = buffer_.find('\0');
      if (end != std::string::npos) {
        const auto message = parse_json(buffer_.substr(0, end));
        buffer_.erase(0, end + 1);
        if (message) return message;
        continue;
      }
      pollfd waiting{answers_[0], POLLIN, 0};
      if (poll(&waiting, 1, kPatience) <= 0) return std::nullopt;
      char bytes[65536];
      const ssize_t n = read(answers_[0], bytes, sizeof bytes);
      if (n <= 0) return std::nullopt;
      buffer_.append(bytes, static_cast<std::size_t>(n));
    }
  }

  TempFolder folder_;
  int commands_[2] = {-1, -1};
  int answers_[2] = {-1, -1};
  std::unique_ptr<Child> child_;
  std::string session_;
  std::string buffer_;
  std::vector<std::string> errors_;
  int last_ = 0;
};

}  // namespace

std::unique_ptr<Browser> start_chromium() {
  const auto program = find_program({"chromium", "chromium-browser", "google-chrome"});
  if (!program) return nullptr;
  auto browser = std::make_unique<Chromium>(*program);
  if (!browser->ready()) return nullptr;
  return browser;
}

}  // namespace tetloft::test
