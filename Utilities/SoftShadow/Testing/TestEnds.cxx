// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// However the tool ends, it leaves nothing behind; and it does not end for want of a display that is
// there.

#include "ToolRun.h"

#include <cstdlib>
#include <set>
#include <string>

namespace
{

const char* const Scene = R"({ "version": 1, "image": {"width": 16, "height": 16},
  "lights": [{"position": [0, 0, 5], "size": [0.2, 0.2]}],
  "objects": [{"source": "box"}] })";

// More frames than anybody waits for.
const char* const LongRun =
  "render scene.json -o old.png --report r.json --width 300 --height 300 --converge 0.0001 "
  "--converge-frames 1000000 --option map_size=4096 --option split=8";

// Runs the rest of the line with an X server of its own, which ends when its last client leaves.
const char* const OwnServer = R"(#!/bin/sh
Xvfb -displayfd 5 -terminate -screen 0 640x480x24 -nolisten tcp 5>number >/dev/null 2>&1 &
SERVER=$!
export SERVER
while [ ! -s number ]; do sleep 0.05; done
DISPLAY=:$(cat number)
export DISPLAY
rm number
"$@"
status=$?
kill $SERVER 2>/dev/null
exit $status
)";

// Runs the rest of the line, waits for its first hidden file, does $END to it, and tells how it ended.
const char* const EndWhileWriting = R"(#!/bin/sh
"$@" &
tool=$!
while kill -0 $tool 2>/dev/null && ! ls .[a-z]* >/dev/null 2>&1; do sleep 0.05; done
ls .[a-z]* >/dev/null 2>&1 && echo "there was a hidden file"
sleep 0.2
$END $tool
wait $tool
)";

bool HasProgram(const char* name)
{
  return std::system((std::string("command -v ") + name + " > /dev/null").c_str()) == 0;
}

class Ends : public ToolTest
{
protected:
  void ExpectNothingLeft(const std::string& end, const std::string& settings) const
  {
    const std::set<std::string> before = this->Files();
    const ToolResult result = this->Run(LongRun, settings);
    EXPECT_NE(result.Output.find("there was a hidden file"), std::string::npos) << result.Output;
    EXPECT_NE(result.ExitCode, 0) << end;
    EXPECT_EQ(this->Files(), before) << end;
    EXPECT_EQ(this->Read("old.png"), "old") << end;
  }
};

}

#ifdef __linux__

TEST_F(Ends, LeaveNothingBehindWhateverTheSignal)
{
  this->Write("scene.json", Scene);
  this->Write("old.png", "old");
  this->Write("end.sh", EndWhileWriting);
  // ABRT is what abort() raises, which VTK calls where a display fails.
  for (const char* name : { "ABRT", "SEGV", "PIPE", "HUP", "TERM" })
  {
    this->ExpectNothingLeft(name, std::string("END='kill -") + name + "' sh end.sh");
  }
}

// Xlib calls exit() then, or a driver faults.
TEST_F(Ends, LeaveNothingBehindWhenTheDisplayGoes)
{
  if (!HasProgram("Xvfb"))
  {
    GTEST_SKIP() << "there is no Xvfb";
  }
  this->Write("scene.json", Scene);
  this->Write("old.png", "old");
  this->Write("end.sh", EndWhileWriting);
  this->Write("server.sh", OwnServer);
  this->Write("stop.sh", "kill -KILL $SERVER\n");
  this->ExpectNothingLeft(
    "the display went", "timeout 60 sh server.sh env END='sh stop.sh' sh end.sh");
}

// A server that starts afresh when its last client leaves, as under xvfb-run, refuses whoever comes in
// that moment. This one ends: the tool must not leave before it is through.
TEST_F(Ends, NoConnectionIsTheServersLastBeforeTheEnd)
{
  if (!HasProgram("Xvfb"))
  {
    GTEST_SKIP() << "there is no Xvfb";
  }
  this->Write("scene.json", Scene);
  this->Write("server.sh", OwnServer);
  const ToolResult result = this->Run("render scene.json -o a.png", "sh server.sh");
  EXPECT_EQ(result.ExitCode, 0) << result.Output;
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "scene.json", "server.sh", "a.png" }));
}

#endif
