#include "compiler/sema/frames.h"

#include "compiler/sema/suggest.h"

namespace rtac::sema {

std::optional<FrameId> frame_of(Context& context, const std::optional<syntax::Name>& written) {
  if (!written || written->text == context.spec[map_frame].name) return map_frame;
  const syntax::Name& name = *written;
  const Symbol* symbol = context.symbols.find(name.text);
  if (symbol != nullptr) return context.resolve<FrameId>(name, Sort::frame);
  if (!context.first_unknown(name)) return std::nullopt;
  std::vector<std::string> known = context.symbols.names_of(Sort::frame);
  known.push_back(context.spec[map_frame].name);
  Finding finding(Code::unknown_frame, name.range, "there is no frame `" + name.text + "`");
  finding.label("no frame has this name");
  if (const auto likely = nearest(name.text, known)) {
    finding.help("did you mean `" + *likely + "`?").replace(name.range, *likely);
  } else {
    finding.help("declare it: `frame " + name.text + ";`; there is " + listing(known));
  }
  context.report(finding);
  return std::nullopt;
}

void report_frames(Context& context, const SourceRange& range, const std::string& what,
                   FrameId given, FrameId due) {
  const std::string& here = context.spec[given].name;
  const std::string& there = context.spec[due].name;
  Finding finding(Code::frames_differ, range, what);
  finding.label("in the frame `" + here + "`, `" + there + "` is due")
      .help("bring it there: `transform(at, ...)` with `input at : pose of " + here +
            (due == map_frame ? "" : " @ " + there) + " ...`");
  context.report(finding);
}

}  // namespace rtac::sema
