package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.programs.ProgramDiagnostic
import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.state.RunState
import robotran.simulation.Breakpoint
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
 * @property send the sheet that sends a program to a real robot; null while it is closed.
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
    val send: SendState? = null,
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

    val shownProgramRun: ShownProgramRun get() = ShownProgramRun.of(programs, run)

    /** The caret's line, for running up to it. */
    val caretLine: Breakpoint
        get() = Breakpoint(
            programs.draft.lines.lineOf(programs.draft.selection.caret) + 1,
            file.name.takeIf { program.files.size > 1 },
        )

    val status: WorkshopStatus
        get() = runStatus(session.brick.run).takeIf { running }
            ?: diagnostics.firstOrNull()?.let {
                WorkshopStatus.HasErrors(it.range?.line ?: 0, it.file.takeIf { program.files.size > 1 })
            }
            ?: WorkshopStatus.Empty.takeIf { program.isBlank }
            ?: WorkshopStatus.NoCompiler.takeIf { programs.compileStatus == CompileStatus.NO_COMPILER }
            ?: WorkshopStatus.CompilerFailed.takeIf { programs.compileStatus == CompileStatus.COMPILER_FAILED }
            ?: WorkshopStatus.Compiling.takeIf { programs.compileStatus == CompileStatus.COMPILING }
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
