// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/results/times.h>

namespace abut
{
  Times &Times::operator+=(const Times &other)
  {
    for (double Times::*const task :
         {&Times::mesh, &Times::assemble, &Times::factorise, &Times::solve, &Times::interface,
          &Times::estimate, &Times::adapt, &Times::output, &Times::bem, &Times::reference})
      this->*task += other.*task;
    return *this;
  }
} // namespace abut
