// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer's way into the reader of scene files; run by Utilities/Scripts/fuzz.sh. Any text is either
// refused by a SceneError that names a line, or read; what was read can be written and read again, and
// is then written as the same text. Anything else, and any finding of the sanitizers, ends the program.
#include "SceneReader.h"
#include "SceneWriter.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{

//--------------------------------------------------------------------------------------------------
void Expect(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "Not so: " << what << '\n';
    std::abort();
  }
}

//--------------------------------------------------------------------------------------------------
void ReadAndWrite(const std::string& text)
{
  softshadows::SceneDescription scene;
  try
  {
    scene = softshadows::ParseScene(text, "scene.json");
  }
  catch (const softshadows::SceneError& error)
  {
    Expect(error.GetPlace().Line >= 1, "errors name their line");
    Expect(std::string(error.what()).rfind("scene.json", 0) == 0, "errors name their file");
    return;
  }
  const std::string written = softshadows::WriteScene(scene);
  const auto again = softshadows::ParseScene(written, "scene.json");
  Expect(softshadows::WriteScene(again) == written, "what is written is read as the same");
}

}

//--------------------------------------------------------------------------------------------------
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  ReadAndWrite(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
