// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact that is too narrow for the cells of the side that carries its pressures, beside Hertz' peak
// [Johnson1985, sec. 4.2].
#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <iostream>

using namespace abut::testing;

namespace
{
  /// A disc of radius 1 on a block with cells four times as long, which carry from degree 2 on.
  Answer disc_pressed_by(const double force, const std::string &degree)
  {
    return run_text(
        "set Bodies = d, p\nset Contacts = c\nsubsection Discretisation\n set Degree = " + degree +
        "\nend\nsubsection Body d\n set Shape = half disc\n set Size = 1\n set Cells = 64, 16\n"
        " set Rotation angle = 180\n set Shift = 0, 1\n set Young modulus = 1000\n"
        " set Poisson ratio = 0.3\n set Conditions = bottom: resultant: 0, " +
        std::to_string(force) +
        "\nend\nsubsection Body p\n set Size = 4, 4\n set Cells = 20, 20\n set Shift = -2, -4\n"
        " set Young modulus = 1000\n set Poisson ratio = 0.3\n"
        " set Conditions = bottom: displacement: 0,0\nend\n"
        "subsection Contact c\n set Slave = d:outer\n set Master = p:top\nend\n");
  }
} // namespace

TEST(NarrowContact, IsToldWhereThePeakIsFarOff)
{
  const double modulus = 1000. / (2. * (1. - .3 * .3));
  for (const std::string degree : {"2", "3"})
    for (const double force : {2., 4., 20.})
    {
      const Answer answer = disc_pressed_by(force, degree);
      ASSERT_EQ(answer.status, 0) << answer.err;
      const double peak = std::sqrt(force * modulus / M_PI),
                   error = contact_value(answer, "c", "max_pressure") / peak - 1.;
      std::cout << "degree " << degree << ", force " << force << ": peak off by " << error << '\n';
      EXPECT_EQ(warning_codes(answer).count("narrow-contact"), force < 10. ? 1u : 0u) << answer.err;
      EXPECT_EQ(std::abs(error) > .1, force < 10.);
    }
}
