// DEFLATE: any bytes in any wrapping give data or a clean error; the same in pieces of any size, in
// no more memory than is asked for.
#include <string>

#include "fuzz/target.hpp"
#include "io/bytes/inflate.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft;
  using namespace tetloft::fuzz;
  using namespace tetloft::internal::io;
  if (size < 2) return 0;
  const auto wrapping = static_cast<Wrapping>(data[0] % 3);
  const std::string_view bytes = text_of(data + 2, size - 2);
  const std::string name = "fuzz.gz";
  constexpr std::size_t kMost = std::size_t{1} << 20;
  const Result<std::string> whole = inflate(bytes, wrapping, kMost, name);
  if (!whole) {
    require_clean(whole.error());
    require(whole.error().where.file == name, "an error without the file's name");
  }
  const MemoryBytes source(bytes);
  Inflater inflater(source, 0, wrapping, name);
  std::string piece(std::size_t{1} + 97 * data[1], '\0');
  std::string all;
  while (all.size() <= kMost) {
    const Result<std::size_t> got = inflater.read(piece);
    require(inflater.position() <= bytes.size(), "a position behind the end");
    if (!got) {
      require(!whole, "data that are right as a whole are wrong in pieces");
      return 0;
    }
    all.append(piece, 0, *got);
    if (*got < piece.size()) break;
  }
  require(whole ? all == *whole : all.size() > kMost, "pieces differ from the whole");
  return 0;
}
