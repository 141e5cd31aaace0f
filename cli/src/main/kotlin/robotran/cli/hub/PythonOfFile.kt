package robotran.cli.hub

import robotran.brick.kind.BrickKind
import robotran.cli.input.RobolangFile
import robotran.cli.input.lineOf
import robotran.cli.input.readRobolangFile
import robotran.cli.messages.CommandMessages
import robotran.console.ExitCode
import robotran.language.Language
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.python.PybricksHub
import robotran.robolang.python.PybricksRobot
import robotran.robolang.python.PythonNote
import robotran.robolang.python.PythonTranslation
import robotran.robolang.python.translateToPython

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

/** Translates the Robolang program [name] for the usual driving base with [hub]. */
internal fun pythonOf(name: String, hub: PybricksHub, language: Language): PythonOfFile =
    when (val file = readRobolangFile(name, language, LIKE_HUBS)) {
        is RobolangFile.Unreadable -> PythonOfFile.Failure(listOf(file.reason), ExitCode.BAD_INPUT)

        is RobolangFile.HasErrors -> {
            PythonOfFile.Failure(file.notes + file.diagnostics.map { lineOf(name, it) }, ExitCode.PROGRAM_FAILED)
        }

        is RobolangFile.Ready -> {
            val messages = PythonTranslationMessages.of(language)
            val translation = translateToPython(file.program, PybricksRobot.defaultFor(hub), messages)
            val (lost, changed) = translation.notes.partition { it.isLost }
            val line = { note: PythonNote -> "$name:${note.range.line}:${note.range.column}: ${note.message}" }
            val warning = { note: PythonNote -> CommandMessages.of(language).warning(line(note)) }
            PythonOfFile.Success(translation, lost.map(line), file.notes + changed.map(warning))
        }
    }

/** Hubs count the degrees of their motors and have the sensors of this brick, so its programs are theirs. */
private val LIKE_HUBS = BrickKind.entries.first { it.hasMotorCounters }
