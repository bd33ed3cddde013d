#pragma once
/// \file
/// What an experiment hands back: a section of docs/paper.md, and its numbers for the tests.

#include <map>
#include <string>
#include <vector>

namespace holdfast::paper {

/// Cells as they are printed; every row has as many as `columns`.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// A picture on the page.
struct Illustration {
  std::string file;     ///< name in the folder of pictures, or its path where it is not committed
  std::string caption;  ///< a sentence
  bool isCommitted = true;
};

struct Section {
  std::string title;                  ///< the heading, by which the section is found again
  std::string paper;                  ///< what the paper shows
  std::string method;                 ///< what is measured here, and how
  std::string result;                 ///< what came of it, with the numbers that matter
  std::vector<std::string> commands;  ///< that made the numbers, in their order
  std::vector<Table> tables;
  std::vector<Illustration> pictures;
  std::map<std::string, double> numbers;  ///< by names that the tests know
};

}  // namespace holdfast::paper
