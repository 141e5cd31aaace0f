package robotran.ui.workshop

import androidx.compose.runtime.Immutable
import robotran.programs.Mistake
import robotran.rom.Brick
import robotran.rom.BrickButton
import robotran.rom.ProgramRemark
import robotran.rom.RunState
import robotran.world.SessionState
import robotran.world.World

/**
 * Everything the screen shows.
 *
 * @property programs the pupil's programs in the order of the brick's slots; never empty.
 * @property shownProgram the one of [programs] that is shown, from 0.
 * @property shownFile the file of it that is shown, from 0.
 * @property closedProgram a program that was taken away and can be brought back.
 * @property mistakes what is wrong with the program shown, in its order.
 * @property reading how far the programs were read since they were changed.
 * @property changed whether [programs] differ from those in the brick.
 * @property mistakePointedOut whether somebody wanted to run a program with mistakes since it was last edited.
 * @property down the buttons of the brick that somebody holds; the brick itself may not have noticed them.
 * @property pane what a screen with room for one pane shows.
 * @property untouched true until a program is run for the first time.
 * @property awake whether time has to go on, because something moves, sounds or waits.
 * @property soundOn whether the brick's tones are to be heard.
 */
@Immutable
data class WorkshopState(
    val programs: List<PupilProgram>,
    val shownProgram: Int,
    val shownFile: Int,
    val closedProgram: PupilProgram?,
    val mistakes: List<Mistake>,
    val reading: ProgramReading,
    val changed: Boolean,
    val mistakePointedOut: Boolean,
    val world: World,
    val session: SessionState,
    val down: Set<BrickButton>,
    val pane: Pane,
    val untouched: Boolean,
    val awake: Boolean,
    val soundOn: Boolean,
) {
    val program: PupilProgram get() = programs[shownProgram]
    val file: ProgramFile get() = program.files[shownFile]

    /** What the program shown is called. */
    val programName: String get() = program.name

    /** The text that is shown. */
    val programText: String get() = file.text

    /** What there is to learn from the last run of the program shown, the first thing first; empty once it has been changed. */
    val remarks: List<ProgramRemark> get() = if (changed || session.brick.selectedSlot != shownProgram) emptyList() else session.remarks

    /** Whether there is anything to stop: a program that runs, or that shows why it cannot go on. */
    val stoppable: Boolean get() = running || (session.brick.run is RunState.Failed && session.brick.explanation != null)

    val running: Boolean get() = session.brick.run is RunState.Running

    /** Whether the brick has a slot for one more program. */
    val hasRoom: Boolean get() = programs.size < Brick.MOST_PROGRAMS

    /** The line of the text shown that is running, 0 if none is. */
    val runningLine: Int
        get() {
            val run = session.brick.run as? RunState.Running ?: return 0
            val isShown = !changed && session.brick.selectedSlot == shownProgram && (run.sourceFile ?: file.name) == file.name
            return if (isShown) run.sourceLine else 0
        }

    val status: WorkshopStatus
        get() = runStatus(session.brick.run).takeIf { running }
            ?: mistakes.firstOrNull()?.let { WorkshopStatus.Mistaken(it.range?.line ?: 0, it.file.takeIf { program.files.size > 1 }) }
            ?: WorkshopStatus.Empty.takeIf { program.isBlank }
            ?: WorkshopStatus.NoCompiler.takeIf { reading == ProgramReading.NO_COMPILER }
            ?: WorkshopStatus.Compiling.takeIf { reading == ProgramReading.COMPILING }
            ?: WorkshopStatus.Off.takeIf { !session.brick.poweredOn }
            ?: WorkshopStatus.Changed.takeIf { changed }
            ?: runStatus(session.brick.run)

    private fun runStatus(run: RunState): WorkshopStatus = when (run) {
        RunState.Idle -> WorkshopStatus.Ready
        is RunState.Running -> WorkshopStatus.Running(run.sourceLine)
        is RunState.Ended -> WorkshopStatus.Ended(run.stopped)
        is RunState.Failed -> with(run.failure) { WorkshopStatus.Failed(sourceLine, message, sourceFile) }
    }
}

/** How far programs were read since they were changed. */
enum class ProgramReading {
    /** All of them. */
    DONE,

    /** A Java program waits for a pause in the typing. */
    WAITING,

    /** The compiler is fetched or at work, and somebody waits for it. */
    COMPILING,

    /** The compiler could not be fetched; Run tries again. */
    NO_COMPILER,
}
