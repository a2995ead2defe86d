// Character sets of DICOM, on their way to UTF-8.
#include "io/drawing/dicom_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

#include "core/text.hpp"
#include "io/drawing/triples.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// What the bytes from 0xA0 on stand for; U+FFFD where they stand for nothing. Empty: themselves.
using HighHalf = std::u16string_view;
constexpr char16_t kNothing = 0xFFFD;

constexpr HighHalf kLatin1;
constexpr HighHalf kLatin2 =
    u"\u00A0\u0104\u02D8\u0141\u00A4\u013D\u015A\u00A7\u00A8\u0160\u015E\u0164\u0179\u00AD"
    u"\u017D\u017B\u00B0\u0105\u02DB\u0142\u00B4\u013E\u015B\u02C7\u00B8\u0161\u015F\u0165"
    u"\u017A\u02DD\u017E\u017C\u0154\u00C1\u00C2\u0102\u00C4\u0139\u0106\u00C7\u010C\u00C9"
    u"\u0118\u00CB\u011A\u00CD\u00CE\u010E\u0110\u0143\u0147\u00D3\u00D4\u0150\u00D6\u00D7"
    u"\u0158\u016E\u00DA\u0170\u00DC\u00DD\u0162\u00DF\u0155\u00E1\u00E2\u0103\u00E4\u013A"
    u"\u0107\u00E7\u010D\u00E9\u0119\u00EB\u011B\u00ED\u00EE\u010F\u0111\u0144\u0148\u00F3"
    u"\u00F4\u0151\u00F6\u00F7\u0159\u016F\u00FA\u0171\u00FC\u00FD\u0163\u02D9";
constexpr HighHalf kLatin3 =
    u"\u00A0\u0126\u02D8\u00A3\u00A4\uFFFD\u0124\u00A7\u00A8\u0130\u015E\u011E\u0134\u00AD"
    u"\uFFFD\u017B\u00B0\u0127\u00B2\u00B3\u00B4\u00B5\u0125\u00B7\u00B8\u0131\u015F\u011F"
    u"\u0135\u00BD\uFFFD\u017C\u00C0\u00C1\u00C2\uFFFD\u00C4\u010A\u0108\u00C7\u00C8\u00C9"
    u"\u00CA\u00CB\u00CC\u00CD\u00CE\u00CF\uFFFD\u00D1\u00D2\u00D3\u00D4\u0120\u00D6\u00D7"
    u"\u011C\u00D9\u00DA\u00DB\u00DC\u016C\u015C\u00DF\u00E0\u00E1\u00E2\uFFFD\u00E4\u010B"
    u"\u0109\u00E7\u00E8\u00E9\u00EA\u00EB\u00EC\u00ED\u00EE\u00EF\uFFFD\u00F1\u00F2\u00F3"
    u"\u00F4\u0121\u00F6\u00F7\u011D\u00F9\u00FA\u00FB\u00FC\u016D\u015D\u02D9";
constexpr HighHalf kLatin4 =
    u"\u00A0\u0104\u0138\u0156\u00A4\u0128\u013B\u00A7\u00A8\u0160\u0112\u0122\u0166\u00AD"
    u"\u017D\u00AF\u00B0\u0105\u02DB\u0157\u00B4\u0129\u013C\u02C7\u00B8\u0161\u0113\u0123"
    u"\u0167\u014A\u017E\u014B\u0100\u00C1\u00C2\u00C3\u00C4\u00C5\u00C6\u012E\u010C\u00C9"
    u"\u0118\u00CB\u0116\u00CD\u00CE\u012A\u0110\u0145\u014C\u0136\u00D4\u00D5\u00D6\u00D7"
    u"\u00D8\u0172\u00DA\u00DB\u00DC\u0168\u016A\u00DF\u0101\u00E1\u00E2\u00E3\u00E4\u00E5"
    u"\u00E6\u012F\u010D\u00E9\u0119\u00EB\u0117\u00ED\u00EE\u012B\u0111\u0146\u014D\u0137"
    u"\u00F4\u00F5\u00F6\u00F7\u00F8\u0173\u00FA\u00FB\u00FC\u0169\u016B\u02D9";
constexpr HighHalf kCyrillic =
    u"\u00A0\u0401\u0402\u0403\u0404\u0405\u0406\u0407\u0408\u0409\u040A\u040B\u040C\u00AD"
    u"\u040E\u040F\u0410\u0411\u0412\u0413\u0414\u0415\u0416\u0417\u0418\u0419\u041A\u041B"
    u"\u041C\u041D\u041E\u041F\u0420\u0421\u0422\u0423\u0424\u0425\u0426\u0427\u0428\u0429"
    u"\u042A\u042B\u042C\u042D\u042E\u042F\u0430\u0431\u0432\u0433\u0434\u0435\u0436\u0437"
    u"\u0438\u0439\u043A\u043B\u043C\u043D\u043E\u043F\u0440\u0441\u0442\u0443\u0444\u0445"
    u"\u0446\u0447\u0448\u0449\u044A\u044B\u044C\u044D\u044E\u044F\u2116\u0451\u0452\u0453"
    u"\u0454\u0455\u0456\u0457\u0458\u0459\u045A\u045B\u045C\u00A7\u045E\u045F";
constexpr HighHalf kArabic =
    u"\u00A0\uFFFD\uFFFD\uFFFD\u00A4\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\u060C\u00AD"
    u"\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\u061B"
    u"\uFFFD\uFFFD\uFFFD\u061F\uFFFD\u0621\u0622\u0623\u0624\u0625\u0626\u0627\u0628\u0629"
    u"\u062A\u062B\u062C\u062D\u062E\u062F\u0630\u0631\u0632\u0633\u0634\u0635\u0636\u0637"
    u"\u0638\u0639\u063A\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\u0640\u0641\u0642\u0643\u0644\u0645"
    u"\u0646\u0647\u0648\u0649\u064A\u064B\u064C\u064D\u064E\u064F\u0650\u0651\u0652\uFFFD"
    u"\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD";
constexpr HighHalf kGreek =
    u"\u00A0\u2018\u2019\u00A3\u20AC\u20AF\u00A6\u00A7\u00A8\u00A9\u037A\u00AB\u00AC\u00AD"
    u"\uFFFD\u2015\u00B0\u00B1\u00B2\u00B3\u0384\u0385\u0386\u00B7\u0388\u0389\u038A\u00BB"
    u"\u038C\u00BD\u038E\u038F\u0390\u0391\u0392\u0393\u0394\u0395\u0396\u0397\u0398\u0399"
    u"\u039A\u039B\u039C\u039D\u039E\u039F\u03A0\u03A1\uFFFD\u03A3\u03A4\u03A5\u03A6\u03A7"
    u"\u03A8\u03A9\u03AA\u03AB\u03AC\u03AD\u03AE\u03AF\u03B0\u03B1\u03B2\u03B3\u03B4\u03B5"
    u"\u03B6\u03B7\u03B8\u03B9\u03BA\u03BB\u03BC\u03BD\u03BE\u03BF\u03C0\u03C1\u03C2\u03C3"
    u"\u03C4\u03C5\u03C6\u03C7\u03C8\u03C9\u03CA\u03CB\u03CC\u03CD\u03CE\uFFFD";
constexpr HighHalf kHebrew =
    u"\u00A0\uFFFD\u00A2\u00A3\u00A4\u00A5\u00A6\u00A7\u00A8\u00A9\u00D7\u00AB\u00AC\u00AD"
    u"\u00AE\u00AF\u00B0\u00B1\u00B2\u00B3\u00B4\u00B5\u00B6\u00B7\u00B8\u00B9\u00F7\u00BB"
    u"\u00BC\u00BD\u00BE\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD"
    u"\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD"
    u"\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\u2017\u05D0\u05D1\u05D2\u05D3\u05D4\u05D5"
    u"\u05D6\u05D7\u05D8\u05D9\u05DA\u05DB\u05DC\u05DD\u05DE\u05DF\u05E0\u05E1\u05E2\u05E3"
    u"\u05E4\u05E5\u05E6\u05E7\u05E8\u05E9\u05EA\uFFFD\uFFFD\u200E\u200F\uFFFD";
constexpr HighHalf kLatin5 =
    u"\u00A0\u00A1\u00A2\u00A3\u00A4\u00A5\u00A6\u00A7\u00A8\u00A9\u00AA\u00AB\u00AC\u00AD"
    u"\u00AE\u00AF\u00B0\u00B1\u00B2\u00B3\u00B4\u00B5\u00B6\u00B7\u00B8\u00B9\u00BA\u00BB"
    u"\u00BC\u00BD\u00BE\u00BF\u00C0\u00C1\u00C2\u00C3\u00C4\u00C5\u00C6\u00C7\u00C8\u00C9"
    u"\u00CA\u00CB\u00CC\u00CD\u00CE\u00CF\u011E\u00D1\u00D2\u00D3\u00D4\u00D5\u00D6\u00D7"
    u"\u00D8\u00D9\u00DA\u00DB\u00DC\u0130\u015E\u00DF\u00E0\u00E1\u00E2\u00E3\u00E4\u00E5"
    u"\u00E6\u00E7\u00E8\u00E9\u00EA\u00EB\u00EC\u00ED\u00EE\u00EF\u011F\u00F1\u00F2\u00F3"
    u"\u00F4\u00F5\u00F6\u00F7\u00F8\u00F9\u00FA\u00FB\u00FC\u0131\u015F\u00FF";
constexpr HighHalf kLatin9 =
    u"\u00A0\u00A1\u00A2\u00A3\u20AC\u00A5\u0160\u00A7\u0161\u00A9\u00AA\u00AB\u00AC\u00AD"
    u"\u00AE\u00AF\u00B0\u00B1\u00B2\u00B3\u017D\u00B5\u00B6\u00B7\u017E\u00B9\u00BA\u00BB"
    u"\u0152\u0153\u0178\u00BF\u00C0\u00C1\u00C2\u00C3\u00C4\u00C5\u00C6\u00C7\u00C8\u00C9"
    u"\u00CA\u00CB\u00CC\u00CD\u00CE\u00CF\u00D0\u00D1\u00D2\u00D3\u00D4\u00D5\u00D6\u00D7"
    u"\u00D8\u00D9\u00DA\u00DB\u00DC\u00DD\u00DE\u00DF\u00E0\u00E1\u00E2\u00E3\u00E4\u00E5"
    u"\u00E6\u00E7\u00E8\u00E9\u00EA\u00EB\u00EC\u00ED\u00EE\u00EF\u00F0\u00F1\u00F2\u00F3"
    u"\u00F4\u00F5\u00F6\u00F7\u00F8\u00F9\u00FA\u00FB\u00FC\u00FD\u00FE\u00FF";
constexpr HighHalf kThai =
    u"\u00A0\u0E01\u0E02\u0E03\u0E04\u0E05\u0E06\u0E07\u0E08\u0E09\u0E0A\u0E0B\u0E0C\u0E0D"
    u"\u0E0E\u0E0F\u0E10\u0E11\u0E12\u0E13\u0E14\u0E15\u0E16\u0E17\u0E18\u0E19\u0E1A\u0E1B"
    u"\u0E1C\u0E1D\u0E1E\u0E1F\u0E20\u0E21\u0E22\u0E23\u0E24\u0E25\u0E26\u0E27\u0E28\u0E29"
    u"\u0E2A\u0E2B\u0E2C\u0E2D\u0E2E\u0E2F\u0E30\u0E31\u0E32\u0E33\u0E34\u0E35\u0E36\u0E37"
    u"\u0E38\u0E39\u0E3A\uFFFD\uFFFD\uFFFD\uFFFD\u0E3F\u0E40\u0E41\u0E42\u0E43\u0E44\u0E45"
    u"\u0E46\u0E47\u0E48\u0E49\u0E4A\u0E4B\u0E4C\u0E4D\u0E4E\u0E4F\u0E50\u0E51\u0E52\u0E53"
    u"\u0E54\u0E55\u0E56\u0E57\u0E58\u0E59\u0E5A\u0E5B\uFFFD\uFFFD\uFFFD\uFFFD";
constexpr HighHalf kKatakana =
    u"\uFFFD\uFF61\uFF62\uFF63\uFF64\uFF65\uFF66\uFF67\uFF68\uFF69\uFF6A\uFF6B\uFF6C\uFF6D"
    u"\uFF6E\uFF6F\uFF70\uFF71\uFF72\uFF73\uFF74\uFF75\uFF76\uFF77\uFF78\uFF79\uFF7A\uFF7B"
    u"\uFF7C\uFF7D\uFF7E\uFF7F\uFF80\uFF81\uFF82\uFF83\uFF84\uFF85\uFF86\uFF87\uFF88\uFF89"
    u"\uFF8A\uFF8B\uFF8C\uFF8D\uFF8E\uFF8F\uFF90\uFF91\uFF92\uFF93\uFF94\uFF95\uFF96\uFF97"
    u"\uFF98\uFF99\uFF9A\uFF9B\uFF9C\uFF9D\uFF9E\uFF9F\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD"
    u"\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD"
    u"\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD";

struct SingleByteSet {
  std::string_view number;  ///< of ISO_IR
  char final_byte;          ///< of the escape sequence by which it takes the high half
  HighHalf high;
};
constexpr std::array<SingleByteSet, 12> kSingleByteSets{{{"100", 'A', kLatin1},
                                                         {"101", 'B', kLatin2},
                                                         {"109", 'C', kLatin3},
                                                         {"110", 'D', kLatin4},
                                                         {"144", 'L', kCyrillic},
                                                         {"127", 'G', kArabic},
                                                         {"126", 'F', kGreek},
                                                         {"138", 'H', kHebrew},
                                                         {"148", 'M', kLatin5},
                                                         {"203", 'b', kLatin9},
                                                         {"166", 'T', kThai},
                                                         {"13", 'I', kKatakana}}};

constexpr char kEscape = '\x1b';

const SingleByteSet* set_of_number(std::string_view number) {
  for (const SingleByteSet& set : kSingleByteSets) {
    if (set.number == number) return &set;
  }
  return nullptr;
}

const SingleByteSet* set_of_final_byte(char final_byte) {
  for (const SingleByteSet& set : kSingleByteSets) {
    if (set.final_byte == final_byte) return &set;
  }
  return nullptr;
}

// Letters and digits, which is what writers agree in.
std::string letters_and_digits(std::string_view name) {
  std::string kept;
  for (const char c : name) {
    if (c >= 'a' && c <= 'z') kept += static_cast<char>(c - 'a' + 'A');
    if ((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')) kept += c;
  }
  return kept;
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

void append_utf8(std::string& text, char16_t code) {
  const unsigned c = code;
  if (c < 0x80) {
    text += static_cast<char>(c);
  } else if (c < 0x800) {
    text += static_cast<char>(0xC0U | c >> 6U);
    text += static_cast<char>(0x80U | (c & 0x3FU));
  } else {
    text += static_cast<char>(0xE0U | c >> 12U);
    text += static_cast<char>(0x80U | (c >> 6U & 0x3FU));
    text += static_cast<char>(0x80U | (c & 0x3FU));
  }
}

// Decodes bytes of which escape sequences may change the meaning (ISO 2022, as PS3.5 restricts it).
class ByteDecoder {
 public:
  // The set of bytes above ASCII at the start, and what it is called; null: none is known.
  ByteDecoder(const SingleByteSet* high, bool pairs) : high_(high), pairs_(pairs) {}

  DicomCharacters::Text decode(std::string_view bytes) {
    for (bytes_ = bytes; !bytes_.empty();) {
      if (bytes_.front() == kEscape) {
        take_escape();
      } else {
        take_byte();
      }
    }
    return {std::move(text_), std::move(odd_)};
  }

 private:
  void escape(std::size_t count) {
    for (; count > 0 && !bytes_.empty(); --count) {
      std::array<char, 8> shown{};
      std::snprintf(shown.data(), shown.size(), "\\x%02x",
                    static_cast<unsigned>(static_cast<unsigned char>(bytes_.front())));
      text_ += shown.data();
      bytes_.remove_prefix(1);
    }
  }

  void take_byte() {
    const auto byte = static_cast<unsigned char>(bytes_.front());
    if (byte < 0x80 && !low_is_foreign_) {
      text_ += bytes_.front();
      bytes_.remove_prefix(1);
      return;
    }
    char16_t code = kNothing;
    if (byte >= 0xA0 && high_ != nullptr) {
      code = high_->high.empty() ? byte : high_->high[byte - 0xA0U];
    }
    if (code == kNothing) {
      odd_ = "bytes that are not understood are shown as \\xNN";
      escape(pairs_ ? 2 : 1);
      return;
    }
    append_utf8(text_, code);
    bytes_.remove_prefix(1);
  }

  void take_escape() {
    const std::string_view sequence = bytes_.substr(0, 3);
    const char kind = sequence.size() == 3 ? sequence[1] : '\0';
    const bool to_ascii = kind == '(' && (sequence[2] == 'B' || sequence[2] == 'J');
    const SingleByteSet* const set =
        kind == '-' || kind == ')' ? set_of_final_byte(sequence[2]) : nullptr;
    if (to_ascii) low_is_foreign_ = false;
    if (set != nullptr) high_ = set;
    if (to_ascii || set != nullptr) {
      bytes_.remove_prefix(3);
      return;
    }
    // Sets of two bytes: "ESC $ B" for the low half, "ESC $ ) C" for the high one.
    odd_ = "bytes that are not understood are shown as \\xNN";
    const bool of_high = kind == '$' && sequence[2] == ')';
    if (of_high) high_ = nullptr;
    if (kind == '$' && !of_high) low_is_foreign_ = true;
    escape(of_high ? 4 : 3);
  }

  const SingleByteSet* high_;
  bool pairs_;                   // a byte above ASCII takes the next with it
  bool low_is_foreign_ = false;  // also bytes below 0x80 are of a set of several bytes
  std::string_view bytes_;
  std::string text_;
  std::string odd_;
};

}  // namespace

DicomCharacters::DicomCharacters(std::string_view value) : value_(without_padding(value)) {
  first_ = letters_and_digits(value_.substr(0, value_.find('\\')));
}

DicomCharacters::Text DicomCharacters::decode(std::string_view value) const {
  const std::string_view bytes = without_padding(value);
  if (is_ascii(bytes) && bytes.find(kEscape) == std::string_view::npos) {
    return {std::string(bytes), {}};
  }
  const bool told_utf8 = first_ == "ISOIR192" || first_ == "UTF8";
  const bool told_none = first_.empty() || first_ == "ISOIR6" || first_ == "ISO2022IR6";
  if ((told_utf8 || (told_none && !is_ascii(bytes))) && is_utf8(bytes)) {
    return {std::string(bytes),
            told_utf8 ? "" : "taken for UTF-8, though the file does not say so"};
  }
  std::string_view number = first_;
  for (const std::string_view prefix : {"ISOIR", "ISO2022IR"}) {
    if (number.starts_with(prefix)) number.remove_prefix(prefix.size());
  }
  const SingleByteSet* set = set_of_number(number);
  // With several values the escape sequences tell; with none it is what old files mean.
  const bool assumed = told_none && value_.find('\\') == std::string::npos;
  if (assumed) set = set_of_number("100");
  const bool pairs = first_ == "GB18030" || first_ == "GBK";
  Text text = ByteDecoder(set, pairs).decode(bytes);
  if (text.odd.empty() && assumed) {
    text.odd = "taken for Latin-1, though the file does not say so";
  } else if (!text.odd.empty()) {
    text.odd += " (Specific Character Set " + in_quotes(value_) + ")";
  }
  return text;
}

}  // namespace tetloft::internal::io
