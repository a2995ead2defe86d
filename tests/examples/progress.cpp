// A progress bar and a stop button: progress FILE OUT.vtu [MILLISECONDS until it is stopped].
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <stop_token>
#include <thread>

#include <tetloft/tetloft.hpp>

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const auto input = tetloft::read_stack(argv[1]);
  if (!input) {
    std::fprintf(stderr, "%s\n", to_string(input.error()).c_str());
    return 3;
  }

  // The button: any thread may press it. Here a clock does.
  std::stop_source button;
  std::jthread clock;
  if (argc > 3) {
    clock = std::jthread([&button, ms = std::atol(argv[3])](const std::stop_token& done) {
      std::mutex mutex;
      std::unique_lock lock(mutex);
      std::condition_variable_any wake;
      wake.wait_for(lock, done, std::chrono::milliseconds(ms), [] { return false; });
      if (!done.stop_requested()) button.request_stop();
    });
  }

  tetloft::ReconstructOptions options;
  options.execution.stop = button.get_token();
  options.execution.progress = [](std::size_t done, std::size_t all) {
    std::fprintf(stderr, "\r%3zu %%", 100 * done / all);
  };
  const auto solid = tetloft::reconstruct(input->stack, options);
  std::fputc('\n', stderr);
  if (!solid) {
    const bool stopped = solid.error().code == tetloft::ErrorCode::cancelled;
    std::printf("%s\n", stopped ? "stopped" : to_string(solid.error()).c_str());
    return static_cast<int>(solid.error().code);
  }
  const auto written = tetloft::write_vtu(argv[2], solid->model);
  if (!written) std::fprintf(stderr, "%s\n", to_string(written.error()).c_str());
  return written ? 0 : 4;
}
