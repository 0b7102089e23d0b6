#include "engine/study/setting.h"

#include <gtest/gtest.h>

namespace netpocket {
namespace {

TEST(Setting, SetsAParameterOrOneNumberOfAList) {
  Scenario scenario;
  EXPECT_TRUE(apply_settings(scenario, {{"target.radius", "4.25"},
                                        {"target.shape", "\"box\""},
                                        {"target.position[2]", "-0.5"},
                                        {"rods.profile[1][0]", "5.125"}})
                  .ok());
  EXPECT_EQ(scenario.target.radius, 4.25);
  EXPECT_EQ(scenario.target.shape, TargetShape::box);
  EXPECT_EQ(scenario.target.position, Eigen::Vector3d(0, 7.5, -0.5));
  EXPECT_EQ(scenario.rods.profile[1].x(), 5.125);
  EXPECT_EQ(scenario.rods.profile[1].y(), Scenario().rods.profile[1].y());
}

TEST(Setting, RefusesWhatIsNotThere) {
  const struct {
    Setting setting;
    const char* says;
  } cases[] = {
      {{"target.radios", "4"}, "did you mean 'target.radius'?"},
      {{"rods.profil[1][0]", "4"}, "did you mean 'rods.profile'?"},
      {{"rods.profile[3][0]", "4"}, "there is no such number in rods.profile"},
      {{"rods.profile[1]", "4"}, "there is no such number in rods.profile"},
      {{"target.position[3]", "4"}, "there is no such number in target.position"},
      {{"target.radius[0]", "4"}, "there is no such number in target.radius"},
      {{"rods.profile[1][-1]", "4"}, "is not a parameter nor a number of one"},
      {{"rods.profile[1][0]x", "4"}, "is not a parameter nor a number of one"},
      {{"rods.profile[1][0]", "-4"}, "must be >= 0"},
      {{"rods.profile[1][0]", "nan"}, "expects a number, not \"nan\""},
      {{"rods.profile[1][0]", "4 m"}, "expects a number, not \"4 m\""},
      {{"target.radius", "\"4\""}, "expects a number in m"},
  };
  for (const auto& c : cases) {
    Scenario scenario;
    const Diagnostics diagnostics = apply_setting(scenario, c.setting);
    EXPECT_NE(diagnostics.text().find(c.says), std::string::npos) << c.setting.key << ": " << diagnostics.text();
    EXPECT_EQ(scenario.target.radius, Scenario().target.radius);
    EXPECT_EQ(scenario.rods.profile, Scenario().rods.profile);
  }
}

}  // namespace
}  // namespace netpocket
