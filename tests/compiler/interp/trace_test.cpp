// Traces: what is read, and how faults are reported.
#include "compiler/interp/trace.h"

#include <limits>

#include "tests/compiler/interp/testing.h"

namespace rtac::interp::test {
namespace {

std::unique_ptr<Checked> spec() {
  return monitor(
      "enum Gear { park, drive } input open : bool; input speed : real [m/s] in 0 m/s .. 3 m/s; "
      "input n : int in 0 .. 9; input gear : Gear; input p : point in -9 m .. 9 m; "
      "input t : real [K][2] in 0 K .. 400 K;",
      "open and speed >= 0 m/s and n >= 0 and gear == park and p.x >= 0 m and t[1] >= 0 K");
}
const std::string header = "time,open,speed,n,gear,p.x,p.y,t.0,t.1\n";

// "line:column: message" of the first fault; "read" when there is none.
std::string fault(const std::string& trace) {
  const auto c = spec();
  if (!c->spec) return "";
  std::istringstream in(trace);
  TraceReader reader(in, *c->spec);
  TraceRow row;
  if (reader.read_header()) {
    while (reader.read_row(row)) {
    }
  }
  const auto& error = reader.error();
  return error ? std::to_string(error->line) + ":" + std::to_string(error->column) + ": " +
                     error->message
               : "read";
}
std::string help(const std::string& trace) {
  const auto c = spec();
  std::istringstream in(trace);
  TraceReader reader(in, *c->spec);
  return reader.read_header() ? "" : reader.error()->help;
}

TEST(Trace, CellsOfEveryType) {
  const auto c = spec();
  ASSERT_TRUE(c->spec);
  std::istringstream in(header + "0.25,TRUE,1.5,7,drive,-1e-1,nan,,inf\r\n");
  TraceReader reader(in, *c->spec);
  TraceRow row;
  ASSERT_TRUE(reader.read_header() && reader.read_row(row));
  EXPECT_EQ(row.time_us, 250000);
  EXPECT_EQ(row.time, "0.25");
  const auto number = [&](std::size_t i) {
    EXPECT_EQ(row.readings[i].kind, Reading::Kind::number) << i;
    return row.readings[i].number.value();
  };
  EXPECT_EQ(number(0), 1);
  EXPECT_EQ(number(1), Rational(3, 2));
  EXPECT_EQ(number(2), 7);
  EXPECT_EQ(number(3), 1);  // drive
  EXPECT_EQ(number(4), Rational(-1, 10));
  EXPECT_EQ(row.readings[5].kind, Reading::Kind::unknown);
  EXPECT_EQ(row.readings[6].kind, Reading::Kind::none);
  EXPECT_EQ(row.readings[7].kind, Reading::Kind::unknown);
}

// A plan that a monitor without a robot asks for is an input, and that of the robot as well.
TEST(Trace, APlanThatOthersAskForIsThereWhereItStands) {
  const auto c = monitor(
      "zone room = rectangle (0 m, 0 m) to (5 m, 5 m); robot Cart { body radius 10 cm; motion "
      "point "
      "{ speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; } sense position : point error 1 cm "
      "max_age 1 s; sense velocity : vector error 1 cm/s max_age 1 s; input plan : path[2] "
      "tracking "
      "<= 10 cm; output drive : acceleration; latency 20 ms; } fleet cart : Cart; ",
      "cart.plan inside room");
  ASSERT_TRUE(c->spec);
  std::istringstream in("time,cart.plan\n0,1 1; 2 2\n1,\n2,1 1; 2 2; 3 3\n");
  TraceReader reader(in, *c->spec);
  TraceRow row;
  ASSERT_TRUE(reader.read_header() && reader.read_row(row));
  EXPECT_EQ(row.plans[0].points.size(), 2U);
  ASSERT_NE(row.readings[0].path, nullptr);
  EXPECT_EQ(row.readings[0].path->size(), 2U);
  ASSERT_TRUE(reader.read_row(row));
  EXPECT_EQ(row.plans[0].kind, Reading::Kind::none);
  EXPECT_EQ(row.readings[0].kind, Reading::Kind::none);
  ASSERT_TRUE(reader.read_row(row));  // more way-points than it may have
  EXPECT_EQ(row.plans[0].points.size(), 3U);
  EXPECT_EQ(row.readings[0].kind, Reading::Kind::unknown);
}

TEST(Trace, QuotesBlanksMarksAndEmptyLines) {
  EXPECT_EQ(fault("\xef\xbb\xbf" + header + "\n0, 1 ,\"1\" ,2,\"park\",0,0,0,0\n\n1,,,,,,,,"),
            "read");
  EXPECT_EQ(fault(header + "0,\"1,2,park,0,0,0,0,0\n"),
            "2:1: a quoted cell of this row is not closed");
  EXPECT_EQ(fault(header + "0,\"1\"1,2,2,park,0,0,0,0\n"), "2:6: text follows a quoted cell");
}

TEST(Trace, CarriageReturnsAloneEndNoLines) {
  EXPECT_EQ(fault("time,open\r0,1\r"), "1:10: a carriage return does not end a line");
  EXPECT_EQ(help("time,open\r0,1\r"), "end lines with LF or CR LF");
}

TEST(Trace, WrongMissingAndDoubleColumns) {
  EXPECT_EQ(fault(""), "1:1: the trace is empty");
  EXPECT_EQ(fault("open,time\n"), "1:1: the first column is `open`, not `time`");
  EXPECT_EQ(fault("time,open,sped\n"), "1:11: no input is called `sped`");
  EXPECT_NE(help("time,open,sped\n").find("`speed`"), std::string::npos);
  EXPECT_EQ(fault("time,open,open\n"), "1:11: the column `open` is there twice");
  EXPECT_EQ(fault("time,open,speed,n,gear,p.x,p.y,t.0\n"), "1:32: the column `t.1` is missing");
}

TEST(Trace, FaultsStandWhereTheirTextDoes) {
  EXPECT_EQ(fault("\n\r\ntime,open,sped\n"), "3:11: no input is called `sped`");
  EXPECT_EQ(fault(header + "0,  far,0,1,park,0,0,0,0\n"), "2:5: `far` is no value of `open`");
  EXPECT_EQ(fault(header + "0, \"far\",0,1,park,0,0,0,0\n"), "2:4: `far` is no value of `open`");
  EXPECT_EQ(fault(header + "0,\"\n1\",0,1,park,0,0,0,0\n"), "2:3: `\n1` is no value of `open`");
  EXPECT_EQ(fault(header + "0,\"\n\",1\n"), "3:3: the row has 3 cells, the first line 9");
}

// A recorder that wrote nothing must not look like a run in which nothing went wrong.
TEST(Trace, ATraceWithoutARowIsNone) {
  EXPECT_EQ(fault(header), "2:1: the trace ends without a row");
  EXPECT_EQ(fault(header + "\n\r\n"), "4:1: the trace ends without a row");
  EXPECT_EQ(fault(header + "0,,,,,,,,\n"), "read");
}

TEST(Trace, FormsOfOtherTablesAreToldWhatWorks) {
  EXPECT_EQ(fault("time;open;speed\n0;1;1\n"), "1:5: cells are separated by commas");
  EXPECT_EQ(fault("time\topen\n"), "1:5: cells are separated by commas");
  EXPECT_NE(help("time,open,altitude_agl\n").find("leave out the column of anything else"),
            std::string::npos);
  const auto cell = [](const std::string& text) {
    const auto c = spec();
    std::istringstream in(header + "0,1," + text + ",1,park,0,0,0,0\n");
    TraceReader reader(in, *c->spec);
    TraceRow row;
    EXPECT_FALSE(reader.read_header() && reader.read_row(row)) << text;
    return reader.error()->help;
  };
  EXPECT_NE(cell("N/A").find("an empty cell is no new sample"), std::string::npos);
  EXPECT_EQ(cell("1 m").find("an empty cell"), std::string::npos);
}

TEST(Trace, TimesIncrease) {
  const std::string rest = ",1,1,1,park,0,0,0,0\n";
  EXPECT_EQ(fault(header + "0" + rest + "0.1" + rest), "read");
  EXPECT_EQ(fault(header + "-1" + rest + "0.0" + rest), "read");
  EXPECT_EQ(fault(header + "1" + rest + "1.0" + rest),
            "3:1: the time `1.0` is not after that of the row before");
  EXPECT_EQ(fault(header + "soon" + rest), "2:1: `soon` is no time");
  EXPECT_EQ(fault(header + "nan" + rest), "2:1: `nan` is no time");
  EXPECT_EQ(fault(header + "1e30" + rest), "2:1: the time `1e30` is out of range");
}

TEST(Trace, TextsThatAreNoValues) {
  EXPECT_EQ(fault(header + "0,yes,1,1,park,0,0,0,0\n"), "2:3: `yes` is no value of `open`");
  EXPECT_EQ(fault(header + "0,1,fast,1,park,0,0,0,0\n"), "2:5: `fast` is no value of `speed`");
  EXPECT_EQ(fault(header + "0,1,1,1.5,park,0,0,0,0\n"), "2:7: `1.5` is no value of `n`");
  EXPECT_EQ(fault(header + "0,1,1,1,0,0,0,0,0\n"), "2:9: `0` is no value of `gear`");
  EXPECT_EQ(fault(header + "0,1,1 m,1,park,0,0,0,0\n"), "2:5: `1 m` is no value of `speed`");
}

// Logs hold the greatest and the least double, in any notation; what is beyond a range is unknown.
TEST(Trace, EveryDoubleIsAValue) {
  const std::string zeros(320, '0');
  for (const std::string& number : {std::string("1.7976931348623157e308"), std::string("-4.9e-324"),
                                    "1" + zeros, "0." + zeros + "1"}) {
    EXPECT_EQ(fault(header + "0,1," + number + ",1,park,0,0,300,300\n"), "read") << number;
  }
  EXPECT_NE(fault(header + "0,1,1e999,1,park,0,0,300,300\n"), "read");
  EXPECT_NE(fault(header + "1e300,1,1,1,park,0,0,300,300\n"), "read");
}

// What strtod reads as a decimal number, but nothing in base 16.
TEST(Trace, NumbersMayLackDigitsOnOneSideOfThePoint) {
  for (const auto& [text, value] :
       std::vector<std::pair<std::string, Rational>>{{".5", Rational(1, 2)},
                                                     {"5.", 5},
                                                     {"-.5", Rational(-1, 2)},
                                                     {"+5.", 5},
                                                     {"5.e-1", Rational(1, 2)},
                                                     {".5E1", 5},
                                                     {"00.50", Rational(1, 2)}}) {
    const auto number = Decimal::parse(text);
    ASSERT_TRUE(number) << text;
    EXPECT_EQ(number->value(), value) << text;
  }
  for (const char* text :
       {".", "-.", "", "+", "1..2", "1.2.", ".e1", "1e", "0x1p3", "1_0", "- 1"}) {
    EXPECT_FALSE(Decimal::parse(text)) << text;
  }
  EXPECT_EQ(fault(header + ".5,1,1.,1,park,.0,-.5,300.,.3e3\n"), "read");
  EXPECT_EQ(fault(header + "0,1,.,1,park,0,0,300,300\n"), "2:5: `.` is no value of `speed`");
}

TEST(Trace, RowsHaveOneCellForEachColumn) {
  EXPECT_EQ(fault(header + "0,1\n"), "2:3: the row has 2 cells, the first line 9");
  EXPECT_EQ(fault(header + "0,1,1,1,park,0,0,0,0,0\n"),
            "2:22: the row has 10 cells, the first line 9");
  EXPECT_EQ(fault(header + std::string(2 << 20, '0')), "2:1: the row is longer than 1 MiB");
}

TEST(Trace, NumbersAreExactAndGoToTheGridOutward) {
  const auto grid = [](const std::string& text, const Rational& step) {
    const auto number = Decimal::parse(text);
    return number ? std::pair(number->on_grid(step).lo, number->on_grid(step).hi)
                  : std::pair<std::int64_t, std::int64_t>(1, 0);
  };
  using Pair = std::pair<std::int64_t, std::int64_t>;
  const Rational milli(1, 1000);
  EXPECT_EQ(grid("0.3", milli), Pair(300, 300));
  EXPECT_EQ(grid("0.3000001", milli), Pair(300, 301));
  EXPECT_EQ(grid("-0.3000001", milli), Pair(-301, -300));
  EXPECT_EQ(
      grid("123456789012345678901234567890", milli),
      Pair(std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::max()));
  EXPECT_EQ(grid("-1e30", milli), Pair(std::numeric_limits<std::int64_t>::min(),
                                       std::numeric_limits<std::int64_t>::min()));
  EXPECT_EQ(Decimal::parse("0.1000000000000000000000001")->value() * 10 - 1,
            *parse_decimal("1e-24"));
  for (const char* text : {"", ".", "1e", "--1", "0x1", "1,5", "1 2"}) {
    EXPECT_FALSE(Decimal::parse(text)) << text;
  }
}

}  // namespace
}  // namespace rtac::interp::test
