package robotran.workshop.send

import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.microbit.model.MicrobitModel
import robotran.microbitlink.MicrobitBoard
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.support
import robotran.projects.target
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.python.PythonTranslation
import robotran.robolang.python.translateToPython
import robotran.robolang.robot.RobotTarget
import robotran.robolang.support.RobolangSupport
import robotran.workshop.service.Services

/** Translates a pupil's program for the board of the shown robot. What a board cannot do is a mistake. */
internal class MicrobitProgramBuilder(private val services: Services) : MicrobitPrograms {
    private val language get() = services.preferences.language

    override suspend fun build(program: Program): MicrobitTranslation {
        val target = services.current.shownRobot.description.target as? RobotTarget.Microbit
        if (target == null || program.language.support != RobolangSupport) return refuse(program)
        return when (val read = compileRobolang(program.name, program.text, target, RobolangMessages.of(language))) {
            is RobolangResult.Failure -> MicrobitTranslation.Failure(read.diagnostics)

            is RobolangResult.Success -> {
                val python = translateToPython(read.program, target, PythonTranslationMessages.of(language))
                checked(program.name, python, target.model.board)
            }
        }
    }

    private fun checked(name: String, python: PythonTranslation, board: MicrobitBoard): MicrobitTranslation {
        val lost = python.notes.filter { it.isLost }
        return if (lost.isEmpty()) {
            val room = checkNotNull(python.room) { "It was translated for a board." }
            MicrobitTranslation.Success(
                python.python,
                board,
                room.mostBytes,
                room.memoryShare,
                python.lineMap::sourceLineOf,
            )
        } else {
            MicrobitTranslation.Failure(lost.map { Diagnostic(Severity.ERROR, name, it.range, it.message) })
        }
    }

    /** A program in another language has a mistake that says so. */
    private suspend fun refuse(program: Program): MicrobitTranslation {
        val compiler = ProgramCompiler(services.current.shownRobot.description.target, language = language)
        val result = compiler.compileOrThrow(program)
        return (result as? ProgramResult.Failure)?.let { MicrobitTranslation.Failure(it.diagnostics) }
            ?: MicrobitTranslation.NotForBoards
    }
}

private val MicrobitModel.board
    get() = when (this) {
        MicrobitModel.V1 -> MicrobitBoard.V1
        MicrobitModel.V2 -> MicrobitBoard.V2
    }
