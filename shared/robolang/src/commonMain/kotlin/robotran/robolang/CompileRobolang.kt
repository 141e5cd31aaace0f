package robotran.robolang

import robotran.language.source.SourceRange
import robotran.robolang.check.Checker
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.ParsedText
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.parse

/**
 * Compiles a Robolang program: scans, parses and checks it, in time linear in its length. Never throws for any
 * [source].
 *
 * @param name the name shown to the pupil, usually the file name.
 * @param source the text of the program, with any line ends, with or without a byte order mark.
 * @param robot the robot that it will run on. A program whose header names another brick has a mistake.
 * @param messages the diagnostics in the pupil's language.
 * @param known a text that was read before; if it is [source], it is not read again.
 */
fun compileRobolang(
    name: String,
    source: String,
    robot: RobotTarget,
    messages: RobolangMessages,
    known: ParsedText? = null,
): RobolangResult {
    if (source.length > RobolangLimits.SOURCE_CHARACTERS) {
        val diagnostics = DiagnosticSink(messages, name)
        val start = SourceRange(line = 1, column = 1, endColumn = 1)
        diagnostics.report(
            DiagnosticCode.SOURCE_TOO_LONG,
            start,
            "",
            messages.sourceTooLong(RobolangLimits.SOURCE_CHARACTERS),
        )
        return RobolangResult.Failure(diagnostics.errorsInSourceOrder())
    }
    val parsed = known?.takeIf { it.isOf(source, robot.kind, messages) } ?: parse(source, robot.kind, messages)
    val diagnostics = parsed.diagnostics(name)
    val checked = Checker(robot, diagnostics).check(parsed.program)
    return if (diagnostics.isEmpty) {
        RobolangResult.Success(RobolangProgram.of(name, checked, robot, messages), diagnostics.warningsInSourceOrder())
    } else {
        RobolangResult.Failure(diagnostics.errorsInSourceOrder())
    }
}
