#include "unit/io/zip_reader.hpp"

#include "unit/render/inflate.hpp"

namespace tetloft::test {

namespace {

struct WrongZip {};

void require(bool condition) {
  if (!condition) throw WrongZip{};
}

// Little-endian numbers, one after the other.
class Fields {
 public:
  Fields(const std::string& bytes, std::size_t at) : bytes_(bytes), at_(at) {}
  std::size_t take(std::size_t size) {
    require(at_ + size <= bytes_.size());
    std::size_t value = 0;
    for (std::size_t k = size; k-- > 0;) {
      value = value << 8 | static_cast<unsigned char>(bytes_[at_ + k]);
    }
    at_ += size;
    return value;
  }
  std::string text(std::size_t size) {
    require(at_ + size <= bytes_.size());
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }
  void expect(std::size_t size, std::size_t value) { require(take(size) == value); }
  [[nodiscard]] std::size_t at() const { return at_; }

 private:
  const std::string& bytes_;
  std::size_t at_;
};

// What both headers of a file have.
struct Header {
  std::size_t method = 0, crc = 0, packed = 0, size = 0, name = 0;
  friend bool operator==(const Header&, const Header&) = default;
};

Header take_header(Fields& fields) {
  fields.expect(2, 20);
  fields.expect(2, 0);
  Header header;
  header.method = fields.take(2);
  fields.expect(2, 0);     // midnight
  fields.expect(2, 0x21);  // of the first day there is
  header.crc = fields.take(4);
  header.packed = fields.take(4);
  header.size = fields.take(4);
  header.name = fields.take(2);
  fields.expect(2, 0);
  return header;
}

// Appends the file to the archive; returns where the next begins.
std::size_t take_file(const std::string& archive, std::size_t at, Fields& directory,
                      ZipArchive& read) {
  directory.expect(4, 0x02014b50);
  directory.expect(2, 20);
  const Header header = take_header(directory);
  for (const std::size_t size : {2U, 2U, 2U, 4U}) directory.expect(size, 0);
  directory.expect(4, at);
  const std::string name = directory.text(header.name);

  Fields local(archive, at);
  local.expect(4, 0x04034b50);
  require(take_header(local) == header);
  require(local.text(header.name) == name);
  const std::string packed = local.text(header.packed);
  require(header.method == 0 || header.method == 8);
  const auto bytes = header.method == 8 ? inflate_bare(packed) : std::optional(packed);
  require(bytes && bytes->size() == header.size && slow_crc32(*bytes) == header.crc);
  read.names.push_back(name);
  require(read.files.insert({name, {*bytes, header.method == 8}}).second);
  return local.at();
}

ZipArchive archive_of(const std::string& archive) {
  require(archive.size() >= 22);
  Fields end(archive, archive.size() - 22);
  end.expect(4, 0x06054b50);
  end.expect(4, 0);
  const std::size_t count = end.take(2);
  end.expect(2, count);
  const std::size_t directory_size = end.take(4);
  const std::size_t directory_at = end.take(4);
  end.expect(2, 0);
  Fields directory(archive, directory_at);
  ZipArchive read;
  std::size_t at = 0;
  for (std::size_t k = 0; k < count; ++k) at = take_file(archive, at, directory, read);
  require(at == directory_at && directory.at() == directory_at + directory_size &&
          directory.at() + 22 == archive.size());
  return read;
}

}  // namespace

std::uint32_t slow_crc32(const std::string& bytes) {
  std::uint32_t rest = 0xFFFFFFFF;
  for (const char c : bytes) {
    rest ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ ((rest & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~rest;
}

std::optional<ZipArchive> read_zip(const std::string& archive) {
  try {
    return archive_of(archive);
  } catch (const WrongZip&) {
    return std::nullopt;
  }
}

}  // namespace tetloft::test
