// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_TEXT_READER_H
#define PN_SUBDIVIDE_TEXT_READER_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pn_subdivide {

// Reads the words of a text line by line, or running on over the lines, and knows where it is.
// The text must outlive the reader.
class Text_reader
{
public:
  // What follows `comment_sign` in a line is skipped; '\0' if there are no comments. A line that ends with a backslash
  // goes on in the next one, if lines are joined. Throws Error if the text is in UTF-16.
  Text_reader(const std::string& text, char comment_sign, bool joins_lines = false);

  // Goes to the next line that is not blank; false at the end of the text.
  bool next_line();
  // The next word of the line; empty at its end.
  std::string_view word();
  // The next word of this line or of those that follow; empty at the end of the text.
  std::string_view word_across_lines();
  // What is left of the line, without blanks in front.
  std::string_view rest_of_line();
  // What is left of the line without blanks around, with comment signs and a last backslash: there are materials
  // called "Material #25", and files in "C:\parts\".
  std::string_view name();
  // Is nothing left in this line?
  bool at_end_of_line();
  // How many words are left in this line?
  std::size_t words_left() const;

  // The next word of this line as a number; `what` names what is expected there.
  double number(const char* what);
  std::array<double, 3> triple(const char* what); // three of them
  std::int64_t integer(const char* what);
  std::size_t count(const char* what);

  // The words of the last three of these, the last one at the end.
  const std::array<std::string_view, 3>& last_words() const { return last_words_; }

  // Of any word.
  double to_number(std::string_view word, const char* what) const;
  std::int64_t to_integer(std::string_view word, const char* what) const;
  // A number of things: not negative, and none that this machine cannot count, which may have 32 bits.
  std::size_t to_count(std::string_view word, const char* what) const;

  std::size_t line() const { return line_; } // of the last word, counted from 1
  // Where the next word is looked for in the text.
  std::size_t position() const { return pos_; }
  // Where the next line begins.
  std::size_t offset() const { return next_; }

  // The word as a message may show it: not too long, and '?' for what is not ASCII, which may be
  // anything in a damaged file.
  static std::string printable(std::string_view word);
  // Throws Error naming the line.
  [[noreturn]] void fail(const std::string& what) const;

private:
  void begin_line();
  std::size_t comment_begin(std::size_t end) const;
  bool goes_on_behind(std::size_t place) const;
  void skip_blanks();
  std::string_view required_word(const char* what);

  const std::string& text_;
  char comment_sign_, newline_;
  bool joins_lines_;
  std::size_t pos_ = 0, end_ = 0, next_ = 0, line_ = 0;
  std::array<std::string_view, 3> last_words_;
};

// "the face's vertex index 9 is out of range, there are 8 vertices"
std::string out_of_range(const std::string& index, std::uint64_t i, std::size_t number,
                         const std::string& elements);

// All bytes of a file or, for "-", of standard input. Throws Error if there are none or they cannot be read; the message does not
// name the file.
std::string file_content(const std::string& file);

// "name:rest" as name and rest; the rest is empty if there is no colon.
std::pair<std::string, std::string> split_at_colon(const std::string& text);

// Throws Usage_error: which words an option takes, and which one was probably meant.
[[noreturn]] void refuse_word(const std::string& option, const std::string& word,
                              const std::vector<std::string>& known);

// What the word of an option stands for. Throws Usage_error.
template <class Value>
Value parse_word(const std::string& option, const std::string& word,
                 const std::vector<std::pair<std::string, Value>>& known)
{
  std::vector<std::string> words;
  for (const auto& [name, value] : known) {
    if (word == name) return value;
    words.push_back(name);
  }
  refuse_word(option, word, words);
}

// Finite numbers with commas between, for the argument of an option. Throws Usage_error, which
// begins with `option`.
std::vector<double> parse_numbers(const std::string& text, const std::string& option);
// exactly so many
std::vector<double> parse_numbers(const std::string& text, std::size_t number,
                                  const std::string& option);

// Throws Usage_error if the three numbers are zero.
void require_direction(const double* direction, const std::string& option);

// The number of --roundness, from 0 to 1. Throws Usage_error, which says what else might have been `expected`.
double parse_roundness(const std::string& text, const std::string& expected = "");

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_TEXT_READER_H
