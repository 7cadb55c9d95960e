// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Patch tests: uniform pressure and stress through any cover, several bodies, any degree.
#include <abut/run/simulation.h>

#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <random>
#include <sstream>

using namespace abut;
using namespace abut::testing;

namespace
{
  /// A rectangle [x, x + width] x [y, y + height], turned with all others about the origin.
  struct Block
  {
    std::string name;
    double x, y, width, height;
    unsigned int columns, rows;
    double modulus;
    std::string conditions, more;
  };

  class PatchScene
  {
  public:
    explicit PatchScene(const double angle, const unsigned int degree) : angle_(angle)
    {
      text_.precision(17);
      text_ << "subsection Discretisation\n set Degree = " << degree << "\nend\n";
    }
    void add(const Block &block)
    {
      const double pi = std::acos(-1.), c = std::cos(angle_ * pi / 180.), s = std::sin(angle_ * pi / 180.);
      bodies_ += (bodies_.empty() ? "" : ", ") + block.name;
      text_ << "subsection Body " << block.name << "\n set Size = " << block.width << ", " << block.height
            << "\n set Rotation angle = " << angle_ << "\n set Shift = " << c * block.x - s * block.y << ", "
            << s * block.x + c * block.y << "\n set Cells = " << block.columns << ", " << block.rows
            << "\n set Young modulus = " << block.modulus
            << "\n set Poisson ratio = 0.25\n set Conditions = " << block.conditions << '\n'
            << block.more << "end\n";
    }
    void touch(const std::string &slave, const std::string &master, const std::string &more = "")
    {
      const std::string name = "c" + std::to_string(n_contacts_++);
      contacts_ += (contacts_.empty() ? "" : ", ") + name;
      text_ << "subsection Contact " << name << "\n set Slave = " << slave << "\n set Master = " << master
            << '\n'
            << more << "end\n";
    }
    std::string path() const
    {
      return temporary_file("patch.prm",
                            "set Bodies = " + bodies_ + "\nset Contacts = " + contacts_ + '\n' + text_.str());
    }

  private:
    double angle_;
    unsigned int n_contacts_ = 0;
    std::string bodies_, contacts_;
    std::ostringstream text_;
  };

  /// Largest deviations, relative, from a uniform pressure and a uniform stress across the surface (its
  /// normal turned by `angle` from y), and the length in contact.
  struct Deviation
  {
    double pressure = 0., stress = 0., length = 0.;
  };

  Deviation deviation(const PatchScene &patch, const double pressure, const double angle)
  {
    const Scene scene = Scene::read(patch.path(), {});
    Simulation simulation(scene);
    const Results results = simulation.run({});
    EXPECT_TRUE(results.converged()) << results.message();
    const double pi = std::acos(-1.);
    const Vector2 normal(-std::sin(angle * pi / 180.), std::cos(angle * pi / 180.));
    Deviation worst;
    for (const PairResult &pair : results.pairs)
    {
      EXPECT_TRUE(!pair.parts.empty() && pair.loads.allFinite() && pair.pressures.allFinite());
      for (const std::size_t k : pair.parts)
        for (const double p :
             {pair.loads[static_cast<Eigen::Index>(k)], pair.pressures[static_cast<Eigen::Index>(k)]})
          worst.pressure = std::max(worst.pressure, std::abs(p / pressure - 1.));
      worst.length += pair.contact_length;
    }
    for (const BodyResult &body : results.bodies)
      body.body->visit_stress(
          body.deformation, SamplePoints::energy, [&](const SamplePoint &, const Stress &stress) {
            Eigen::Matrix2d tensor;
            tensor << stress.xx, stress.xy, stress.xy, stress.yy;
            EXPECT_TRUE(tensor.allFinite());
            worst.stress = std::max(worst.stress, (tensor * normal + pressure * normal).norm() / pressure);
          });
    return worst;
  }

  const std::string between_rollers = "left: normal displacement: 0; right: normal displacement: 0";
} // namespace

class ContactPatch : public ::testing::TestWithParam<unsigned int>
{};

// One side on several others of random widths, cells and stiffness: cells of all are covered in part, down to
// slivers of 1e-12 of a cell; heights in proportion to the moduli let all of them give way alike.
TEST_P(ContactPatch, OneSideOnManyOthers)
{
  std::mt19937 generator(GetParam());
  std::uniform_real_distribution<double> random(0., 1.);
  Deviation worst;
  for (int trial = 0; trial < 24; ++trial)
  {
    const double angle = trial % 3 == 0 ? 0. : 90. * random(generator);
    PatchScene patch(angle, GetParam());
    const auto columns = static_cast<unsigned int>(3 + 5 * random(generator));
    std::vector<double> ends = {0., 2.};
    for (unsigned int k = 1; k < columns; ++k) // anywhere in a cell, or a sliver from its end
      if (random(generator) < .5)
        ends.push_back(
            2. / columns *
            (k + (trial % 2 == 0 ? .6 * random(generator) : std::pow(10., -12. * random(generator)) / 2.)));
    std::sort(ends.begin(), ends.end());
    patch.add({"upper", 0., 1., 2., 1., columns, 2, 1000., between_rollers + "; top: pressure: 12", ""});
    unsigned int n = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    {
      const std::string name = "m" + std::to_string(n++);
      const double stiffness = std::pow(10., random(generator) - .5);
      patch.add({name, ends[k], 1. - stiffness, ends[k + 1] - ends[k], stiffness,
                 static_cast<unsigned int>(1 + 5 * random(generator)), 2, 1000. * stiffness,
                 between_rollers + "; bottom: normal displacement: 0", ""});
      if (random(generator) < .5)
        patch.touch("upper:bottom", name + ":top");
      else
        patch.touch(name + ":top", "upper:bottom");
    }
    const Deviation found = deviation(patch, 12., angle);
    worst = {std::max(worst.pressure, found.pressure), std::max(worst.stress, found.stress), 0.};
    EXPECT_NEAR(found.length, 2., 1e-9) << trial;
  }
  EXPECT_LT(worst.pressure, 1e-9);
  EXPECT_LT(worst.stress, 1e-9);
  std::cout << "degree " << GetParam() << ": pressure uniform to " << worst.pressure << ", stress to "
            << worst.stress << '\n';
}

// Rows of bricks upon bricks, joints nowhere above one another: one surface, several bodies on both sides.
TEST_P(ContactPatch, BricksUponBricks)
{
  for (const double angle : {0., 33.})
    for (const unsigned int fine : {1u, 5u})
    {
      PatchScene patch(angle, GetParam());
      const std::string rollers = between_rollers;
      patch.add({"a", 0., 0., .7, 1., 2, 2, 1000., rollers + "; bottom: normal displacement: 0", ""});
      patch.add({"b", .7, 0., .8, 1., 3, 2, 1000., rollers + "; bottom: normal displacement: 0", ""});
      patch.add({"c", 1.5, 0., .5, 1., 1, 2, 1000., rollers + "; bottom: normal displacement: 0", ""});
      patch.add({"d", 0., 1., 1.1, 1., fine, 2, 1000., rollers + "; top: pressure: 12", ""});
      patch.add({"e", 1.1, 1., .9, 1., 2 * fine, 2, 1000., rollers + "; top: pressure: 12", ""});
      for (const auto &[slave, master] : {std::pair("d:bottom", "a:top"),
                                          {"d:bottom", "b:top"},
                                          {"e:bottom", "b:top"},
                                          {"c:top", "e:bottom"}})
        patch.touch(slave, master);
      const Deviation found = deviation(patch, 12., angle);
      EXPECT_LT(found.pressure, 1e-9);
      EXPECT_LT(found.stress, 1e-9);
      EXPECT_NEAR(found.length, 2., 1e-12);
    }
}

// Three bodies at a point: two side by side under a third press one another too, by nu/(1 - nu) of it.
TEST_P(ContactPatch, ThreeBodiesAtAPoint)
{
  PatchScene patch(0., GetParam());
  patch.add({"upper", 0., 1., 2., 1., 3, 2, 1000., between_rollers + "; top: pressure: 12", ""});
  patch.add({"left", 0., 0., 1., 1., 2, 2, 1000.,
             "left: normal displacement: 0; bottom: normal displacement: 0", ""});
  patch.add({"right", 1., 0., 1., 1., 3, 3, 1000.,
             "right: normal displacement: 0; bottom: normal displacement: 0", ""});
  patch.touch("upper:bottom", "left:top");
  patch.touch("upper:bottom", "right:top");
  patch.touch("left:right", "right:left");
  const Answer answer = run({patch.path()});
  ASSERT_EQ(answer.status, 0) << answer.err;
  for (const auto &[name, pressure] : {std::pair("c0", 12.), {"c1", 12.}, {"c2", 4.}})
    for (const std::string what : {"load", "pressure"})
      for (const double p : column(answer.directory + "/contact_" + name + ".csv", what))
        EXPECT_NEAR(p, pressure, 1e-9 * pressure) << name;
}

class ContactPatchOfTriangles : public ::testing::TestWithParam<unsigned int>
{};

TEST_P(ContactPatchOfTriangles, UponQuadrilaterals)
{
  for (const double angle : {0., 20.})
    for (const bool swapped : {false, true})
    {
      PatchScene patch(angle, GetParam());
      patch.add({"upper", 0., 1., 2., 1., 5, 2, 1000., between_rollers + "; top: pressure: 12",
                 " set Cell type = triangles\n"});
      patch.add(
          {"lower", 0., 0., 2., 1., 7, 2, 100., between_rollers + "; bottom: normal displacement: 0", ""});
      if (swapped)
        patch.touch("upper:bottom", "lower:top");
      else
        patch.touch("lower:top", "upper:bottom");
      const Deviation found = deviation(patch, 12., angle);
      EXPECT_LT(found.pressure, 1e-9);
      EXPECT_LT(found.stress, 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Degree, ContactPatch, ::testing::Values(1u, 2u, 3u));
INSTANTIATE_TEST_SUITE_P(Degree, ContactPatchOfTriangles, ::testing::Values(1u, 2u)); // all they have
