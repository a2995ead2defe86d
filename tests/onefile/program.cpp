// What a program does that takes the library in as two files: models and pictures of stacks, by
// tetloft.hpp alone. It is compiled without exceptions and run-time types, too.
//
//   program FOLDER STACK…      writes FOLDER/NAME.vtu, .html and .png for each STACK, …/NAME.cnt
#include <cstdio>
#include <string>

#include "tetloft.hpp"

namespace {

std::string name_of_stack(const std::string& path) {
  const std::size_t begin = path.rfind('/') + 1;  // 0 without a folder
  return path.substr(begin, path.rfind('.') - begin);
}

int report(const tetloft::Error& error) {
  std::fprintf(stderr, "%s\n", to_string(error).c_str());
  return static_cast<int>(error.code);
}

// A stop goes through the library as an exception, and comes out of it as an error.
int stopped(const tetloft::SectionStack& stack) {
  std::stop_source stop;
  tetloft::ReconstructOptions options;
  options.execution.stop = stop.get_token();
  options.execution.progress = [&](std::size_t, std::size_t) { stop.request_stop(); };
  const auto solid = tetloft::reconstruct(stack, options);
  if (!solid && solid.error().code == tetloft::ErrorCode::cancelled) return 0;
  std::fprintf(stderr, "not stopped\n");
  return 1;
}

int reconstruct_file(const std::string& folder, const std::string& path) {
  const auto input = tetloft::read_cnt(path);
  if (!input) return report(input.error());
  if (const int status = stopped(input->stack); status != 0) return status;
  const auto solid = tetloft::reconstruct(input->stack);
  if (!solid) return report(solid.error());

  const std::string name = name_of_stack(path);
  const std::string output = folder + '/' + name;
  const auto written = tetloft::write_vtu(output + ".vtu", solid->model);
  if (!written) return report(written.error());
  tetloft::RenderOptions options;
  options.title = name;
  const auto page = tetloft::render_html(solid->model, nullptr, options);
  if (!page) return report(page.error());
  const auto picture = tetloft::render_png(solid->model, nullptr, options);
  if (!picture) return report(picture.error());
  for (const auto& [end, bytes] : {std::pair{".html", &*page}, std::pair{".png", &*picture}}) {
    const auto done = tetloft::write_file(output + end, *bytes);
    if (!done) return report(done.error());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  for (int i = 2; i < argc; ++i) {
    if (const int status = reconstruct_file(argv[1], argv[i]); status != 0) return status;
  }
  return 0;
}
