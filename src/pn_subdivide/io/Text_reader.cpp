// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Text_reader.h"

#include "io/Error.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>

#if __has_include(<unistd.h>)
#  include <sys/stat.h>
#  include <unistd.h>
#endif

namespace pn_subdivide {
namespace {

bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

// A byte order mark, or a first letter of ASCII in two bytes.
bool is_utf_16(const std::string& text)
{
  if (text.size() < 2) return false;
  if (text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0) return true;
  return (text[0] == '\0') != (text[1] == '\0');
}

// Lines of classic Mac OS end with carriage returns. The first two tell: behind a header there may be anything.
bool has_classic_lines(const std::string& text)
{
  const std::size_t first = text.find_first_of("\r\n");
  if (first == std::string::npos || text[first] != '\r') return false;
  const std::size_t second = text.find_first_of("\r\n", first + 1);
  return second == std::string::npos ||
         (text[second] == '\r' && text.compare(second + 1, 1, "\n") != 0);
}

void close_unless_stdin(std::FILE* file)
{
  if (file != stdin) std::fclose(file);
}

// Devices such as /dev/zero have no end; the input at a terminal has.
bool is_endless([[maybe_unused]] std::FILE* file)
{
#if __has_include(<unistd.h>)
  struct stat status;
  const int descriptor = ::fileno(file);
  return ::fstat(descriptor, &status) == 0 && S_ISCHR(status.st_mode) && ::isatty(descriptor) == 0;
#else
  return false;
#endif
}

double parse_number(const std::string& word, const std::string& option)
{
  char* end = nullptr;
  const double x = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(x))
    throw Usage_error(option + ": '" + word + "' is not a number");
  return x;
}

} // namespace

Text_reader::Text_reader(const std::string& text, char comment_sign, bool joins_lines)
  : text_(text)
  , comment_sign_(comment_sign)
  , newline_(has_classic_lines(text) ? '\r' : '\n')
  , joins_lines_(joins_lines)
{
  const std::string_view byte_order_mark = "\xEF\xBB\xBF"; // some editors put it in front
  if (text.compare(0, byte_order_mark.size(), byte_order_mark) == 0) next_ = byte_order_mark.size();
  if (is_utf_16(text))
    throw Error(
      "the text is in UTF-16: save it as UTF-8, for instance with iconv -f UTF-16 -t UTF-8");
}

std::string Text_reader::printable(std::string_view word)
{
  std::string s(word.substr(0, 40));
  std::replace_if(
    s.begin(), s.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
  return s;
}

bool Text_reader::next_line()
{
  while (joins_lines_ && !at_end_of_line()) word(); // this one may go on
  while (next_ < text_.size()) {
    begin_line();
    if (!at_end_of_line()) return true;
  }
  pos_ = end_ = text_.size();
  return false;
}

void Text_reader::begin_line()
{
  pos_ = next_;
  end_ = std::min(text_.find(newline_, pos_), text_.size());
  next_ = std::min(end_ + 1, text_.size());
  ++line_;
  if (comment_sign_ != '\0') end_ = comment_begin(end_);
}

// In "1.#INF" and "-1.#IND", which Microsoft's programs write for what is no number, it begins no comment.
std::size_t Text_reader::comment_begin(std::size_t end) const
{
  const std::string_view line(text_.data() + pos_, end - pos_);
  std::size_t i = line.find(comment_sign_);
  while (i < line.size() && i >= 2 && line.substr(i - 2, 2) == "1." && i + 1 < line.size() &&
         line[i + 1] >= 'A' && line[i + 1] <= 'Z')
    i = line.find(comment_sign_, i + 1);
  return pos_ + std::min(i, line.size());
}

bool Text_reader::goes_on_behind(std::size_t place) const
{
  return joins_lines_ && text_[place] == '\\' &&
         (place + 1 == end_ || (place + 2 == end_ && text_[place + 1] == '\r'));
}

void Text_reader::skip_blanks()
{
  for (;;) {
    while (pos_ < end_ && is_blank(text_[pos_])) ++pos_;
    if (pos_ == end_ || !goes_on_behind(pos_)) return;
    begin_line();
  }
}

bool Text_reader::at_end_of_line()
{
  skip_blanks();
  return pos_ == end_;
}

std::string_view Text_reader::word()
{
  skip_blanks();
  const std::size_t begin = pos_;
  while (pos_ < end_ && !is_blank(text_[pos_]) && !goes_on_behind(pos_)) ++pos_;
  return std::string_view(text_.data() + begin, pos_ - begin);
}

std::string_view Text_reader::word_across_lines()
{
  if (at_end_of_line()) next_line();
  return word();
}

std::string_view Text_reader::rest_of_line()
{
  skip_blanks();
  const std::size_t begin = pos_;
  pos_ = end_;
  return std::string_view(text_.data() + begin, end_ - begin);
}

std::string_view Text_reader::name()
{
  end_ = next_ > pos_ && text_[next_ - 1] == newline_ ? next_ - 1 : next_;
  std::size_t begin = pos_, end = end_;
  pos_ = end_;
  while (begin < end && is_blank(text_[begin])) ++begin;
  while (end > begin && is_blank(text_[end - 1])) --end;
  return std::string_view(text_.data() + begin, end - begin);
}

std::size_t Text_reader::words_left() const
{
  Text_reader rest = *this;
  std::size_t n = 0;
  while (!rest.word().empty()) ++n;
  return n;
}

std::string_view Text_reader::required_word(const char* what)
{
  const std::string_view w = word();
  if (w.empty()) fail(std::string("the line ends where ") + what + " is expected");
  last_words_ = {last_words_[1], last_words_[2], w};
  return w;
}

double Text_reader::number(const char* what)
{
  return to_number(required_word(what), what);
}

std::array<double, 3> Text_reader::triple(const char* what)
{
  const double x = number(what), y = number(what), z = number(what);
  return {x, y, z};
}

std::int64_t Text_reader::integer(const char* what)
{
  return to_integer(required_word(what), what);
}

std::size_t Text_reader::count(const char* what)
{
  return to_count(required_word(what), what);
}

double Text_reader::to_number(std::string_view w, const char* what) const
{
  // strtod() and not from_chars(): it rounds numbers out of range to 0 and infinity, takes a '+',
  // and there are standard libraries without from_chars() for floating point. The text ends with
  // a zero, and a number with the word.
  char* end = nullptr;
  const double x = std::strtod(w.data(), &end);
  if (w.empty() || end != w.data() + w.size())
    fail("'" + printable(w) + "' stands where " + what + " is expected");
  return x;
}

std::size_t Text_reader::to_count(std::string_view w, const char* what) const
{
  const std::int64_t n = to_integer(w, what);
  if (n < 0) fail(std::string(what) + " is negative");
  const auto count = static_cast<std::size_t>(n);
  if (static_cast<std::int64_t>(count) != n)
    fail(std::string(what) + " is too large: " + printable(w));
  return count;
}

std::int64_t Text_reader::to_integer(std::string_view w, const char* what) const
{
  const std::string_view digits = w.substr(!w.empty() && w.front() == '+' ? 1 : 0);
  std::int64_t n = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), n);
  if (digits.empty() || result.ec != std::errc() || result.ptr != digits.data() + digits.size())
    fail("'" + printable(w) + "' stands where " + what + " is expected");
  return n;
}

void Text_reader::fail(const std::string& what) const
{
  throw Error("line " + std::to_string(line_) + ": " + what);
}

std::string out_of_range(const std::string& index, std::uint64_t i, std::size_t number,
                         const std::string& elements)
{
  return index + " " + std::to_string(i) + " is out of range, there are " + std::to_string(number) +
         " " + elements;
}

std::string file_content(const std::string& file)
{
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw Error("this is a directory, not a file to read");

  const std::unique_ptr<std::FILE, void (*)(std::FILE*)> in(
    file == "-" ? stdin : std::fopen(file.c_str(), "rb"), close_unless_stdin);
  if (!in) throw Error(std::string("cannot be opened: ") + std::strerror(errno));

  std::string content;
  std::string block(1 << 20, '\0');
  while (const std::size_t n = std::fread(&block[0], 1, block.size(), in.get())) {
    if (is_endless(in.get())) throw Error("this is a device without end, not a file to read");
    content.append(block, 0, n);
  }
  if (std::ferror(in.get())) throw Error(std::string("cannot be read: ") + std::strerror(errno));
  if (content.empty()) throw Error(file == "-" ? "nothing came in" : "the file is empty");
  return content;
}

std::pair<std::string, std::string> split_at_colon(const std::string& text)
{
  const std::size_t colon = text.find(':');
  return {text.substr(0, colon), colon == std::string::npos ? "" : text.substr(colon + 1)};
}

void refuse_word(const std::string& option, const std::string& word,
                 const std::vector<std::string>& known)
{
  throw Usage_error(option + " '" + word + "': expected " + enumeration(known, "or") +
                    did_you_mean(word, known));
}

std::vector<double> parse_numbers(const std::string& text, const std::string& option)
{
  std::vector<std::string> words;
  boost::algorithm::split(words, text, boost::algorithm::is_any_of(","));
  std::vector<double> numbers;
  numbers.reserve(words.size());
  for (const std::string& word : words) numbers.push_back(parse_number(word, option));
  return numbers;
}

std::vector<double> parse_numbers(const std::string& text, std::size_t number,
                                  const std::string& option)
{
  std::vector<double> numbers = parse_numbers(text, option);
  if (numbers.size() != number)
    throw Usage_error(option + ": " + std::to_string(number) +
                      " numbers with commas between are expected");
  return numbers;
}

void require_direction(const double* direction, const std::string& option)
{
  if (std::all_of(direction, direction + 3, [](double x) { return x == 0; }))
    throw Usage_error(option + ": the axis has no direction");
}

double parse_roundness(const std::string& text, const std::string& expected)
{
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0' && x >= 0 && x <= 1) return x;
  throw Usage_error("--roundness '" + text + "': expected " + expected + "a number from 0 to 1");
}

} // namespace pn_subdivide
