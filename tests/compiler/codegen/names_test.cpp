// The author's names survive into generated code unless C or C++ forbids them, and never clash.
#include "compiler/codegen/names.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "compiler/codegen/library_names.h"

namespace rtac::codegen {
namespace {

struct Study {
  ir::Module module;
  sema::Spec spec;
  ir::Decision& decision(const std::string& name) {
    module.decisions.emplace_back();
    module.decisions.back().name = name;
    return module.decisions.back();
  }
  static void monitor(ir::Decision& d, const std::string& name) {
    d.monitors.emplace_back();
    d.monitors.back().name = name;
  }
};

TEST(Names, OrdinaryNamesStay) {
  for (const char* name : {"geofence", "r1", "_x", "TurtleBot3", "plan_executor"}) {
    EXPECT_EQ(legal(name), name);
  }
}

TEST(Names, KeywordsAndMacrosGetATrail) {
  for (const char* name : {"class", "int", "restrict", "std", "errno", "and", "co_await", "NULL"}) {
    EXPECT_EQ(legal(name), std::string(name) + "_");
  }
}

TEST(Names, MacrosOfHeadersThatAreIncludedGetATrail) {
  for (const char* name : {"INT64_MAX", "UINT8_C", "SIZE_WIDTH", "NAN", "M_PI"}) {
    EXPECT_EQ(legal(name), std::string(name) + "_");
  }
  for (const char* name : {"INTAKE", "SPEED_MAX", "INT_A", "MAX"}) EXPECT_EQ(legal(name), name);
}

// `_X` and `__` are the language's own, wherever they stand.
TEST(Names, ReservedFormsAreBrokenUp) {
  EXPECT_EQ(legal("_Bool"), "u_Bool");
  EXPECT_EQ(legal("__x86_64__"), "_u_x86_64_u_");
  EXPECT_EQ(legal("a__b"), "a_u_b");
}

TEST(Names, TypesOfTheLibraryGetATrail) {
  for (const char* name : {"int32_t", "uint8_t", "int_fast16_t", "uintptr_t", "size_t"}) {
    EXPECT_EQ(legal(name), std::string(name) + "_");
  }
  for (const char* name : {"speed_t", "int7_t", "hint32_t"}) EXPECT_EQ(legal(name), name);
}

// A setter that takes a value of the enumeration stands in a class with a function `step`.
TEST(Names, AnEnumerationIsNotHiddenByAMember) {
  Study s;
  for (const char* name : {"step", "Gear"}) {
    s.spec.enumerations.emplace_back();
    s.spec.enumerations.back().name = name;
  }
  const Names names(s.module, s.spec);
  EXPECT_EQ(names("step"), "step_");
  EXPECT_EQ(names("Gear"), "Gear");
}

TEST(Names, ClassesAndEnumerators) {
  EXPECT_EQ(camel("plan_executor"), "PlanExecutor");
  EXPECT_EQ(camel("a"), "A");
  EXPECT_EQ(camel("a_"), "A_");
  EXPECT_EQ(camel("__"), "_u_u_");
  EXPECT_EQ(camel("_2d"), "_2d");
  EXPECT_EQ(upper("plan_executor"), "PLAN_EXECUTOR");
}

// `namespace time` does not compile beside the function `time`, which <ctime> declares.
TEST(Names, ANamespaceIsNoFunctionOfTheLibrary) {
  for (const char* name : {"time", "signal", "index", "y0", "remove", "sinf", "class"}) {
    EXPECT_EQ(legal_namespace(name), std::string(name) + "_");
  }
  for (const char* name : {"delivery", "timer", "self"}) EXPECT_EQ(legal_namespace(name), name);
}

// The list of the headers that a folder `rtac` of generated files could hide is that of the folder.
TEST(Names, AllHeadersOfTheRuntimeAreKnown) {
  for (const auto& entry :
       std::filesystem::directory_iterator(RTAC_SOURCE_DIR "/runtime/include/rtac")) {
    if (entry.path().extension() != ".h") continue;
    const std::string stem = entry.path().stem().string();
    EXPECT_EQ(hidden_header(stem, "rtac"), "\"rtac/" + stem + ".h\"");
    EXPECT_EQ(hidden_header(stem, "out"), "");
  }
}

TEST(Names, AFileNameBecomesAWord) {
  EXPECT_EQ(word_of("my spec-v1.2"), "my_spec_v1_2");
  EXPECT_EQ(word_of("2d"), "_2d");
  EXPECT_EQ(word_of(""), "_");
  EXPECT_EQ(word_of("\xc3\xa4"), "_u_");
}

TEST(Names, AZoneDoesNotTakeTheNameOfALibraryFunction) {
  Study s;
  for (const char* name : {"reach", "room"}) {
    s.module.zones.emplace_back();
    s.module.zones.back().name = name;
  }
  const Names names(s.module, s.spec);
  EXPECT_EQ(names("room"), "room");
  EXPECT_EQ(names("reach"), "reach_");  // zone_reach is a function of the kernel
}

TEST(Names, WhatIsDerivedFromTwoZonesDiffers) {
  Study s;
  for (const char* name : {"a", "a_edges"}) {
    s.module.zones.emplace_back();
    s.module.zones.back().name = name;
  }
  const Names names(s.module, s.spec);
  EXPECT_EQ(names("a"), "a");  // zone_a and zone_a_edges
  EXPECT_EQ(names("a_edges"), "a_edges_");
}

TEST(Names, MonitorsOfOneDecisionDifferInCapitalLettersToo) {
  Study s;
  ir::Decision& d = s.decision("drive");
  for (const char* name : {"fence", "Fence", "monitors", "robots"}) Study::monitor(d, name);
  const Names names(s.module, s.spec);
  EXPECT_EQ(names("fence"), "fence");
  EXPECT_EQ(names("Fence"), "Fence_");
  EXPECT_EQ(names("monitors"), "monitors_");
  EXPECT_EQ(names("robots"), "robots_");
}

TEST(Names, EnumeratorsOfTwoDecisionsDiffer) {
  Study s;
  Study::monitor(s.decision("a"), "b_c");
  Study::monitor(s.decision("a_b"), "c");
  const Names names(s.module, s.spec);
  EXPECT_NE(upper("a_" + names("b_c")), upper(names("a_b") + "_" + names("c")));
}

TEST(Names, ADecisionDoesNotHideAClassOfTheSystem) {
  Study s;
  for (const char* name : {"system", "robot_", "plan_x", "planX"}) s.decision(name);
  const Names names(s.module, s.spec);
  EXPECT_NE(camel(names("system")), "System");
  EXPECT_NE(camel(names("robot_")), "Robot");
  EXPECT_NE(camel(names("plan_x")), camel(names("planX")));
}

// The struct of one robot and the system call functions of the scopes around them.
TEST(Names, NoMemberHidesAFunctionThatItsScopeCalls) {
  Study s;
  s.spec.kinds.emplace_back();
  s.spec.kinds.back().name = "Cart";
  s.module.zones.emplace_back();
  s.module.zones.back().name = "hall";
  for (const char* name : {"setting", "class", "recovery", "mode"}) {
    s.spec.controllers.emplace_back();
    s.spec.controllers.back().name = name;
  }
  for (const char* name : {"hall_zone", "Cart_limits", "Driver", "class_"}) {
    s.module.sites.emplace_back();
    s.module.sites.back().name = name;
  }
  s.decision("driver");
  const Names names(s.module, s.spec);
  EXPECT_NE(names("setting"), "setting");
  EXPECT_NE(names("recovery"), "recovery");
  EXPECT_NE(names("mode"), "mode");
  EXPECT_NE(names("Cart_limits"), "Cart_limits");
  EXPECT_NE(names("hall_zone"), "hall_zone");
  EXPECT_NE(names("Driver"), camel(names("driver")));
  EXPECT_NE(names("class"), names("class_"));
}

TEST(Names, ARecoveryDoesNotHideItsZone) {
  Study s;
  s.module.zones.emplace_back();
  s.module.zones.back().name = "hall";
  s.spec.controllers.emplace_back();
  s.spec.controllers.back().name = "hall_zone";
  EXPECT_NE(Names(s.module, s.spec)("hall_zone"), "hall_zone");
}

}  // namespace
}  // namespace rtac::codegen
