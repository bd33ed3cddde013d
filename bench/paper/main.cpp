// Runs the experiments of the paper and writes docs/paper.md. scripts/paper.sh makes everything that this needs.
//   holdfast_paper [--small | --without-models] [WORD...]
// --small: what needs neither models nor minutes. WORD: sections alone whose titles have one of these words.
// All other sections stay on the page as they are.

#include <algorithm>
#include <exception>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/paper/document.h"
#include "bench/paper/experiments.h"
#include "bench/paper/workbench.h"

namespace holdfast::paper {
namespace {

constexpr const char* kPage = "docs/paper.md";

struct Choice {
  Needs most = Needs::Models;
  std::vector<std::string> words;
};

/// A word of some title. Throws std::runtime_error for others, options that are not known among them.
std::string knownWord(const std::string& word)
{
  const auto isTitleWithIt = [&](const Experiment& experiment) {
    return std::string(experiment.title).find(word) != std::string::npos;
  };
  if (!std::ranges::any_of(allExperiments(), isTitleWithIt))
    throw std::runtime_error('"' + word + "\" is neither an option nor part of a title of " + kPage +
                             "; options are --small and --without-models");
  return word;
}

Choice parsed(std::span<char*> arguments)
{
  Choice choice;
  for (const std::string argument : arguments)
    if (argument == "--small")
      choice.most = Needs::Nothing;
    else if (argument == "--without-models")
      choice.most = Needs::Time;
    else
      choice.words.push_back(knownWord(argument));
  return choice;
}

bool isWanted(const Experiment& experiment, const Choice& choice)
{
  const std::string title = experiment.title;
  const auto isNamed = [&](const std::string& word) { return title.find(word) != std::string::npos; };
  return experiment.needs <= choice.most && (choice.words.empty() || std::ranges::any_of(choice.words, isNamed));
}

std::vector<std::string> titles()
{
  std::vector<std::string> all;
  for (const Experiment& experiment : allExperiments()) all.emplace_back(experiment.title);
  return all;
}

void runAll(const Choice& choice)
{
  const Workbench bench;
  std::vector<Section> made;
  for (const Experiment& experiment : allExperiments())
    if (isWanted(experiment, choice)) {
      std::cout << "== " << experiment.title << std::endl;
      made.push_back(run(experiment, bench));
      // After each one: a page is there although a later experiment fails.
      writeFile(kPage, document(titles(), made, readFile(kPage)));
    }
  std::cout << "== Written: " << made.size() << " sections of " << kPage << '\n';
}

}  // namespace
}  // namespace holdfast::paper

int main(int argc, char** argv)
try {
  holdfast::paper::runAll(holdfast::paper::parsed({argv + 1, argv + argc}));
  return 0;
} catch (const std::exception& error) {
  std::cerr << "holdfast_paper: " << error.what() << '\n';
  return 1;
}
