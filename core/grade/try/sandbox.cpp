// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/sandbox.h"

#include "core/grade/try/programcommand.h"

namespace pixelplumb {

namespace {

QString triedLack()
{
    if (bubblewrapPath().isEmpty())
        return u"bubblewrap (bwrap) is not installed"_s;
    const StudentProgram nothing{u"/bin/true"_s, {}, {}};
    const StudentRun run = runProgram(nothing, {}, {}, {}, Confinement::Sandbox);
    return run.end == ProgramEnd::Finished ? QString() : run.told;
}

} // namespace

const QString &sandboxLack()
{
    static const QString lack = triedLack();
    return lack;
}

Confinement bestConfinement()
{
    return sandboxLack().isEmpty() ? Confinement::Sandbox : Confinement::LimitsAlone;
}

QString unsandboxedText(const QString &lack)
{
    return u"no sandbox (%1): time, memory and output were limited, but a program "
           "could use the network, read and change files, and end processes, as "
           "far as the user may as whom it ran"_s.arg(lack);
}

} // namespace pixelplumb
