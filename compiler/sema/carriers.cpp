// What moving zones move with.
#include "compiler/sema/fleets.h"
#include "compiler/sema/frames.h"
#include "compiler/sema/value.h"
#include "compiler/sema/zones.h"

namespace rtac::sema {
namespace {

class CarrierFinder {
 public:
  explicit CarrierFinder(Context& context) : context_(context) {}

  void find(ZoneId zone, const syntax::RobotRef& around) {
    const Symbol* symbol = context_.symbols.find(around.name.text);
    const bool is_robot =
        symbol != nullptr && (symbol->sort == Sort::robot || symbol->sort == Sort::fleet);
    is_robot ? robot(zone, around) : point(zone, around);
  }

 private:
  void robot(ZoneId zone, const syntax::RobotRef& around) {
    const auto found = resolve_robot(context_, around.name, around.number.get());
    // a kind that is not known was reported
    if (!found || index_of(context_.spec[*found].kind) >= context_.spec.kinds.size()) return;
    const bool in_space = context_.spec[context_.spec[*found].kind].in_space;
    if (context_.spec[zone].has_height && !in_space) {
      context_.report(Finding(Code::spaces_differ, around.range,
                              "a zone with height moves with a robot that moves in the plane")
                          .label("this robot has no height")
                          .help("let it move with an input of type `point3`, or with a robot whose "
                                "position is one"));
      return;
    }
    if (frames_agree(zone, around, map_frame)) context_.carriers.emplace(zone, *found);
  }

  void point(ZoneId zone, const syntax::RobotRef& around) {
    const auto found = context_.resolve<InputId>(around.name, Sort::input);
    if (!found || context_.faulty_inputs.count(*found) > 0) return;
    const ValueType& type = context_.input_types[index_of(*found)];
    const bool tall = context_.spec[zone].has_height;
    if (type.kind != TypeKind::point || type.space != tall || type.length || around.number) {
      context_.report(
          Finding(Code::wrong_argument, around.range,
                  (tall ? "a zone with height moves with a point of space, this is "
                        : "a zone moves with a point or a robot, this is ") +
                      (around.number ? "an element of an array" : describe(context_.spec, type)))
              .label(tall ? "not a point of space" : "not a point")
              .help(tall ? "write the name of an input of type `point3`"
                         : "write the name of an input of type `point`, or of a robot of a fleet"));
      return;
    }
    if (frames_agree(zone, around, type.frame)) context_.carriers.emplace(zone, *found);
  }

  bool frames_agree(ZoneId zone, const syntax::RobotRef& around, FrameId frame) {
    const FrameId due = context_.spec[zone].frame;
    if (frame == due) return true;
    report_frames(context_, around.range,
                  "the zone is in the frame `" + context_.spec[due].name +
                      "`, what it moves with in `" + context_.spec[frame].name + "`",
                  frame, due);
    return false;
  }

  Context& context_;
};

}  // namespace

void check_carriers(Context& context) {
  for (std::uint32_t i = 0; i < context.zones.size(); ++i) {
    const auto& around = context.zones[i].node->around;
    if (around) CarrierFinder(context).find(ZoneId{i}, *around);
  }
}

}  // namespace rtac::sema
