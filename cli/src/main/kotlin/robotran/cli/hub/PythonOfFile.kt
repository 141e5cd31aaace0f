package robotran.cli.hub

import robotran.brick.kind.BrickKind
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
import robotran.robolang.python.translateToPython
import robotran.robolang.robot.RobotTarget
import robotran.world.ReadyRobots

/** What a Robolang program becomes for a hub with Pybricks. */
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
 * Translates the Robolang program [name] for a ready robot with [brick], a hub: the usual one, unless that lacks what the
 * program asks for and another has it.
 */
internal fun pythonOf(name: String, brick: BrickKind, language: Language): PythonOfFile {
    val robots = ReadyRobots.all.values.filter { it.brick == brick }.map { it.target as RobotTarget.Hub }
    val usual = pythonOf(name, robots.first(), language)
    if ((usual as? PythonOfFile.Success)?.lost.isNullOrEmpty()) return usual
    return robots.drop(1).asSequence().map { pythonOf(name, it, language) }
        .firstOrNull { it is PythonOfFile.Success && it.lost.isEmpty() } ?: usual
}

private fun pythonOf(name: String, robot: RobotTarget.Hub, language: Language): PythonOfFile =
    when (val file = readRobolangFile(name, language) { robot }) {
        is RobolangFile.Unreadable -> PythonOfFile.Failure(listOf(file.reason), ExitCode.BAD_INPUT)

        is RobolangFile.HasErrors -> {
            PythonOfFile.Failure(file.notes + file.diagnostics.map { lineOf(name, it) }, ExitCode.PROGRAM_FAILED)
        }

        is RobolangFile.Ready -> {
            val translation = translateToPython(file.program, robot, PythonTranslationMessages.of(language))
            val (lost, changed) = translation.notes.partition { it.isLost }
            val line = { note: PythonNote -> "$name:${note.range.line}:${note.range.column}: ${note.message}" }
            val warning = { note: PythonNote -> CommandMessages.of(language).warning(line(note)) }
            PythonOfFile.Success(translation, lost.map(line), file.notes + changed.map(warning))
        }
    }

/** Whether a robot with it runs Python, with Pybricks. */
internal val BrickKind.isHub: Boolean get() = penbotTarget is RobotTarget.Hub
