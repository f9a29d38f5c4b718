// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a run consists of, and how its time is shared out.
#include "BenchmarkPlan.h"

#include <gtest/gtest.h>

#include <set>

using namespace softshadows;

namespace
{

const std::vector<KnownTechnique> Known = { { "sampled", { "map_size", "samples", "weights" } },
  { "pcss", { "map_size", "search_width", "filter_width", "weights", "split" } },
  { "ssabss", { "map_size", "search_width", "filter_width", "split" } },
  { "traced", { "map_size", "rays", "most_rays", "filter", "adaptive", "split" } } };

//--------------------------------------------------------------------------------------------------
std::set<std::string> Names(PlanSize size)
{
  std::set<std::string> names;
  for (const ContestantChoice& choice : PlanContestants(Known, size))
  {
    EXPECT_TRUE(names.insert(choice.GetName()).second) << choice.GetName() << " is there twice";
  }
  return names;
}

//--------------------------------------------------------------------------------------------------
BenchmarkScene Named(const std::string& name, bool grows = false)
{
  BenchmarkScene scene;
  scene.Name = name;
  scene.Width = 640;
  scene.Height = 480;
  scene.Grows = grows;
  scene.Share = grows ? 1.0 : 3.0;
  return scene;
}

//--------------------------------------------------------------------------------------------------
TEST(BenchmarkPlan, HasPeersAndEveryTechniqueWithEachSetting)
{
  const std::set<std::string> all = Names(PlanSize::All);
  for (const char* name : { "plain", "vtk map_size=1024", "rays samples=1", "rays samples=256",
         "sampled map_size=1024 samples=1 weights=mean",
         "sampled map_size=1024 samples=4 weights=mean",
         "sampled map_size=1024 samples=256 weights=mean", "pcss weights=mean",
         "pcss filter_width=41 search_width=29 weights=mean", "pcss split=2 weights=mean",
         "pcss map_size=4096 weights=mean", "ssabss" })
  {
    EXPECT_EQ(all.count(name), 1U) << name;
  }
  EXPECT_EQ(all.count("traced adaptive=off filter=off rays=16"), 1U);
  EXPECT_EQ(all.count("traced map_size=4096"), 0U) << "rays need no map";
  EXPECT_EQ(all.count("traced split=2"), 0U) << "rays need no map";
  const std::set<std::string> defaults = Names(PlanSize::Defaults);
  EXPECT_EQ(defaults,
    (std::set<std::string>{ "plain", "vtk map_size=1024",
      "sampled map_size=1024 samples=16 weights=mean",
      "sampled map_size=1024 samples=1 weights=mean", "pcss weights=mean", "ssabss", "traced" }));
  const std::vector<ContestantChoice> choices = PlanContestants(Known, PlanSize::All);
  for (const ContestantChoice& choice : choices)
  {
    const std::string name = choice.GetName();
    EXPECT_EQ(choice.IsEssential, defaults.count(name) == 1 || name == "rays samples=16") << name;
  }
  EXPECT_EQ(SelectTechniques(choices, { "plain" }).size(), 1U);
  EXPECT_THROW(SelectTechniques(choices, { "nonsense" }), std::runtime_error);
}

//--------------------------------------------------------------------------------------------------
TEST(BenchmarkPlan, SizesContainEachOtherButForFewSettings)
{
  const std::set<std::string> all = Names(PlanSize::All);
  const std::set<std::string> main = Names(PlanSize::Main);
  for (const std::string& name : main)
  {
    EXPECT_EQ(all.count(name), 1U) << name;
  }
  EXPECT_LT(main.size(), all.size());
  const std::set<std::string> few = Names(PlanSize::Few);
  // plain, vtk, rays; sampled twice, the others once
  EXPECT_EQ(few.size(), 8U);
  EXPECT_EQ(few.count("traced"), 1U) << "rays need no map";
  EXPECT_EQ(few.count("sampled map_size=1024 samples=1 weights=mean"), 1U);
}

//--------------------------------------------------------------------------------------------------
TEST(BenchmarkPlan, EveryTechniquesDefaultComesBeforeAnyOtherSetting)
{
  const std::vector<ContestantChoice> choices = PlanContestants(Known, PlanSize::All);
  std::vector<std::string> names;
  for (size_t i = 0; i < 8; ++i)
  {
    names.push_back(choices[i].GetName());
  }
  EXPECT_EQ(names,
    (std::vector<std::string>{ "plain", "vtk map_size=1024",
      "sampled map_size=1024 samples=16 weights=mean",
      "sampled map_size=1024 samples=1 weights=mean", "pcss weights=mean", "ssabss", "traced",
      "rays samples=16" }));
}

//--------------------------------------------------------------------------------------------------
TEST(BenchmarkPlan, QuickTakesFewOfItsOwnScenesAndAllOfOthers)
{
  const std::vector<BenchmarkScene> ours = PlanQuickScenes({ Named("assembly"), Named("bunny"),
    Named("terrain"), Named("fused"), Named("actors-10", true) });
  ASSERT_EQ(ours.size(), 3U);
  EXPECT_EQ(ours[2].Name, "fused");
  EXPECT_EQ(ours[0].Width, 240);
  EXPECT_EQ(ours[0].Height, 180);
  const std::vector<BenchmarkScene> others =
    PlanQuickScenes({ Named("mine"), Named("yours"), Named("actors-10", true) });
  ASSERT_EQ(others.size(), 2U);
  EXPECT_EQ(others[0].Name, "mine");
}

//--------------------------------------------------------------------------------------------------
TEST(BenchmarkPlan, TimeIsSharedOutAndNeverExceeded)
{
  const std::vector<BenchmarkScene> scenes = { Named("a"), Named("b"), Named("c", true) };
  EXPECT_DOUBLE_EQ(ShareOfTime(scenes, 0, 70.0), 30.0);
  EXPECT_DOUBLE_EQ(ShareOfTime(scenes, 1, 40.0), 30.0);
  EXPECT_DOUBLE_EQ(ShareOfTime(scenes, 2, 10.0), 10.0);
  // What one scene has used up is missing to the others.
  EXPECT_DOUBLE_EQ(ShareOfTime(scenes, 1, 20.0), 15.0);
  EXPECT_DOUBLE_EQ(ShareOfTime(scenes, 0, 0.0), 0.0);
}

}
