// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The program `abut`. Sample runs, from the project's root:
//   build/release/abut prm/two-layers.prm
//   build/release/abut prm/two-layers-rollers.prm --set 'Contact interface/Penalty coefficient=0.05'
//   build/release/abut prm/hertz.prm --check
//   build/release/abut --print-parameters

#include <abut/program/command_line.h>

#include <iostream>

int main(const int argc, const char *const *argv)
{
  return abut::run_command_line(argc, argv, std::cout, std::cerr);
}
