package robotran.workshop.state

import androidx.compose.runtime.Stable
import robotran.brick.controls.BrickButton
import robotran.brick.state.RunState
import robotran.language.source.Diagnostic
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.simulation.Breakpoint
import robotran.simulation.state.SessionState
import robotran.workshop.blocks.SheetPreview
import robotran.workshop.blocks.sheetPreview
import robotran.world.World
import robotran.world.robot.draftError

/**
 * The complete UI state, one part per pane. Each property reads the state of its room, which Compose observes: who reads
 * one part is drawn again for changes of that part alone.
 */
@Stable
interface WorkshopState {
    val programs: ProgramsState
    val run: RunPaneState
    val sheet: SheetViewState

    /** Null while the world is not being edited. */
    val worldEdit: WorldEditState?

    /** The robot in the workbench, which covers the world editor; null while it is closed. */
    val robotEdit: RobotEditState?
    val document: DocumentState
    val settings: Settings
    val learning: LearningState

    /** The pane shown on screens with room for only one. */
    val pane: Pane

    /** The pane that has the room of all others, on screens with room for several; null for none. */
    val fullPane: Pane?

    /** Whether the world's task is shown above the sheet. */
    val taskShown: Boolean

    /** Whether only one line of it is shown; an assignment remembers that itself. */
    val taskFolded: Boolean

    /** The current message; null for none. */
    val notice: Notice?

    /** Whether the settings page is shown. */
    val settingsShown: Boolean

    /** Whether that page opens at the base URL of links. */
    val siteRequested: Boolean

    /** The sheet that sends a program to a real RCX; null while it is closed. */
    val send: SendState?

    /** The sheet that sends a program to a real hub; null while it is closed. */
    val hubSend: HubSendState?

    /** The sheet that gets a program onto a micro:bit; null while it is closed. */
    val microbitSend: MicrobitSendState?

    /** The sheet with which pupils show what they made; null while it is closed. */
    val show: ExportState?

    /** The page on which a teacher looks at hand-ins; null while it is closed. */
    val handIns: HandInsState?

    /** The assignment that is open; null in a project like any other. */
    val assignment: AssignmentState?

    /** The sheet with which a pupil hands in; null while it is closed. */
    val handIn: HandInStep?

    /** The page that makes an assignment; null while it is closed. */
    val making: AssignmentEditorState?

    /** The courses on this device. */
    val course: CourseState

    /** Whether the app has its own base URL of links. */
    val hasPage: Boolean

    val program: Program get() = programs.program
    val file: SourceFile get() = programs.file
    val diagnostics: List<Diagnostic> get() = programs.diagnostics

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
    val hasTask: Boolean
        get() = (world.task.isNotBlank() || assignment != null) && learning.tutorial?.isLoaded != true

    /** What runs on a real hub is what is shown. */
    val shownProgramRun: ShownProgramRun
        get() = ShownProgramRun.of(programs, run).let { shown ->
            // A file or link may have brought another program meanwhile.
            val sent = hubSend?.takeIf { it.lines == programs.draft.text.lines() }
            sent?.runningLine?.let { shown.copy(runningLine = it) } ?: shown
        }

    /** What the number edited in the blocks would do, from where its robot stands; null while a program runs. */
    val sheetPreview: SheetPreview?
        get() {
            val blocks = programs.blocks?.takeIf { programs.view.hasBlocks && !running } ?: return null
            if (blocks.sheet == null) return null
            val robot = programs.robots.indexOfFirst { it.name == programs.shownRobot }
            return run.drawn.robots.getOrNull(robot)?.let { blocks.sheetPreview(it.robot.pose) }
        }

    /** The caret's line, for running up to it. */
    val caretLine: Breakpoint
        get() = Breakpoint(
            programs.draft.lines.lineOf(programs.draft.selection.caret) + 1,
            file.name.takeIf { program.files.size > 1 },
        )

    val status: WorkshopStatus
        get() = runStatus(run.brick.run).takeIf {
            running && !(diagnostics.isNotEmpty() && run.isPaused && run.isSolved)
        }
            ?: draftError(world)?.let(WorkshopStatus::RobotImpossible)
            ?: diagnostics.firstOrNull()?.let {
                WorkshopStatus.HasErrors(it.range?.line ?: 0, it.file.takeIf { program.files.size > 1 })
            }
            ?: WorkshopStatus.Empty.takeIf { program.isBlank }
            ?: WorkshopStatus.NoCompiler.takeIf { programs.compileStatus == CompileStatus.NO_COMPILER }
            ?: WorkshopStatus.CompilerFailed.takeIf { programs.compileStatus == CompileStatus.COMPILER_FAILED }
            ?: WorkshopStatus.Compiling.takeIf { programs.compileStatus == CompileStatus.COMPILING }
            ?: WorkshopStatus.Off.takeIf { !run.brick.poweredOn }
            ?: WorkshopStatus.Changed.takeIf { changed && !hasImmediateFailed }
            ?: runStatus(run.brick.run)

    private fun runStatus(now: RunState): WorkshopStatus = when (now) {
        RunState.Idle -> WorkshopStatus.Ready

        is RunState.Running -> {
            val line = lineOf(run.frame?.sourceLine ?: now.sourceLine)
            when {
                run.isPaused && run.isSolved && learning.elsewhere != null -> WorkshopStatus.SolvedHere

                run.isPaused && run.isSolved -> WorkshopStatus.Solved

                run.isPaused && run.isTimeUp && run.time == run.outcome.finished -> {
                    WorkshopStatus.TimeUp(run.world.timeLimit)
                }

                run.isPaused -> WorkshopStatus.Paused(line)

                else -> {
                    strayed?.let { WorkshopStatus.OffPaper(it.takeIf { world.robots.size > 1 }) }
                        ?: WorkshopStatus.Running(line)
                }
            }
        }

        is RunState.Ended -> {
            WorkshopStatus.Ended(now.stopped, if (isSnippet) GoalCount() else GoalCount.of(session.goals))
        }

        is RunState.Failed -> with(now.failure) { WorkshopStatus.Failed(lineOf(sourceLine), message, sourceFile) }
    }

    /** The name of a robot that has left the paper, if possible of the one that the status is about; null if none has. */
    private val strayed: String?
        get() = run.strayed.minByOrNull { if (it.robot == run.watched) -1 else it.robot }?.let {
            run.world.robots[it.robot].name
        }

    /** Whether the status is about a program that was sent to run at once. It is no attempt at the goals. */
    private val isSnippet: Boolean get() = run.brick.isSnippet

    private val hasImmediateFailed: Boolean get() = isSnippet && run.brick.run is RunState.Failed

    /** Such a program may have lines that the shown one does not have. */
    private fun lineOf(line: Int): Int = if (isSnippet) 0 else line
}
