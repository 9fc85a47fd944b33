// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Text_reader.h"

#include "Error.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace pn_subdivide {
namespace {

bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

// Damaged files hold anything; an error message is one short line.
std::string printable(std::string_view word)
{
  std::string s(word.substr(0, 40));
  std::replace_if(
      s.begin(), s.end(), [](unsigned char c) { return c < 32 || c == 127; }, '?');
  return s;
}

} // namespace

Text_reader::Text_reader(const std::string& text, char comment_sign)
  : m_text(text)
  , m_comment_sign(comment_sign)
{
}

bool Text_reader::next_line()
{
  while (m_next < m_text.size()) {
    m_pos = m_next;
    const std::size_t newline = std::min(m_text.find('\n', m_pos), m_text.size());
    m_next = std::min(newline + 1, m_text.size());
    ++m_line;
    const std::string_view line(m_text.data() + m_pos, newline - m_pos);
    m_end = newline;
    if (m_comment_sign != '\0') m_end = m_pos + std::min(line.find(m_comment_sign), line.size());
    if (!at_end_of_line()) return true;
  }
  m_pos = m_end = m_text.size();
  return false;
}

void Text_reader::skip_blanks()
{
  while (m_pos < m_end && is_blank(m_text[m_pos])) ++m_pos;
}

bool Text_reader::at_end_of_line()
{
  skip_blanks();
  return m_pos == m_end;
}

std::string_view Text_reader::word()
{
  skip_blanks();
  const std::size_t begin = m_pos;
  while (m_pos < m_end && !is_blank(m_text[m_pos])) ++m_pos;
  return std::string_view(m_text.data() + begin, m_pos - begin);
}

std::string_view Text_reader::word_across_lines()
{
  if (at_end_of_line()) next_line();
  return word();
}

std::string_view Text_reader::rest_of_line()
{
  skip_blanks();
  const std::size_t begin = m_pos;
  m_pos = m_end;
  return std::string_view(m_text.data() + begin, m_end - begin);
}

std::size_t Text_reader::words_left() const
{
  std::size_t n = 0;
  bool blank = true;
  for (std::size_t i = m_pos; i < m_end; ++i) {
    if (blank && !is_blank(m_text[i])) ++n;
    blank = is_blank(m_text[i]);
  }
  return n;
}

std::string_view Text_reader::required_word(const char* what)
{
  const std::string_view w = word();
  if (w.empty()) fail(std::string("the line ends where ") + what + " is expected");
  return w;
}

double Text_reader::number(const char* what)
{
  return to_number(required_word(what), what);
}
std::int64_t Text_reader::integer(const char* what)
{
  return to_integer(required_word(what), what);
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
  throw Error("line " + std::to_string(m_line) + ": " + what);
}

} // namespace pn_subdivide
