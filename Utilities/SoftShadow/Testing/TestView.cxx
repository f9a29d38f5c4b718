// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// softshadow view, as far as it goes without somebody to look at it; the window itself is tested with
// the viewer.

#include "ToolRun.h"

#include <gmock/gmock.h>

#include <string>

namespace
{

using testing::HasSubstr;

class View : public ToolTest
{
protected:
  const std::string Model = "'" SOFTSHADOWS_TEST_DATA_DIR "/bunny.ply'";
};

}

TEST_F(View, EndsWithAnErrorWithoutADisplay)
{
  for (const char* display : { "DISPLAY=", "DISPLAY=:9999" })
  {
    const ToolResult result = this->Run("view " + this->Model, display);
    EXPECT_EQ(result.ExitCode, 1) << display;
    EXPECT_THAT(result.Output, HasSubstr("there is no display")) << display;
    EXPECT_THAT(result.Output, HasSubstr("softshadow render")) << "what to do instead";
  }
}

TEST_F(View, NamesWhatIsWrongBeforeAWindowOpens)
{
  EXPECT_THAT(
    this->Run("view " + this->Model + " --technique pcs", "DISPLAY=").Output, HasSubstr("'pcss'"));
  EXPECT_THAT(this->Run("view " + this->Model + " --option no=1", "DISPLAY=").Output,
    HasSubstr("has no option 'no'"));
  EXPECT_THAT(this->Run("view no.ply", "DISPLAY=").Output, HasSubstr("no.ply"));
  const ToolResult result = this->Run("view " + this->Model + " --output nowhere", "DISPLAY=");
  EXPECT_EQ(result.ExitCode, 1);
  EXPECT_THAT(result.Output, HasSubstr("nowhere: there is no such folder"));
}
