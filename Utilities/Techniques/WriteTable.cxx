// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the table of techniques to a file, for the Python package: SoftShadowsWriteTable FILE.

#include "Technique.h"

#include <cstdlib>
#include <fstream>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: SoftShadowsWriteTable FILE\n";
    return EXIT_FAILURE;
  }
  std::ofstream file(argv[1]);
  softshadows::PrintTechniquesAsJson(file);
  file.close();
  if (!file)
  {
    std::cerr << "cannot write " << argv[1] << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
