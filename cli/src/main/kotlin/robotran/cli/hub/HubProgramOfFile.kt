package robotran.cli.hub

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.console.ExitCode
import robotran.hublink.program.HubProgram
import robotran.hublink.sentences.sentence
import robotran.language.Language
import robotran.mpycompiler.JvmMpyCompiler
import robotran.mpycompiler.MpyResult

/** What a hub runs of a Robolang program. */
internal sealed interface HubProgramOfFile {
    /**
     * @property python what was compiled.
     * @property warnings what the hub does nearly the same, one line each.
     */
    class Success(val program: HubProgram, val python: String, val warnings: List<String>) : HubProgramOfFile

    /** @property lines what is wrong, one line each. */
    class Failure(val lines: List<String>, val code: ExitCode) : HubProgramOfFile
}

/** Compiles the Robolang program [name] for a robot with [brick], a hub. What the hub cannot do is a mistake. */
internal fun hubProgramOf(name: String, brick: BrickKind, language: Language): HubProgramOfFile {
    val python = when (val translated = pythonOf(name, brick, language)) {
        is PythonOfFile.Failure -> return HubProgramOfFile.Failure(translated.lines, translated.code)
        is PythonOfFile.Success -> translated
    }
    if (python.lost.isNotEmpty()) return HubProgramOfFile.Failure(python.lost, ExitCode.PROGRAM_FAILED)
    val translation = python.translation
    return when (val compiled = runBlocking { JvmMpyCompiler().compile(translation.fileName, translation.python) }) {
        is MpyResult.Failure -> {
            val line = compiled.line?.let(translation.lineMap::sourceLineOf)?.let { ":$it" }.orEmpty()
            HubProgramOfFile.Failure(listOf("$name$line: ${compiled.message}"), ExitCode.PROGRAM_FAILED)
        }

        MpyResult.NotLoaded -> error("The command line has the compiler with it.")

        is MpyResult.Success -> {
            val program = HubProgram(compiled.mpy)
            when (val mistake = program.mistake()) {
                null -> HubProgramOfFile.Success(program, translation.python, python.changed)
                else -> HubProgramOfFile.Failure(
                    listOf("$name: ${mistake.sentence(language)}"),
                    ExitCode.PROGRAM_FAILED,
                )
            }
        }
    }
}
