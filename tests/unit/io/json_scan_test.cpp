// The scanner of JSON: what RFC 8259 allows, event by event, and nothing else.
#include "io/json_scan.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tetloft {

using namespace internal;
namespace {

using io::JsonEvent;
using io::JsonKind;
using io::JsonScanner;

const std::string kName = "a.json";

// Events as text: {} [] k"…" s"…" numbers, words; then "!line message" at an error.
std::string events_of(const std::string& text) {
  JsonScanner json(text, kName);
  std::string all;
  for (;;) {
    const Result<JsonEvent> event = json.next();
    if (!event) {
      return all + '!' + std::to_string(event.error().where.line.value_or(0)) + ' ' +
             event.error().message;
    }
    switch (event->kind) {
      case JsonKind::open_object: all += '{'; break;
      case JsonKind::close_object: all += '}'; break;
      case JsonKind::open_array: all += '['; break;
      case JsonKind::close_array: all += ']'; break;
      case JsonKind::key: all += "k(" + event->text + ')'; break;
      case JsonKind::string: all += "s(" + event->text + ')'; break;
      case JsonKind::number: all += "n(" + std::to_string(event->number) + ')'; break;
      case JsonKind::boolean: all += event->text; break;
      case JsonKind::null: all += "null"; break;
      case JsonKind::end: return all;
    }
  }
}

TEST(JsonScanner, ReadsEveryKindOfValue) {
  EXPECT_EQ(events_of("{\"a\": [1, -2.5e1, true, false, null, \"x\"], \"b\": {}, \"c\": []}"),
            "{k(a)[n(1.000000)n(-25.000000)truefalsenulls(x)]k(b){}k(c)[]}");
  EXPECT_EQ(events_of(""), "");
  EXPECT_EQ(events_of("\xEF\xBB\xBF 0 "), "n(0.000000)");
}

TEST(JsonScanner, ReadsTextsInARow) {
  EXPECT_EQ(events_of("{}\n{}\n"), "{}{}");
  EXPECT_EQ(events_of("\x1E{}\n\x1E[1]\n"), "{}[n(1.000000)]");
  EXPECT_EQ(events_of("[\x1E]").substr(0, 2), "[!");
}

TEST(JsonScanner, DecodesEscapes) {
  EXPECT_EQ(events_of(R"("\"\\\/\b\f\n\r\t")"), "s(\"\\/\b\f\n\r\t)");
  EXPECT_EQ(events_of(R"("\u0041\u00e9\u20AC\ud83d\uDE00")"),
            "s(A\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80)");
}

TEST(JsonScanner, RefusesWhatIsNoJson) {
  const std::vector<std::string> wrong{
      "[1,]",        "[,1]",       "{\"a\":1,}",  "{\"a\" 1}",
      "{a:1}",       "[1 2]",      "[01]",        "[+1]",
      "[.5]",        "[1.]",       "[1e]",        "[-]",
      "[NaN]",       "[Infinity]", "[tru]",       "[truest]",
      "\"a\nb\"",    "\"\\x\"",    "\"\\u12g4\"", "\"\\ud800\"",
      "\"\\udc00\"", "[}",         "{\"a\":1]",   "]",
      "[1",          "{\"a\"",     "\"a",         "\"\\ud800\\u0041\"",
      "[1]]",        "'a'"};
  for (const std::string& text : wrong) {
    EXPECT_NE(events_of(text).find('!'), std::string::npos) << text;
  }
}

TEST(JsonScanner, NamesTheLine) {
  EXPECT_EQ(events_of("[\n1,\n\n x]"), "[n(1.000000)!4 'x' is no value of JSON");
}

TEST(JsonScanner, TellsNumbersBeyondDoubles) {
  const std::string text = "[1e999, 1e-999]";
  JsonScanner json(text, kName);
  static_cast<void>(json.next());
  const Result<JsonEvent> large = json.next();
  ASSERT_TRUE(large.ok());
  EXPECT_FALSE(large->finite);
  const Result<JsonEvent> small = json.next();
  ASSERT_TRUE(small.ok());
  EXPECT_TRUE(small->finite);
  EXPECT_EQ(small->number, 0);
}

TEST(JsonScanner, NestsAsDeepAsTheFile) {
  constexpr std::size_t kDeep = 1'000'000;
  const std::string text = std::string(kDeep, '[') + std::string(kDeep, ']');
  JsonScanner json(text, kName);
  const Result<JsonEvent> first = json.next();
  ASSERT_TRUE(first.ok());
  EXPECT_TRUE(json.skip(*first).ok());
  EXPECT_EQ(json.depth(), 0U);
  EXPECT_EQ(json.next()->kind, JsonKind::end);
}

}  // namespace
}  // namespace tetloft
