package robotran.workshop.send

import kotlinx.coroutines.withContext
import robotran.hublink.output.OutputReader
import robotran.hublink.output.SourceMap
import robotran.hublink.program.HubProgram
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.mpycompiler.MpyResult
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.support
import robotran.projects.target
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.python.PythonTranslation
import robotran.robolang.python.translateToPython
import robotran.robolang.python.withRunningLines
import robotran.robolang.robot.RobotTarget
import robotran.robolang.support.RobolangSupport
import robotran.workshop.service.Services

/** Makes of a pupil's program for the shown robot what its hub runs. */
internal class HubProgramBuilder(private val services: Services) {
    private val language get() = services.preferences.language

    /** Translates [program] to Python. What a hub cannot do is a mistake. */
    suspend fun translate(program: Program): HubTranslation {
        val target = services.current.shownRobot.description.target as? RobotTarget.Hub
        if (target == null || program.language.support != RobolangSupport) return refuse(program)
        return when (val read = compileRobolang(program.name, program.text, target, RobolangMessages.of(language))) {
            is RobolangResult.Failure -> HubTranslation.Failure(read.diagnostics)
            is RobolangResult.Success ->
                checked(read.program, translateToPython(read.program, target, PythonTranslationMessages.of(language)))
        }
    }

    private fun checked(program: RobolangProgram, python: PythonTranslation): HubTranslation {
        val name = program.name
        val lost = python.notes.filter { it.isLost }
        return if (lost.isEmpty()) {
            HubTranslation.Success(python, withRunningLines(program, python, OutputReader.MARK))
        } else {
            HubTranslation.Failure(lost.map { Diagnostic(Severity.ERROR, name, it.range, it.message) })
        }
    }

    /** A program in another language has a mistake that says so. */
    private suspend fun refuse(program: Program): HubTranslation {
        val compiler = ProgramCompiler(services.current.shownRobot.description.target, language = language)
        val result = compiler.compileOrThrow(program)
        return (result as? ProgramResult.Failure)?.let { HubTranslation.Failure(it.diagnostics) }
            ?: HubTranslation.NotForHubs
    }

    suspend fun compile(translation: PythonTranslation): HubBuildResult {
        val compiler = services.platform.mpyCompiler ?: return HubBuildResult.NoCompiler
        val compiled = withContext(services.platform.background) {
            compiler.compile(translation.fileName, translation.python)
        }
        return when (compiled) {
            is MpyResult.Success -> HubBuildResult.Success(HubProgram(compiled.mpy), sourceMapOf(translation))
            is MpyResult.Failure -> HubBuildResult.CompilerFailed
            MpyResult.NotLoaded -> HubBuildResult.NoCompiler
        }
    }
}

/** The result of translating a program for a hub. */
internal sealed interface HubTranslation {
    /**
     * @property python as it is shown and saved.
     * @property telling the same with what tells the app which line runs.
     */
    class Success(val python: PythonTranslation, val telling: PythonTranslation) : HubTranslation

    /** The program has mistakes, or is more than a hub can do. [diagnostics] are never empty. */
    class Failure(val diagnostics: List<Diagnostic>) : HubTranslation

    /** It is no program for a hub. */
    data object NotForHubs : HubTranslation
}

/** The result of compiling Python for a hub. */
internal sealed interface HubBuildResult {
    class Success(val program: HubProgram, val map: SourceMap) : HubBuildResult

    /** There is no compiler, or it could not be loaded. */
    data object NoCompiler : HubBuildResult

    /** The compiler did not take the Python because of a bug. */
    data object CompilerFailed : HubBuildResult
}
