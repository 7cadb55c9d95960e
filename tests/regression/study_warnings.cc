// SPDX-License-Identifier: LGPL-2.1-or-later
//
// `abut study` says what its variants warn of: on both streams, in study.csv, on the page, with --check.
#include <gtest/gtest.h>

#include "program.h"
#include "study_files.h"
#include <iterator>
#include <set>
#include <sstream>

using namespace abut::testing;

namespace
{
  // The first variant overlaps by far too much, the second one touches nothing.
  const std::string blocks = R"(
set Bodies   = upper, lower
set Contacts = joint
subsection Body upper
  set Size          = 10, 10
  set Shift         = 0, 19
  set Cells         = 4, 4
  set Young modulus = 2.1e5
  set Poisson ratio = 0.3
  set Conditions    = left: normal displacement: 0; top: displacement y: -0.01
end
subsection Body lower
  set Size          = 10, 20
  set Cells         = 4, 8
  set Young modulus = 2.1e5
  set Poisson ratio = 0.3
  set Conditions    = left: normal displacement: 0; bottom: displacement y: 0
end
subsection Contact joint
  set Slave  = upper:bottom
  set Master = lower:top
end
)";

  const std::vector<std::string> shifts = {"0, 19", "0, 21"};

  Answer run_study(const std::string &values, const std::vector<std::string> &more = {})
  {
    const std::string study = "subsection Study\n  set Sweep = Body upper/Shift = " + values + "\nend\n";
    return run(with({"study", temporary_file("blocks.prm", blocks + study)}, more));
  }

  std::multiset<std::string> words(const std::string &text)
  {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
  }

  TEST(StudyWarnings, AreThoseOfSingleRuns)
  {
    const Answer study = run_study(shifts[0] + " | " + shifts[1]);
    ASSERT_EQ(study.status, 0) << study.err;
    const CsvFile file(study.directory + "/study.csv");
    EXPECT_EQ(file.columns().back(), "warnings");
    ASSERT_EQ(file.n_rows(), 2u);
    const std::string page = read_file(study.directory + "/study.html");
    for (std::size_t row = 0; row < 2; ++row)
    {
      const Answer single = run_text(blocks, {"Body upper/Shift=" + shifts[row]});
      const std::multiset<std::string> codes = warning_codes(single);
      EXPECT_FALSE(codes.empty());
      EXPECT_EQ(words(file.text(row, "warnings")), codes);
      for (const auto &warning : single.summary["warnings"])
      {
        const std::string code = warning["code"], text = warning["message"];
        const std::string said = text + " (in the variant `Body upper/Shift=" + shifts[row] + "`)\n";
        EXPECT_EQ(occurrences(study.err, "blocks.prm: warning (" + code + "): " + said), 1u) << study.err;
        EXPECT_EQ(occurrences(study.out, "  WARNING (" + code + "): " + said), 1u) << study.out;
        EXPECT_EQ(occurrences(page, "<li><strong>" + code + "</strong>: "), 1u) << code;
      }
    }
    EXPECT_EQ(file.text(1, "warnings"), "nothing-touches");
    EXPECT_NE(file.text(0, "warnings").find("large-overlap"), std::string::npos);
    EXPECT_LT(page.find("<h2 id=\"warnings-title\">"), page.find("<h2>Quantities</h2>"));
  }

  TEST(StudyWarnings, AreSaidOnceWhereAllVariantsHaveThem)
  {
    const Answer study = run_study("0, 19 | 0, 18.9", {"--quiet"});
    EXPECT_EQ(occurrences(study.err, "(large-overlap)"), 1u) << study.err;
    EXPECT_NE(study.err.find("(in all variants"), std::string::npos) << study.err;
    EXPECT_EQ(study.out, "");
  }

  TEST(StudyWarnings, OfTheInputAreSaidByCheck)
  {
    const Answer checked = run_study(shifts[0] + " | " + shifts[1], {"--check"});
    EXPECT_EQ(checked.status, 0);
    EXPECT_EQ(occurrences(checked.err, "warning ("), 1u) << checked.err;
    EXPECT_NE(checked.err.find("warning (large-overlap)"), std::string::npos) << checked.err;
    EXPECT_NE(checked.err.find("(in the variant `Body upper/Shift=0, 19`)"), std::string::npos);
  }

  TEST(StudyWarnings, AreNoneWhereThereIsNothingToSay)
  {
    const std::vector<std::string> clean = {"--set",
                                            "Body upper/Conditions=left: normal displacement: 0; "
                                            "top: pressure: 10",
                                            "--set",
                                            "Body lower/Conditions=left: normal displacement: 0; "
                                            "bottom: displacement y: 0"};
    const std::string values = "0, 20 | 0, 19.999";
    const Answer study = run_study(values, clean);
    ASSERT_EQ(study.status, 0) << study.err;
    EXPECT_EQ(study.err, "");
    EXPECT_EQ(study.out.find("WARNING"), std::string::npos) << study.out;
    const CsvFile file(study.directory + "/study.csv");
    for (std::size_t row = 0; row < file.n_rows(); ++row)
      EXPECT_EQ(file.text(row, "warnings"), "");
    const std::string page = read_file(study.directory + "/study.html");
    EXPECT_EQ(page.find("warnings-title"), std::string::npos);
    EXPECT_EQ(page.find(">warnings</th>"), std::string::npos);
    EXPECT_EQ(run_study(values, abut::testing::with(clean, {"--check"})).err, "");
  }
} // namespace
