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
 * The complete UI state, one part per pane.
 *
 * @property worldEdit null while the world is not being edited.
 * @property pane the pane shown on screens with room for only one.
 * @property taskShown whether the world's task is shown above the sheet.
 * @property notice the current message; null for none.
 * @property settingsShown whether the settings page is shown.
 * @property siteRequested whether that page opens at the base URL of links.
 * @property hasPage whether the app has its own base URL of links.
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
    val siteRequested: Boolean = false,
    val hasPage: Boolean = false,
) {
    val program: PupilProgram get() = programs.program
    val file: ProgramFile get() = programs.file
    val diagnostics: List<ProgramDiagnostic> get() = programs.diagnostics

    val programName: String get() = program.name

    /** The current text. */
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

    /** Whether the world has a task to show. A tutorial step shows the task itself. */
    val hasTask: Boolean get() = world.task.isNotBlank() && learning.tutorial?.isLoaded != true

    /** Whether the current program is unchanged since its run, and is the one that runs or ran last. */
    private val isShownInRun: Boolean get() = !changed && shownRobot?.brick?.selectedSlot == programs.shownProgram

    /** The session state of the robot whose programs are shown. */
    private val shownRobot: RobotSnapshot? get() = session.robots.getOrNull(
        programs.robots.indexOfFirst {
            it.name ==
                programs.shownRobot
        },
    )

    /** Warnings from the last run of the current program, most important first; empty once it has changed. */
    val remarks: List<RuntimeWarning> get() = shownRobot?.remarks?.takeIf { isShownInRun }.orEmpty()

    /** The running line of the current text; 0 if none is. */
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
     * The error that ended the last run of the current program, if it is in the current file; null once the program has
     * changed.
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
