package robotran.cli.hub

import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.brick.kind.ProgramUpload
import robotran.cli.input.RobolangFile
import robotran.cli.input.lineOf
import robotran.cli.input.readRobolangFile
import robotran.cli.messages.CommandMessages
import robotran.console.ExitCode
import robotran.language.Language
import robotran.projects.penbotTarget
import robotran.projects.target
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.python.PythonNote
import robotran.robolang.python.PythonTranslation
import robotran.robolang.python.pythonOf
import robotran.robolang.robot.RobotTarget
import robotran.world.ReadyRobots

/** What a Robolang program becomes for a hub with Pybricks or a micro:bit. */
internal sealed interface PythonOfFile {
    /**
     * @property lost what the hub cannot do, one line each; the program leaves it out.
     * @property changed what it does nearly the same, one line each.
     */
    class Success(val translation: PythonTranslation, val lost: List<String>, val changed: List<String>) : PythonOfFile

    /** @property lines what is wrong, one line each. */
    class Failure(val lines: List<String>, val code: ExitCode) : PythonOfFile
}

/**
 * Translates the Robolang program [name] for a ready robot with [brick], which runs Python: the usual one, unless that lacks
 * what the program asks for and another has it.
 *
 * @param buggy what a micro:bit is plugged into; null for the usual one, and for other bricks.
 */
internal fun pythonOf(name: String, brick: BrickKind, language: Language, buggy: BuggyKind? = null): PythonOfFile {
    val robots = if (buggy == null) robotsWith(brick) else listOf(ReadyRobots.on(buggy, brick).target)
    val usual = pythonOf(name, robots.first(), language)
    if ((usual as? PythonOfFile.Success)?.lost.isNullOrEmpty()) return usual
    return robots.drop(1).asSequence().map { pythonOf(name, it, language) }
        .firstOrNull { it is PythonOfFile.Success && it.lost.isEmpty() } ?: usual
}

/** All ready robots with [brick]; of boards the usual one alone, for a program is for one buggy. */
private fun robotsWith(brick: BrickKind): List<RobotTarget> {
    val usual = brick.penbotTarget
    if (usual is RobotTarget.Microbit) return listOf(usual)
    return ReadyRobots.all.values.filter { it.brick == brick }.map { it.target }
}

private fun pythonOf(name: String, robot: RobotTarget, language: Language): PythonOfFile =
    when (val file = readRobolangFile(name, language) { robot }) {
        is RobolangFile.Unreadable -> PythonOfFile.Failure(listOf(file.reason), ExitCode.BAD_INPUT)

        is RobolangFile.HasErrors -> {
            PythonOfFile.Failure(file.notes + file.diagnostics.map { lineOf(name, it) }, ExitCode.PROGRAM_FAILED)
        }

        is RobolangFile.Ready -> {
            val python = pythonOf(file.program, PythonTranslationMessages.of(language))
            val translation = checkNotNull(python) { "Only robots that run Python get here." }
            val (lost, changed) = translation.notes.partition { it.isLost }
            val line = { note: PythonNote -> "$name:${note.range.line}:${note.range.column}: ${note.message}" }
            val warning = { note: PythonNote -> CommandMessages.of(language).warning(line(note)) }
            PythonOfFile.Success(translation, lost.map(line), file.notes + changed.map(warning))
        }
    }

/** Whether a robot with it runs Python, with Pybricks. */
internal val BrickKind.isHub: Boolean get() = programUpload == ProgramUpload.HUB

/** Whether a robot with it is a micro:bit, which runs MicroPython. */
internal val BrickKind.isBoard: Boolean get() = programUpload == ProgramUpload.MICROBIT
