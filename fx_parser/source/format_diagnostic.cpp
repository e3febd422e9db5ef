// SPDX-License-Identifier: Apache-2.0
// The look of GCC's messages, which editors and CI systems know how to read.

#include <algorithm>
#include <string_view>

#include "fx_parser/source/diagnostic.h"

namespace burin::fx {

namespace {

// A line that a generator wrote may be a megabyte long: a window around the caret is shown.
constexpr std::size_t kMaxShown = 160;
constexpr std::size_t kShownBefore = 100;
constexpr int kMaxIncludeLines = 10;
constexpr int kMaxMacroNotes = 8;

struct Style {
  std::string_view place, error, warning, note, caret, reset;
};
constexpr Style kPlain{};
constexpr Style kColored{"\033[1m", "\033[1;31m", "\033[1;35m", "\033[1;36m", "\033[1;32m", "\033[0m"};

const SourceFile* FileOf(const Location& location, const SourceSet& sources) {
  return location.file < sources.files.size() && location.line > 0 ? &sources.files[location.file] : nullptr;
}

std::string_view LineOf(const SourceFile& file, std::uint32_t line) {
  std::string_view rest = file.text;
  for (std::uint32_t i = 1; i < line; ++i) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return {};
    rest.remove_prefix(end + 1);
  }
  return rest.substr(0, rest.find('\n'));
}

// The bytes of the well-formed UTF-8 character at `at`; 0 if there is none.
std::size_t CharacterLength(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(at);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xf0 && first < 0xf5 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
  if (length == 0 || first >= 0xf5) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
  }
  return length;
}

// Names and strings of a hostile text must not reach the terminal as control codes.
std::string Printable(std::string_view text) {
  std::string printable;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = CharacterLength(text, i);
    printable += length == 0 ? "?" : text.substr(i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return printable;
}

// A source line fit for a terminal, and the caret line under it: one cell per character, tabs kept, bytes that are no
// UTF-8 and control characters as '?'.
class Excerpt {
 public:
  Excerpt(std::string_view line, std::size_t caret, std::size_t end) : line_(line), caret_(caret), end_(end) {
    Window();
    for (std::size_t i = begin_; i < stop_;) i += Append(i);
    if (caret_ >= stop_) marks_ += caret_ == stop_ ? "^" : "";
  }

  [[nodiscard]] std::string Text() const { return head_ + shown_ + tail_; }
  [[nodiscard]] std::string Marks() const { return std::string(head_.size(), ' ') + marks_; }

 private:
  void Window() {
    begin_ = 0;
    stop_ = line_.size();
    if (line_.size() <= kMaxShown) return;
    if (caret_ > kShownBefore) {
      begin_ = std::min(caret_, line_.size()) - kShownBefore;
      head_ = "...";
    }
    if (begin_ + kMaxShown < line_.size()) {
      stop_ = begin_ + kMaxShown;
      tail_ = "...";
    }
  }

  std::size_t Append(std::size_t at) {
    const std::size_t length = CharacterLength(line_, at);
    if (line_[at] == '\t') {
      shown_ += '\t';
    } else if (length == 0) {
      shown_ += '?';
    } else {
      shown_ += line_.substr(at, length);
    }
    if (at <= caret_ && caret_ < at + std::max<std::size_t>(length, 1)) {
      marks_ += '^';
    } else if (at > caret_ && at < end_) {
      marks_ += '~';
    } else if (at < caret_) {
      marks_ += line_[at] == '\t' ? '\t' : ' ';
    }
    return std::max<std::size_t>(length, 1);
  }

  std::string_view line_;
  std::size_t caret_, end_;   // offsets; end_ is exclusive
  std::size_t begin_ = 0, stop_ = 0;
  std::string head_, shown_, tail_, marks_;
};

class Formatter {
 public:
  Formatter(const SourceSet& sources, bool color) : sources_(sources), style_(color ? kColored : kPlain) {}

  std::string Format(const Diagnostic& diagnostic) {
    IncludeChain(diagnostic.range.begin);
    const bool is_error = diagnostic.severity == Severity::kError;
    const bool is_warning = diagnostic.severity == Severity::kWarning;
    const std::string_view word = is_error ? "error" : is_warning ? "warning" : "note";
    const std::string code = diagnostic.code.empty() ? "" : " [" + diagnostic.code + "]";
    Message(diagnostic.range, word, is_error ? style_.error : is_warning ? style_.warning : style_.note,
            diagnostic.text + code);
    MacroChain(diagnostic.range.begin.macro);
    for (const Note& note : diagnostic.notes) Message(note.range, "note", style_.note, note.text);
    return out_;
  }

 private:
  void Add(std::string_view style, std::string_view text) {
    out_ += style;
    out_ += text;
    if (!style.empty()) out_ += style_.reset;
  }

  std::string Place(const Location& location) const {
    const SourceFile* file = FileOf(location, sources_);
    if (!file) return {};
    const PresumedLine line = Presume(*file, location.line);
    return Printable(line.path) + ":" + std::to_string(line.line);
  }

  void Message(const Range& range, std::string_view word, std::string_view word_style, const std::string& text) {
    const Location& at = range.begin;
    const std::string place = Place(at);
    if (!place.empty()) Add(style_.place, place + ":" + std::to_string(at.column) + ":"), out_ += ' ';
    Add(word_style, std::string(word) + ":");
    out_ += ' ';
    Add(style_.place, Printable(text));
    out_ += '\n';
    if (const SourceFile* file = FileOf(at, sources_)) SourceLine(*file, range);
  }

  void SourceLine(const SourceFile& file, const Range& range) {
    const std::string_view line = LineOf(file, range.begin.line);
    if (line.empty() && range.begin.column <= 1) return;
    const std::size_t caret = range.begin.column > 0 ? range.begin.column - 1 : 0;
    const std::size_t end = range.end_line == range.begin.line && range.end_column > 0 ? range.end_column - 1
                            : range.end_line > range.begin.line                        ? line.size()
                                                                                       : caret + 1;
    const Excerpt excerpt(line, std::min(caret, line.size()), end);
    out_ += excerpt.Text() + "\n";
    Add(style_.caret, excerpt.Marks());
    out_ += '\n';
  }

  void IncludeChain(const Location& location) {
    const SourceFile* file = FileOf(location, sources_);
    for (int lines = 0; file; ++lines) {
      const Location& from = file->included_from;
      file = FileOf(from, sources_);
      if (!file) break;
      const bool elided = lines == kMaxIncludeLines;
      const bool last = elided || !FileOf(file->included_from, sources_);
      out_ += lines == 0 ? "In file included from " : "                 from ";
      out_ += elided ? "..." : Place(from);
      out_ += last ? ":\n" : ",\n";
      if (elided) break;
    }
  }

  void MacroChain(std::uint32_t index) {
    for (int notes = 0; index > 0 && index <= sources_.expansions.size() && notes < kMaxMacroNotes; ++notes) {
      const MacroExpansion& expansion = sources_.expansions[index - 1];
      const Location& spot = expansion.definition;
      const std::string host = spot.file == kNoFile ? " (defined by the host)" : "";
      Message({spot, spot.line, spot.column + 1}, "note", style_.note,
              "in expansion of macro '" + expansion.name + "'" + host);
      index = expansion.parent;
    }
  }

  const SourceSet& sources_;
  const Style& style_;
  std::string out_;
};

}  // namespace

std::string FormatDiagnostic(const Diagnostic& diagnostic, const SourceSet& sources, bool color) {
  return Formatter(sources, color).Format(diagnostic);
}

}  // namespace burin::fx
