// Which file a stack was read from.
#include "pieces/plan_source.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "core/guard.hpp"
#include "io/bytes/checksum.hpp"

namespace tetloft {

using namespace internal;

namespace internal::pieces {

namespace {

// 4 MiB in all, however large the file. A change that leaves its length is seen if it is in a
// sample, or shifts what is.
constexpr std::uint64_t kSamples = 64;
constexpr std::uint64_t kSampleBytes = std::uint64_t{1} << 16;

Error unreadable_source(const std::string& path) {
  Error error{ErrorCode::io, "the file cannot be read", {}};
  error.where.file = path;
  return error;
}

}  // namespace

Result<std::uint64_t> sampled_checksum(const std::string& path, std::uint64_t bytes) {
  return guard_internal([&]() -> Result<std::uint64_t> {
    std::ifstream file(path, std::ios::binary);
    io::TwofoldChecksum checksum;
    std::string sample(static_cast<std::size_t>(std::min(kSampleBytes, bytes)), '\0');
    const std::uint64_t apart = (bytes - sample.size()) / (kSamples - 1);
    for (std::uint64_t k = 0; k < kSamples; ++k) {
      const std::uint64_t at = k + 1 < kSamples ? k * apart : bytes - sample.size();
      file.seekg(static_cast<std::streamoff>(at));
      file.read(sample.data(), static_cast<std::streamsize>(sample.size()));
      if (!file) return unreadable_source(path);
      checksum.add(sample);
    }
    return checksum.value();
  });
}

}  // namespace internal::pieces

Result<PlanSource> plan_source(const std::string& path) {
  return guard_internal([&]() -> Result<PlanSource> {
    std::ifstream file(path, std::ios::binary);
    PlanSource source;
    source.name = std::filesystem::path(path).filename().string();
    io::TwofoldChecksum checksum;
    std::string buffer(std::size_t{1} << 20, '\0');
    while (file) {
      file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
      const auto count = static_cast<std::size_t>(file.gcount());
      checksum.add(std::string_view(buffer).substr(0, count));
      source.bytes += count;
    }
    if (!file.eof()) return pieces::unreadable_source(path);
    source.checksum = checksum.value();
    const Result<std::uint64_t> sampled = pieces::sampled_checksum(path, source.bytes);
    if (!sampled) return sampled.error();
    source.sampled = *sampled;
    return source;
  });
}

}  // namespace tetloft
