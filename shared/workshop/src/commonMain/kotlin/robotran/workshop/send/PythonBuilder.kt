package robotran.workshop.send

import robotran.language.source.Diagnostic
import robotran.language.source.Severity
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
import robotran.robolang.python.pythonOf
import robotran.robolang.robot.RobotTarget
import robotran.robolang.support.RobolangSupport
import robotran.workshop.service.Services

/** Translates a pupil's program for the shown robot to the Python that a hub or a board runs. */
internal class PythonBuilder(private val services: Services) {
    private val language get() = services.preferences.language

    /** That of the shown robot. */
    val target: RobotTarget get() = services.current.shownRobot.description.target

    /** Translates [program]. What the robot cannot do is a mistake, and so is a program in another language than Robolang. */
    suspend fun build(program: Program): PythonBuild {
        if (program.language.support != RobolangSupport) return refuse(program)
        return when (val read = compileRobolang(program.name, program.text, target, RobolangMessages.of(language))) {
            is RobolangResult.Failure -> PythonBuild.Failure(read.diagnostics)

            is RobolangResult.Success ->
                pythonOf(read.program, PythonTranslationMessages.of(language))?.let { checked(read.program, it) }
                    ?: refuse(program)
        }
    }

    private fun checked(program: RobolangProgram, python: PythonTranslation): PythonBuild {
        val lost = python.notes.filter { it.isLost }
        if (lost.isEmpty()) return PythonBuild.Success(program, python)
        return PythonBuild.Failure(lost.map { Diagnostic(Severity.ERROR, program.name, it.range, it.message) })
    }

    private suspend fun refuse(program: Program): PythonBuild {
        val result = ProgramCompiler(target, language = language).compileOrThrow(program)
        return (result as? ProgramResult.Failure)?.let { PythonBuild.Failure(it.diagnostics) } ?: PythonBuild.NoPython
    }
}

/** The result of translating a program to Python. */
internal sealed interface PythonBuild {
    class Success(val program: RobolangProgram, val python: PythonTranslation) : PythonBuild

    /** The program has mistakes, or is more than the robot can do. [diagnostics] are never empty. */
    class Failure(val diagnostics: List<Diagnostic>) : PythonBuild

    /** The program or the robot is none for Python. */
    data object NoPython : PythonBuild
}
