// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/base/user_error.h>
#include <abut/study/study_lines.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace abut
{
  namespace
  {
    using Row = std::vector<std::string>;

    /// The cells of a line of CSV; quotation marks are doubled within quoted ones.
    Row csv_cells(const std::string &line)
    {
      Row cells(1);
      bool quoted = false;
      for (std::size_t i = 0; i < line.size(); ++i)
      {
        const bool is_mark = line[i] == '"';
        if (is_mark && quoted && i + 1 < line.size() && line[i + 1] == '"')
          cells.back() += line[++i];
        else if (is_mark)
          quoted = !quoted;
        else if (line[i] == ',' && !quoted)
          cells.emplace_back();
        else
          cells.back() += line[i];
      }
      for (std::string &cell : cells)
        cell = trim(cell);
      return cells;
    }

    /// The lines of a peers' file, by the names of its columns.
    class PeersFile
    {
    public:
      explicit PeersFile(const std::string &path) : path_(path), file_(path)
      {
        std::string head;
        if (!std::getline(file_, head))
          throw UserError("Study/Peers: the file " + path + " cannot be read or is empty");
        columns_ = csv_cells(head);
        for (const std::string needed : {"scene", "program", "variant"})
          if (std::find(columns_.begin(), columns_.end(), needed) == columns_.end())
            throw UserError("Study/Peers: " + path + " has no column `" + needed + "`");
      }

      bool next()
      {
        std::string text;
        do
        {
          ++line_;
          if (!std::getline(file_, text))
            return false;
        } while (trim(text).empty());
        row_ = csv_cells(text);
        if (row_.size() != columns_.size())
          refuse(std::to_string(row_.size()) + " cells, allowed are " + std::to_string(columns_.size()));
        return true;
      }

      /// Empty where there is no such column.
      std::string operator[](const std::string &column) const
      {
        const auto found = std::find(columns_.begin(), columns_.end(), column);
        return found == columns_.end() ? "" : row_[static_cast<std::size_t>(found - columns_.begin())];
      }

      /// A number not below 0; empty where the cell is.
      std::optional<double> number(const std::string &column) const
      {
        const std::string text = (*this)[column];
        if (text.empty())
          return {};
        std::istringstream in(text);
        in.imbue(std::locale::classic());
        double value = 0.;
        if (!(in >> value) || !in.eof() || !std::isfinite(value) || value < 0.)
          refuse("`" + text + "` in the column " + column + ", allowed are numbers from 0 on, or nothing");
        return value;
      }

    private:
      [[noreturn]] void refuse(const std::string &received) const
      {
        throw UserError("Study/Peers: " + path_ + ", line " + std::to_string(line_) + ": received " +
                        received);
      }

      std::string path_;
      std::ifstream file_;
      Row columns_, row_;
      unsigned int line_ = 1;
    };

    std::map<std::string, double> peer_point(const PeersFile &file)
    {
      std::map<std::string, double> point;
      const auto set = [&](const std::string &name, const std::string &column) {
        if (const auto value = file.number(column); value && *value > 0.)
          point[name] = *value;
      };
      for (const std::string error : {"stress", "pressure", "force"})
        set(error, "error_" + error);
      for (const std::string column : {"unknowns", "seconds", "cpu_seconds", "memory_mb"})
        set(column, column);
      set("seconds", "seconds_without_start"); // where it is known
      return point;
    }

    StudyLine &line_named(std::vector<StudyLine> &lines, const std::string &program, const std::string &name)
    {
      for (StudyLine &line : lines)
        if (line.program == program && line.name == name)
          return line;
      lines.push_back({program, name, {}});
      return lines.back();
    }
  } // namespace

  std::vector<StudyLine> read_peers(const Scene &scene)
  {
    if (scene.study.peers.empty())
      return {};
    const std::filesystem::path file(scene.file);
    PeersFile peers((file.parent_path() / scene.study.peers).string());
    const std::string name = file.stem().string();
    std::vector<StudyLine> lines;
    std::set<std::string> others;
    while (peers.next())
      if (const std::string scene_name = peers["scene"]; scene_name.empty() || scene_name == name)
        line_named(lines, peers["program"], peers["variant"]).points.push_back(peer_point(peers));
      else
        others.insert(scene_name);
    if (lines.empty())
    {
      std::string list;
      for (const std::string &other : others)
        list += (list.empty() ? "" : ", ") + other;
      throw UserError("Study/Peers: " + scene.study.peers + " has no row of the scene " + name +
                      (list.empty() ? "" : ", only of " + list));
    }
    return lines;
  }
} // namespace abut
