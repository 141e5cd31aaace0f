package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.rcxrom.program.ProgramFailure
import robotran.rcxrom.program.RuntimeWarning
import robotran.rcxrom.state.RunState
import robotran.simulation.state.RobotSnapshot

/**
 * What the last run says about the shown program. Empty once the program has changed, or if another one ran.
 *
 * @property runningLine the running line of the shown file, from 1; 0 if none is.
 * @property failure the error that ended the run, if it is in the shown file.
 * @property remarks warnings from the run, most important first.
 */
@Immutable
data class ShownProgramRun(
    val runningLine: Int = 0,
    val failure: ProgramFailure? = null,
    val remarks: List<RuntimeWarning> = emptyList(),
) {
    companion object {
        fun of(programs: ProgramsState, run: RunPaneState): ShownProgramRun {
            val robot = shownRobot(programs, run) ?: return ShownProgramRun()
            if (run.changed || robot.brick.selectedSlot != programs.shownProgram) return ShownProgramRun()
            val file = programs.file.name
            val now = robot.brick.run
            return ShownProgramRun(
                runningLine = (now as? RunState.Running)?.takeIf { run.lineIsLit }?.lineIn(file) ?: 0,
                failure = (now as? RunState.Failed)?.failure?.takeIf { it.isIn(file) },
                remarks = robot.remarks,
            )
        }

        private fun shownRobot(programs: ProgramsState, run: RunPaneState): RobotSnapshot? =
            run.session.robots.getOrNull(programs.robots.indexOfFirst { it.name == programs.shownRobot })

        private fun RunState.Running.lineIn(file: String): Int? = sourceLine.takeIf { (sourceFile ?: file) == file }

        private fun ProgramFailure.isIn(file: String) = sourceLine > 0 && (sourceFile ?: file) == file
    }
}
