// What tools read: the shape is a contract.
#include <gtest/gtest.h>

#include "compiler/diagnostics/render.h"

namespace rtac::diag {
namespace {

TEST(RenderJson, IsAnEmptyArrayWithoutDiagnostics) {
  EXPECT_EQ(render_json(Engine{}, SourceManager{}), "[]\n");
}

TEST(RenderJson, HoldsEveryPart) {
  SourceManager sources;
  const FileId file = sources.add("a.rta", "x\nab");
  Engine engine;
  engine.report({Code::missing_semicolon,
                 SourceRange{file, 2, 4},
                 "a \"message\"",
                 "label",
                 {{std::nullopt, "note"}},
                 "help",
                 {{SourceRange{file, 4, 4}, ";"}}});
  EXPECT_EQ(render_json(engine, sources), R"([
  {
    "code": 1002,
    "name": "missing_semicolon",
    "severity": "error",
    "message": "a \"message\"",
    "location": {
      "file": "a.rta",
      "begin": {
        "line": 2,
        "column": 1,
        "offset": 2
      },
      "end": {
        "line": 2,
        "column": 3,
        "offset": 4
      }
    },
    "label": "label",
    "notes": [
      {
        "message": "note",
        "location": null
      }
    ],
    "help": "help",
    "fixits": [
      {
        "location": {
          "file": "a.rta",
          "begin": {
            "line": 2,
            "column": 3,
            "offset": 4
          },
          "end": {
            "line": 2,
            "column": 3,
            "offset": 4
          }
        },
        "replacement": ";"
      }
    ]
  }
]
)");
}

TEST(RenderJson, SurvivesTextThatIsNotUtf8) {
  // A quoted byte of a broken file must not become an exception.
  Engine engine;
  engine.report({Code::cannot_read, std::nullopt, "cannot read `\xFF`", {}, {}, {}, {}});
  EXPECT_NE(render_json(engine, SourceManager{}).find("cannot read"), std::string::npos);
}

}  // namespace
}  // namespace rtac::diag
