#pragma once
/// \file
/// docs/paper.md, made of sections.

#include <string>
#include <vector>

#include "bench/paper/section.h"

namespace holdfast::paper {

/// `text` in lines of at most 100 characters, as far as its words allow.
[[nodiscard]] std::string wrapped(const std::string& text);

/// The section as Markdown, its heading first.
[[nodiscard]] std::string toMarkdown(const Section& section);

/// The whole page. Of `titles`, which are those of all sections in their order, the page has those that `made` holds,
/// and the others as they stand in `before`, the page as it was; what neither has is left out.
[[nodiscard]] std::string document(const std::vector<std::string>& titles, const std::vector<Section>& made,
                                   const std::string& before);

/// The titles of the sections of a page, in their order.
[[nodiscard]] std::vector<std::string> titlesOf(const std::string& page);

}  // namespace holdfast::paper
