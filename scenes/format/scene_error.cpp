#include "scenes/format/scene_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <utility>

namespace trivium::scenes {
namespace {

std::string sentence(std::string_view file, std::string_view path, std::string_view found,
                     std::string_view accepted, std::string_view suggestion) {
  std::string text(file);
  if (!path.empty()) text += fmt::format(": {}", printable(path, 200));
  text += fmt::format(": {}; accepted: {}", found, accepted);
  if (!suggestion.empty()) text += fmt::format(" (did you mean {}?)", in_quotes(suggestion));
  return text;
}

std::string lower(std::string_view word) {
  std::string result(word);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/// The number of insertions, deletions, substitutions and swaps of neighbouring letters that lead from a to b
/// (optimal string alignment distance).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
  for (std::size_t k = 0; k <= b.size(); ++k) row[k] = k;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(previous);
    previous.swap(row);
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t replaced = previous[k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1);
      row[k] = std::min({previous[k] + 1, row[k - 1] + 1, replaced});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        row[k] = std::min(row[k], before[k - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

SceneError::SceneError(std::string file, std::string path, std::string found, std::string accepted,
                       std::string suggestion)
    : Error(ErrorKind::input, sentence(file, path, found, accepted, suggestion),
            Place{path.empty() ? file : file + ": " + path}),
      file_(std::move(file)),
      path_(std::move(path)),
      found_(std::move(found)),
      accepted_(std::move(accepted)),
      suggestion_(std::move(suggestion)) {}

std::string Path::file() const { return parent_ ? parent_->file() : std::string(key_); }

std::string Path::pointer() const {
  if (!parent_) return {};
  std::string text = parent_->pointer() + '/';
  if (key_.data() == nullptr) return text + std::to_string(index_);
  for (char c : key_) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return text;
}

void fail(const Path& at, std::string found, std::string accepted, std::string suggestion) {
  throw SceneError(at.file(), at.pointer(), std::move(found), std::move(accepted), std::move(suggestion));
}

std::string printable(std::string_view text, std::size_t longest) {
  using Text = nlohmann::json;
  const bool cut = text.size() > longest;
  std::string result =
      Text(std::string(text.substr(0, longest))).dump(-1, ' ', false, Text::error_handler_t::ignore);
  result = result.substr(1, result.size() - 2) + (cut ? "..." : "");
  for (std::size_t at = 0; (at = result.find('\x7f', at)) != std::string::npos;)
    result.replace(at, 1, "\\u007f");
  return result;
}

std::string in_quotes(std::string_view text) { return '"' + printable(text) + '"'; }

std::string list_of(const std::vector<std::string_view>& words) {
  constexpr std::size_t longest = 16;  // a longer list hides the rest of the message
  std::string text;
  for (std::size_t k = 0; k < std::min(words.size(), longest); ++k)
    text += (k ? ", " : "") + printable(words[k]);
  if (words.size() > longest) text += fmt::format(", ... ({} in all)", words.size());
  return text;
}

std::string nearest(std::string_view word, const std::vector<std::string_view>& candidates) {
  constexpr std::size_t longest = 64;  // longer words are not typing errors of a known word
  if (word.size() > longest) return {};
  const std::string slip = lower(word);
  // a typing error changes at most a third of the letters, but at least one letter may differ
  std::size_t best = std::max<std::size_t>(1, word.size() / 3) + 1;
  std::string_view result;
  for (std::string_view candidate : candidates) {
    const std::size_t lengths_differ =
        std::max(candidate.size(), word.size()) - std::min(candidate.size(), word.size());
    if (lengths_differ >= best) continue;
    const std::size_t distance = edit_distance(slip, lower(candidate));
    if (distance < best) best = distance, result = candidate;
  }
  return std::string(result);
}

}  // namespace trivium::scenes
