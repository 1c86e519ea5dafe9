#include "xml.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include "pluginlib/exceptions.hpp"

namespace pluginlib::detail
{

namespace
{

constexpr auto kSpaces = " \t\r\n";
constexpr auto kEndsName = " \t\r\n=/<>\"'&";

std::string to_utf8(unsigned long code)
{
  const auto following = [code](int shift) {return static_cast<char>(0x80 | ((code >> shift) & 0x3F));};
  if (code < 0x80) {
    return {static_cast<char>(code)};
  }
  if (code < 0x800) {
    return {static_cast<char>(0xC0 | (code >> 6)), following(0)};
  }
  if (code < 0x10000) {
    return {static_cast<char>(0xE0 | (code >> 12)), following(6), following(0)};
  }
  return {static_cast<char>(0xF0 | (code >> 18)), following(12), following(6), following(0)};
}

/// What `&name;` stands for; nothing if XML has no such name.
std::optional<std::string> entity(const std::string & name)
{
  static const std::map<std::string, std::string> named{
    {"lt", "<"}, {"gt", ">"}, {"amp", "&"}, {"quot", "\""}, {"apos", "'"}};
  if (const auto found = named.find(name); found != named.end()) {
    return found->second;
  }
  const bool is_hex = name.compare(0, 2, "#x") == 0;
  const std::string digits = name.compare(0, 1, "#") == 0 ? name.substr(is_hex ? 2 : 1) : "";
  const auto known = is_hex ? "0123456789abcdefABCDEF" : "0123456789";
  if (digits.empty() || digits.size() > 7 || digits.find_first_not_of(known) != std::string::npos) {
    return std::nullopt;
  }
  return to_utf8(std::stoul(digits, nullptr, is_hex ? 16 : 10));
}

/// Reads a text from its beginning to its end. Checks neither types of documents nor namespaces.
class Reader
{
public:
  Reader(std::string text, std::string file)
  : text_(std::move(text)), file_(std::move(file))
  {
  }

  std::vector<Element> document()
  {
    std::vector<Element> elements;
    take("\xEF\xBB\xBF");  // marks UTF-8
    for (skip_spaces(); at_ < text_.size(); skip_spaces()) {
      if (!skip_aside()) {
        elements.push_back(element());
      }
    }
    if (elements.empty()) {
      fail("there is no element in this file");
    }
    return elements;
  }

private:
  Element element()
  {
    if (!take("<")) {
      fail("expected an element, which begins with <");
    }
    Element made;
    made.name = name();
    for (skip_spaces(); !starts(">") && !starts("/>"); skip_spaces()) {
      auto attribute = this->attribute();
      if (!made.attributes.insert(attribute).second) {
        fail("<" + made.name + "> has the attribute " + attribute.first + " twice");
      }
    }
    if (!take("/>")) {
      take(">");
      read_content(made);
    }
    return made;
  }

  std::pair<std::string, std::string> attribute()
  {
    const auto key = name();
    skip_spaces();
    if (!take("=")) {
      fail("expected = after the attribute " + key);
    }
    skip_spaces();
    const std::string quote = text_.substr(at_, 1);
    if (quote != "\"" && quote != "'") {
      fail("the value of the attribute " + key + " must be in quotes");
    }
    take(quote);
    return {key, decoded(until(quote, "the value of the attribute " + key + " has no end"))};
  }

  void read_content(Element & parent)
  {
    const auto unended = "<" + parent.name + "> is not closed by </" + parent.name + ">";
    while (!take("</")) {
      if (at_ == text_.size()) {
        fail(unended);
      } else if (take("<![CDATA[")) {
        parent.text += until("]]>", "<![CDATA[ is not closed by ]]>");
      } else if (starts("<")) {
        if (!skip_aside()) {
          parent.children.push_back(element());
        }
      } else {
        const auto end = std::min(text_.find('<', at_), text_.size());
        parent.text += decoded(text_.substr(at_, end - at_));
        at_ = end;
      }
    }
    if (name() != parent.name) {
      fail(unended);
    }
    skip_spaces();
    if (!take(">")) {
      fail("</" + parent.name + " must end with >");
    }
  }

  std::string name()
  {
    const auto end = std::min(text_.find_first_of(kEndsName, at_), text_.size());
    if (end == at_) {
      fail("expected a name");
    }
    const auto found = text_.substr(at_, end - at_);
    at_ = end;
    return found;
  }

  std::string decoded(const std::string & raw)
  {
    std::string plain;
    std::size_t done = 0;
    for (auto begin = raw.find('&'); begin != std::string::npos; begin = raw.find('&', done)) {
      const auto end = raw.find(';', begin);
      const auto meant = end == std::string::npos ? std::nullopt : entity(raw.substr(begin + 1, end - begin - 1));
      if (!meant) {
        fail("write &amp; for the character & in a text");
      }
      plain += raw.substr(done, begin - done) + *meant;
      done = end + 1;
    }
    return plain + raw.substr(done);
  }

  /// Skips what is not part of any element, if the text continues with that.
  bool skip_aside()
  {
    if (take("<!--")) {
      until("-->", "<!-- is not closed by -->");
    } else if (take("<?")) {
      until("?>", "<? is not closed by ?>");
    } else if (take("<!DOCTYPE")) {
      until(">", "<!DOCTYPE is not closed by >");
    } else {
      return false;
    }
    return true;
  }

  void skip_spaces()
  {
    at_ = std::min(text_.find_first_not_of(kSpaces, at_), text_.size());
  }

  bool starts(const std::string & with) const
  {
    return text_.compare(at_, with.size(), with) == 0;
  }

  bool take(const std::string & expected)
  {
    const bool is_there = starts(expected);
    at_ += is_there ? expected.size() : 0;
    return is_there;
  }

  /// The text before `end`, which is skipped as well.
  std::string until(const std::string & end, const std::string & missing)
  {
    const auto found = text_.find(end, at_);
    if (found == std::string::npos) {
      fail(missing);
    }
    const auto before = text_.substr(at_, found - at_);
    at_ = found + end.size();
    return before;
  }

  [[noreturn]] void fail(const std::string & reason) const
  {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    throw InvalidXMLException(file_ + ":" + std::to_string(line) + ": " + reason);
  }

  const std::string text_;
  const std::string file_;
  std::size_t at_ = 0;
};

}  // namespace

const Element * Element::child(const std::string & child_name) const
{
  const auto found = std::find_if(
    children.begin(), children.end(), [&](const Element & one) {return one.name == child_name;});
  return found == children.end() ? nullptr : &*found;
}

std::vector<Element> read_xml(const std::string & file)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw InvalidXMLException(file + ": this file cannot be read");
  }
  return Reader({std::istreambuf_iterator<char>(stream), {}}, file).document();
}

}  // namespace pluginlib::detail
