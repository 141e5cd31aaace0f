package robotran.cli.input

import robotran.brick.kind.BrickKind
import robotran.cli.files.ROBOLANG
import robotran.cli.files.TextFile
import robotran.cli.files.isNamed
import robotran.cli.files.readTextFile
import robotran.cli.messages.CommandMessages
import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.projects.penbotTarget
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.brickOfRobolang
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import kotlin.io.path.Path
import kotlin.io.path.name

/** The result of reading a Robolang file. */
internal sealed interface RobolangFile {
    /** The program can run. */
    data class Ready(
        val source: String,
        val program: RobolangProgram,
        val warnings: List<Diagnostic>,
        override val notes: List<String> = emptyList(),
    ) : RobolangFile

    data class HasErrors(val diagnostics: List<Diagnostic>, override val notes: List<String> = emptyList()) :
        RobolangFile

    /** The file cannot be read. [reason] is a sentence that names the file. */
    data class Unreadable(val reason: String) : RobolangFile

    /** How the file was read although it is unusual, in sentences. */
    val notes: List<String> get() = emptyList()
}

/**
 * Reads and checks the Robolang file [name] for the penbot with [brick].
 *
 * @param brick null for the one that the program names, otherwise an RCX.
 */
internal fun readRobolangFile(name: String, language: Language, brick: BrickKind? = null): RobolangFile =
    readRobolangFile(name, language) { (brick ?: brickOfRobolang(it) ?: BrickKind.default).penbotTarget }

/** Reads and checks the Robolang file [name] for the robot that [targetOf] gives for its text. */
internal fun readRobolangFile(name: String, language: Language, targetOf: (String) -> RobotTarget): RobolangFile =
    when (val file = readRobolangText(name, language)) {
        is TextFile.Failure -> RobolangFile.Unreadable(file.reason)

        is TextFile.Success -> {
            when (
                val result = compileRobolang(
                    Path(file.name).name,
                    file.text,
                    targetOf(file.text),
                    RobolangMessages.of(language),
                )
            ) {
                is RobolangResult.Success -> RobolangFile.Ready(
                    file.text,
                    result.program,
                    result.warnings,
                    file.notes,
                )
                is RobolangResult.Failure -> RobolangFile.HasErrors(result.diagnostics, file.notes)
            }
        }
    }

/** Reads the text of the Robolang file [name]. */
internal fun readRobolangText(name: String, language: Language): TextFile = if (isNamed(name, ROBOLANG)) {
    readTextFile(name, CommandMessages.of(language))
} else {
    TextFile.Failure(CommandMessages.of(language).notRobolang(name, ROBOLANG))
}
