package robotran.workshop.send

import kotlinx.coroutines.withContext
import robotran.hublink.output.OutputReader
import robotran.hublink.output.SourceMap
import robotran.hublink.program.HubProgram
import robotran.language.source.Diagnostic
import robotran.mpycompiler.MpyResult
import robotran.programs.Program
import robotran.robolang.python.PythonTranslation
import robotran.robolang.python.withRunningLines
import robotran.robolang.robot.RobotTarget
import robotran.workshop.service.Services

/** Makes of a pupil's program for the shown robot what its hub runs. */
internal class HubProgramBuilder(private val services: Services) {
    private val builder = PythonBuilder(services)

    /** Translates [program] to Python. What a hub cannot do is a mistake. */
    suspend fun translate(program: Program): HubTranslation {
        if (builder.target !is RobotTarget.Hub) return HubTranslation.NotForHubs
        return when (val built = builder.build(program)) {
            is PythonBuild.Failure -> HubTranslation.Failure(built.diagnostics)

            is PythonBuild.Success ->
                HubTranslation.Success(built.python, withRunningLines(built.program, built.python, OutputReader.MARK))

            PythonBuild.NoPython -> HubTranslation.NotForHubs
        }
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
