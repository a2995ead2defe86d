#include "unit/report/markup_reader.hpp"

#include <cctype>
#include <utility>

namespace tetloft::test {

namespace {

struct Broken {
  std::string why;
};

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Element document() {
    if (text_.substr(at_, 2) == "<!") {
      while (take() != '>') {
      }
    }
    skip_white();
    // No recursion: pages may be nested deeply where they are broken.
    std::vector<Element> open;
    for (;;) {
      if (!open.empty() && peek() != '<') {
        open.back().text += character();
        continue;
      }
      expect('<');
      if (peek() == '/') {
        take();
        const std::string tag = name();
        expect('>');
        if (open.empty() || open.back().tag != tag) fail("</" + tag + "> closes nothing");
        Element done = std::move(open.back());
        open.pop_back();
        if (open.empty()) return end(std::move(done));
        open.back().children.push_back(std::move(done));
        continue;
      }
      Element element;
      if (start(element)) {
        if (open.empty()) return end(std::move(element));
        open.back().children.push_back(std::move(element));
      } else {
        open.push_back(std::move(element));
      }
    }
  }

 private:
  Element end(Element root) {
    skip_white();
    if (at_ != text_.size()) fail("something follows the end");
    return root;
  }

  // Whether it is closed, too.
  bool start(Element& element) {
    element.tag = name();
    for (;;) {
      const bool white = skip_white();
      if (peek() == '>') {
        take();
        return false;
      }
      if (peek() == '/') {
        take();
        expect('>');
        return true;
      }
      if (!white) fail("no space before an attribute");
      const std::string key = name();
      expect('=');
      expect('"');
      std::string value;
      while (peek() != '"') {
        if (peek() == '<') fail("< in a value");
        value += character();
      }
      take();
      if (!element.attributes.emplace(key, value).second) fail(key + " stands twice");
    }
  }

  std::string name() {
    std::string word;
    while (std::isalnum(static_cast<unsigned char>(peek())) != 0 || peek() == '-' ||
           peek() == ':') {
      word += take();
    }
    if (word.empty()) fail("a name is missing");
    return word;
  }

  std::string character() {
    const char c = take();
    if (c == '>') fail("a bare >");
    if (c != '&') return std::string(1, c);
    std::string entity;
    while (peek() != ';') {
      if (entity.size() > 6) fail("an entity without end");
      entity += take();
    }
    take();
    static const std::map<std::string, std::string> kKnown{
        {"lt", "<"}, {"gt", ">"}, {"amp", "&"}, {"quot", "\""}, {"#39", "'"}};
    const auto found = kKnown.find(entity);
    if (found == kKnown.end()) fail("no entity: " + entity);
    return found->second;
  }

  bool skip_white() {
    const std::size_t from = at_;
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
    return at_ > from;
  }
  [[nodiscard]] char peek() const {
    if (at_ >= text_.size()) fail("the text ends");
    return text_[at_];
  }
  char take() {
    const char c = peek();
    ++at_;
    return c;
  }
  void expect(char c) {
    if (take() != c) fail(std::string("no ") + c);
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw Broken{why + " at byte " + std::to_string(at_) + ": " +
                 std::string(text_.substr(at_ > 40 ? at_ - 40 : 0, 60))};
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<const Element*> Element::all(std::string_view wanted, std::string_view css) const {
  std::vector<const Element*> found;
  std::vector<const Element*> waiting{this};
  while (!waiting.empty()) {
    const Element* const one = waiting.back();
    waiting.pop_back();
    for (std::size_t k = one->children.size(); k-- > 0;) waiting.push_back(&one->children[k]);
    if (wanted != "*" && one->tag != wanted) continue;
    const auto of_class = one->attributes.find("class");
    const std::string classes =
        of_class == one->attributes.end() ? "" : ' ' + of_class->second + ' ';
    if (!css.empty() && classes.find(' ' + std::string(css) + ' ') == std::string::npos) continue;
    found.push_back(one);
  }
  return found;
}

double Element::number(const std::string& attribute) const {
  const auto found = attributes.find(attribute);
  return found == attributes.end() ? -1e300 : std::stod(found->second);
}

std::string Element::words() const {
  std::string all_text;
  for (const Element* one : all("*")) all_text += one->text + ' ';
  return all_text;
}

std::optional<Element> parse_markup(std::string_view text, std::string& why) {
  try {
    return Reader(text).document();
  } catch (const Broken& broken) {
    why = broken.why;
    return std::nullopt;
  }
}

}  // namespace tetloft::test
