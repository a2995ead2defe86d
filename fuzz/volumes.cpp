// The readers of volumes: any bytes give a valid stack, or a clean error, of any label or
// iso-value, across any axis, both ways; and a summary that agrees with what can be read.
#include <string>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "fuzz/target.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::fuzz;

void try_stack(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  const auto read = parse_stack(bytes, name, options);
  if (fine(read)) require(validate(read->stack).ok(), "a stack that is not valid");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  constexpr const char* kFormats[] = {"nifti", "nrrd", "metaimage", ""};
  constexpr const char* kNames[] = {"fuzz.nii", "fuzz.nrrd", "fuzz.mha", "fuzz.bin"};
  const std::string name = kNames[data[0] % 4];
  ReadOptions options;
  options.format = kFormats[data[0] % 4];
  options.contours = data[1] % 2 == 0 ? VolumeContours::sub_pixel : VolumeContours::lattice;
  if (data[1] / 2 % 4 < 3) options.axis = data[1] / 2 % 4;
  const std::string_view bytes = text_of(data + 2, size - 2);
  try_stack(bytes, name, options);
  ReadOptions at_value = options;
  at_value.iso = data[1] / 8;
  try_stack(bytes, name, at_value);
  const auto summary = inspect_bytes(bytes, name, options);
  if (!fine(summary) || !summary->volume) return 0;
  std::size_t tried = 0;
  for (const std::string& structure : summary->volume->structures) {
    if (++tried > 4) break;
    options.structure = structure;
    const auto read = parse_stack(bytes, name, options);
    if (fine(read)) continue;
    // What is listed can be read, but where its coordinates are none.
    require(read.error().code == ErrorCode::invalid_input &&
                read.error().message.find("double precision") != std::string::npos,
            "a structure that is listed cannot be read");
  }
  return 0;
}
