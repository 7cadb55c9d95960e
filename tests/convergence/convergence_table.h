// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

/// Errors against the mesh size, printed with the rates between neighbouring rows.
class ConvergenceTable
{
public:
  ConvergenceTable(std::string title, std::vector<std::string> columns)
      : title_(std::move(title)), columns_(std::move(columns))
  {}

  /// `size`: anything proportional to the mesh size.
  void add(const double size, const std::vector<double> &errors)
  {
    sizes_.push_back(size);
    rows_.push_back(errors);
  }

  double error(const std::size_t row, const std::size_t column) const { return rows_.at(row).at(column); }
  double last_error(const std::size_t column) const { return rows_.back().at(column); }

  /// Observed order between a row and the one before.
  double rate(const std::size_t row, const std::size_t column) const { return rate(row - 1, row, column); }
  /// Observed order of the finest pair.
  double last_rate(const std::size_t column) const { return rate(rows_.size() - 1, column); }

  /// Observed order between the first and the last row.
  double overall_rate(const std::size_t column) const { return rate(0, rows_.size() - 1, column); }

  void print() const
  {
    std::cout << title_ << '\n' << std::setw(10) << "size";
    for (const std::string &column : columns_)
      std::cout << std::setw(16) << column << std::setw(7) << "rate";
    std::cout << '\n';
    for (std::size_t row = 0; row < rows_.size(); ++row)
    {
      std::cout << std::defaultfloat << std::setprecision(4) << std::setw(10) << sizes_[row];
      for (std::size_t column = 0; column < columns_.size(); ++column)
      {
        std::cout << std::scientific << std::setprecision(3) << std::setw(16) << rows_[row][column];
        if (row == 0)
          std::cout << std::setw(7) << "";
        else
          std::cout << std::fixed << std::setprecision(2) << std::setw(7) << rate(row, column);
      }
      std::cout << '\n';
    }
    std::cout << std::defaultfloat << std::setprecision(6) << std::flush;
  }

private:
  double rate(const std::size_t coarse, const std::size_t fine, const std::size_t column) const
  {
    return std::log(error(coarse, column) / error(fine, column)) / std::log(sizes_[coarse] / sizes_[fine]);
  }

  std::string title_;
  std::vector<std::string> columns_;
  std::vector<double> sizes_;
  std::vector<std::vector<double>> rows_;
};
