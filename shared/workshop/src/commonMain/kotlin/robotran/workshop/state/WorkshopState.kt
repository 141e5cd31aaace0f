package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.programs.ProgramDiagnostic
import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.program.ProgramFailure
import robotran.rcxrom.program.RuntimeWarning
import robotran.rcxrom.state.RunState
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState
import robotran.world.World

/**
 * Everything the screen shows, one part for each pane.
 *
 * @property worldEdit null while the world is not changed.
 * @property pane what a screen with room for one pane shows.
 * @property taskShown whether what is to be done in the world is to be seen over the sheet.
 * @property notice what the app has to say, null if nothing.
 * @property settingsShown whether the page with the settings is shown.
 * @property siteWanted whether that page is to begin with the address of the site.
 * @property hasPage whether the app knows by itself where links lead to.
 */
@Immutable
data class WorkshopState(
    val programs: ProgramsState,
    val run: RunPaneState,
    val sheet: SheetViewState,
    val worldEdit: WorldEditState?,
    val document: DocumentState,
    val settings: Settings,
    val learning: LearningState,
    val pane: Pane,
    val taskShown: Boolean = false,
    val notice: Notice? = null,
    val settingsShown: Boolean = false,
    val siteWanted: Boolean = false,
    val hasPage: Boolean = false,
) {
    val program: PupilProgram get() = programs.program
    val file: ProgramFile get() = programs.file
    val diagnostics: List<ProgramDiagnostic> get() = programs.diagnostics

    /** What the program shown is called. */
    val programName: String get() = program.name

    /** The text that is shown. */
    val programText: String get() = file.text

    val world: World get() = run.world
    val session: SessionState get() = run.session
    val changed: Boolean get() = run.changed
    val down: Set<BrickButton> get() = run.down
    val untouched: Boolean get() = run.untouched
    val awake: Boolean get() = run.awake
    val running: Boolean get() = run.running
    val stoppable: Boolean get() = run.stoppable

    val soundOn: Boolean get() = settings.soundOn

    /** Whether there is something to be done in the world; in a step of the tutorial, that says it. */
    val hasTask: Boolean get() = world.task.isNotBlank() && learning.tutorial?.isOnDesk != true

    /** Whether the program shown is the one that runs or ran last, as it is written now. */
    private val isShownInRun: Boolean get() = !changed && shownRobot?.brick?.selectedSlot == programs.shownProgram

    /** The robot whose programs are shown, as it is in the session. */
    private val shownRobot: RobotSnapshot? get() = session.robots.getOrNull(
        programs.robots.indexOfFirst {
            it.name ==
                programs.shownRobot
        },
    )

    /**
     * What there is to learn from the last run of the program shown, the first thing first; empty once it has been
     * changed.
     */
    val remarks: List<RuntimeWarning> get() = shownRobot?.remarks?.takeIf { isShownInRun }.orEmpty()

    /** The line of the text shown that is running, 0 if none is. */
    val runningLine: Int
        get() {
            val now = shownRobot?.brick?.run as? RunState.Running ?: return 0
            return if (run.lineIsLit && isShownInRun &&
                (now.sourceFile ?: file.name) == file.name
            ) {
                now.sourceLine
            } else {
                0
            }
        }

    /**
     * Why the last run of the program shown could not go on, if that was in a line of the file that is shown; null once
     * it has been changed.
     */
    val failure: ProgramFailure?
        get() {
            val failure = (shownRobot?.brick?.run as? RunState.Failed)?.failure ?: return null
            val isHere = isShownInRun && failure.sourceLine > 0 && (failure.sourceFile ?: file.name) == file.name
            return failure.takeIf { isHere }
        }

    val status: WorkshopStatus
        get() = runStatus(session.brick.run).takeIf { running }
            ?: diagnostics.firstOrNull()?.let {
                WorkshopStatus.HasErrors(
                    it.range?.line ?: 0,
                    it.file.takeIf {
                        program.files.size >
                            1
                    },
                )
            }
            ?: WorkshopStatus.Empty.takeIf { program.isBlank }
            ?: WorkshopStatus.NoCompiler.takeIf { programs.reading == ProgramReading.NO_COMPILER }
            ?: WorkshopStatus.CompilerFailed.takeIf { programs.reading == ProgramReading.COMPILER_FAILED }
            ?: WorkshopStatus.Compiling.takeIf { programs.reading == ProgramReading.COMPILING }
            ?: WorkshopStatus.Off.takeIf { !session.brick.poweredOn }
            ?: WorkshopStatus.Changed.takeIf { changed }
            ?: runStatus(session.brick.run)

    private fun runStatus(now: RunState): WorkshopStatus = when (now) {
        RunState.Idle -> WorkshopStatus.Ready

        is RunState.Running -> if (run.isPaused) {
            WorkshopStatus.Paused(now.sourceLine)
        } else {
            WorkshopStatus.Running(now.sourceLine)
        }

        is RunState.Ended -> WorkshopStatus.Ended(now.stopped, GoalCount.of(session.goals))

        is RunState.Failed -> with(now.failure) { WorkshopStatus.Failed(sourceLine, message, sourceFile) }
    }
}
