// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/progress.h>

#include "report_testing.h"

namespace
{
  using namespace abut;

  std::string progress_of(const unsigned int n_steps, const bool terminal, const bool quiet = false)
  {
    std::ostringstream out;
    ProgressLine line(out, terminal, quiet);
    for (unsigned int step = 1; step <= n_steps; ++step)
    {
      StepRecord record;
      record.step = step;
      record.max_pressure = 161.5;
      line.step(record);
    }
    line.finish();
    return out.str();
  }

  std::vector<std::string> steps_shown(const std::string &text)
  {
    std::vector<std::string> steps;
    std::string word;
    for (std::istringstream in(text); in >> word;)
      if (word == "step" && in >> word)
        steps.push_back(word);
    return steps;
  }

  TEST(ReportProgress, PipeGetsRoundStepsAndTheLast)
  {
    const std::string text = progress_of(123, false);
    EXPECT_EQ(steps_shown(text), (std::vector<std::string>{"1", "2", "5", "10", "20", "50", "100", "123"}));
    EXPECT_EQ(occurrences(text, "\r"), 0u);
    EXPECT_EQ(occurrences(text, "\n"), 8u);
    EXPECT_EQ(occurrences(text, "largest load       161.5"), 8u);
  }

  TEST(ReportProgress, LastStepIsShownOnce)
  {
    EXPECT_EQ(steps_shown(progress_of(5, false)), (std::vector<std::string>{"1", "2", "5"}));
  }

  TEST(ReportProgress, TerminalLineIsRewrittenNotTooOften)
  {
    const auto start = std::chrono::steady_clock::now();
    const std::string text = progress_of(2000, true);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_EQ(steps_shown(text).front(), "1");
    EXPECT_EQ(steps_shown(text).back(), "2000");
    EXPECT_EQ(occurrences(text, "\n"), 1u);
    EXPECT_EQ(text.front(), '\r');
    EXPECT_EQ(text.back(), '\n');
    EXPECT_LE(static_cast<double>(occurrences(text, "\r")), 2. + 10. * seconds);
  }

  TEST(ReportProgress, LinesOnATerminalCoverOneAnother)
  {
    std::ostringstream out;
    ProgressLine line(out, true, false);
    StepRecord record{1, 1.2345e-300, -1.2345e-300, 1., 1.2345e+300};
    line.step(record);
    line.finish();
    const std::size_t longest = out.str().size();
    record = {1, 1., 1., 1., 1.};
    line.step(record);
    line.finish();
    EXPECT_EQ(out.str().size(), 2 * longest);
  }

  TEST(ReportProgress, QuietSaysNothing)
  {
    EXPECT_EQ(progress_of(100, false, true), "");
    EXPECT_EQ(progress_of(100, true, true), "");
  }
} // namespace
