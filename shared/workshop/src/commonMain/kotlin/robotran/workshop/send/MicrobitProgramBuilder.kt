package robotran.workshop.send

import robotran.microbit.model.MicrobitModel
import robotran.microbitlink.MicrobitBoard
import robotran.programs.Program
import robotran.robolang.python.PythonTranslation
import robotran.robolang.robot.RobotTarget
import robotran.workshop.service.Services

/** Translates a pupil's program for the board of the shown robot. What a board cannot do is a mistake. */
internal class MicrobitProgramBuilder(services: Services) : MicrobitPrograms {
    private val builder = PythonBuilder(services)

    override suspend fun build(program: Program): MicrobitTranslation {
        val target = builder.target as? RobotTarget.Microbit ?: return MicrobitTranslation.NotForBoards
        return when (val built = builder.build(program)) {
            is PythonBuild.Failure -> MicrobitTranslation.Failure(built.diagnostics)
            is PythonBuild.Success -> translationOf(built.python, target.model.board)
            PythonBuild.NoPython -> MicrobitTranslation.NotForBoards
        }
    }

    private fun translationOf(python: PythonTranslation, board: MicrobitBoard): MicrobitTranslation {
        val room = checkNotNull(python.room) { "It was translated for a board." }
        return MicrobitTranslation.Success(
            python.python,
            board,
            room.mostBytes,
            room.memoryShare,
            python.lineMap::sourceLineOf,
        )
    }
}

private val MicrobitModel.board
    get() = when (this) {
        MicrobitModel.V1 -> MicrobitBoard.V1
        MicrobitModel.V2 -> MicrobitBoard.V2
    }
