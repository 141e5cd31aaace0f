package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.brick.program.CallFrame
import robotran.brick.program.ProgramFailure
import robotran.brick.program.RuntimeWarning
import robotran.brick.state.BrickState
import robotran.brick.state.RunState
import robotran.simulation.state.MissingSensors

/**
 * What the last run says about the shown program. Empty once the program has changed, or if another one ran.
 *
 * @property runningLine the running line of the shown file, from 1; 0 if none is.
 * @property failure the error that ended the run, if it is in the shown file.
 * @property warnings warnings from the run, most important first.
 * @property missingSensors the sensors that one of the [warnings] is about; null if none is.
 * @property robot the name of the robot of the shown program.
 */
@Immutable
data class ShownProgramRun(
    val runningLine: Int = 0,
    val failure: ProgramFailure? = null,
    val warnings: List<RuntimeWarning> = emptyList(),
    val missingSensors: MissingSensors? = null,
    val robot: String = "",
) {
    companion object {
        fun of(programs: ProgramsState, run: RunPaneState): ShownProgramRun {
            val index = programs.robots.indexOfFirst { it.name == programs.shownRobot }
            val robot = run.session.robots.getOrNull(index) ?: return ShownProgramRun()
            val snippetOf = run.snippetOf.getOrNull(index)
            if (!isShown(snippetOf, robot.brick, programs, run)) return ShownProgramRun()
            val file = programs.file.name
            val now = robot.brick.run
            // A block of the palette that is tried is in no line of the program.
            val lines = programs.draft.lines.count
            val frame = run.frame.takeIf { index == run.watched }
            val line = (now as? RunState.Running)?.takeIf { run.lineIsLit }
                ?.let { lineIn(file, frame ?: CallFrame("", it.sourceLine, it.sourceFile)) }
            return ShownProgramRun(
                runningLine = line?.takeIf { it <= lines } ?: 0,
                failure = (now as? RunState.Failed)?.failure?.takeIf { it.isIn(file) && it.sourceLine <= lines },
                warnings = robot.warnings.filter { snippetOf == null || it.sourceLine <= lines },
                missingSensors = robot.missingSensors,
                robot = programs.shownRobot,
            )
        }

        private fun isShown(
            snippetOf: Snippet?,
            brick: BrickState,
            programs: ProgramsState,
            run: RunPaneState,
        ): Boolean = if (brick.isSnippet) {
            snippetOf?.slot == programs.shownProgram && snippetOf.source == programs.draft.text
        } else {
            !run.changed && brick.selectedSlot == programs.shownProgram
        }

        private fun lineIn(file: String, frame: CallFrame): Int? =
            frame.sourceLine.takeIf { (frame.sourceFile ?: file) == file }

        private fun ProgramFailure.isIn(file: String) = sourceLine > 0 && (sourceFile ?: file) == file
    }
}
