package robotran.workshop.assignment

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.assignments.doing.HintsOfAssignment
import robotran.assignments.doing.NotAllowed
import robotran.assignments.doing.firstPrograms
import robotran.assignments.doing.notAllowedIn
import robotran.assignments.doing.with
import robotran.learning.Hint
import robotran.programs.Program
import robotran.projects.Assignment
import robotran.projects.AssignmentTries
import robotran.projects.BestTry
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.service.SchoolRoomEvent
import robotran.workshop.service.Services
import robotran.workshop.service.WindowRoomEvent
import robotran.workshop.service.WorldRoomEvent
import robotran.workshop.service.asProject
import robotran.workshop.service.asPupil
import robotran.workshop.state.AssignmentEditorState
import robotran.workshop.state.AssignmentState
import robotran.workshop.state.EndedAttempt
import robotran.workshop.state.HandInStep
import robotran.workshop.state.Notice

/** Holds what pupils do at an assignment, and what its author makes. */
class AssignmentStateHolder(private val services: Services, physics: PhysicsEngine) {
    private val current = services.current
    private val assignments = services.assignments
    private val tabs = services.tabs
    private val notices = services.notices
    private val memory = AssignmentMemory(services.platform.store, services.scope)
    private val runs = AssignmentRuns(services.platform, physics, services.preferences)
    private val maker = HandInMaker(services, runs, memory, ::refresh)
    private val author = AssignmentEditor(services, runs) { lastTry }
    private var hints: List<Hint> = emptyList()
    private var lastTry: EndedAttempt? = null

    /** The programs before they were begun again; null once that was undone, or others were written since. */
    private var replaced: List<Program>? = null
    private var checked: Checked? = null

    /** Whether the programs can be brought back that [AssignmentEvent.BegunAgain] has replaced. */
    internal val canUndoBeginning: Boolean get() = replaced != null

    /** Null in a project like any other. */
    var state: AssignmentState? by mutableStateOf(null)
        private set

    /** The sheet with which a pupil hands in; null while it is closed. */
    val handIn: HandInStep? get() = maker.step

    /** The page of the author; null while it is closed. */
    val making: AssignmentEditorState? get() = author.state

    /** Restores what this device remembers. */
    suspend fun start() {
        memory.load()
        rememberStart()
        refresh()
    }

    fun on(event: RoomEvent) {
        when (event) {
            is ProjectRoomEvent.Opened -> projectChanged()
            is ProjectRoomEvent.WorldChanged -> if (event.isAnother) projectChanged()
            is ProgramRoomEvent.Written -> programsChanged()
            is RunRoomEvent.Changed -> runChanged(event.ended)
            is WorldRoomEvent.EditorClosed -> worldEditorClosed(event.leadsBack)
            is ProjectRoomEvent.Leaving, is ProjectRoomEvent.WorldSaved, is ProjectRoomEvent.RunSettingsChanged,
            ProjectRoomEvent.AssignmentChanged, ProjectRoomEvent.Touched, ProgramRoomEvent.Chosen,
            ProgramRoomEvent.DebuggingChanged, ProgramRoomEvent.CompileBegun, is ProgramRoomEvent.Compiled,
            is ProgramRoomEvent.SnippetRequested, RunRoomEvent.Pressed, is RunRoomEvent.Started,
            is RunRoomEvent.PointShown, is RunRoomEvent.Told, WorldRoomEvent.Edited, is WorldRoomEvent.EditorRequested,
            WorldRoomEvent.EditorOpening, is WorldRoomEvent.RobotOpened, is SchoolRoomEvent, is WindowRoomEvent,
            -> Unit
        }
    }

    fun handle(event: AssignmentEvent) {
        when (event) {
            AssignmentEvent.BegunAgain -> beginAgain()
            AssignmentEvent.BeginningUndone -> undoBeginning()
            is AssignmentEvent.NotAllowedShown -> show(event.found)
            is AssignmentEvent.TaskFolded -> memory.fold(event.folded)
            is AssignmentEvent.OfHandIn -> state?.let { maker.handle(event, it) }
            is AssignmentEvent.OfAuthor -> author.handle(event)
        }
        refresh()
    }

    /** Called after another project was opened, or its world was replaced by another one. */
    private fun projectChanged() {
        maker.close()
        author.leave()
        hints = emptyList()
        lastTry = null
        replaced = null
        rememberStart()
        refresh()
    }

    /** Called after the programs have changed. */
    private fun programsChanged() {
        replaced = null
        if (state != null) refresh()
    }

    /** Called when the world editor was closed; [leadsBack] is false if its world is tried out now. */
    private fun worldEditorClosed(leadsBack: Boolean) {
        author.worldEditorClosed(leadsBack)
        refresh()
    }

    /** Called with each new state of the run; [ended] is the try that is over, the same object until that changes. */
    private fun runChanged(ended: EndedAttempt?) {
        if (ended == null || ended === lastTry) return
        val isNew = ended.number != lastTry?.number
        lastTry = ended
        val now = state?.takeIf { it.isOpenForTries } ?: return
        val programs = ended.programs.map { it.asProject().copy(view = null) }
        val best = BestTry(programs, ended.firstProgram, ended.inputs, ended.result, ended.percent)
        val tries = now.tries.with(best, isNew, now.assignment.start)
        if (tries != now.tries) assignments.saveTries(tries)
        hints = if (ended.result.isSolved) emptyList() else hintsAfter(now.assignment, ended, tries)
        refresh()
    }

    private fun hintsAfter(assignment: Assignment, ended: EndedAttempt, tries: AssignmentTries): List<Hint> {
        val program = ended.programs.getOrNull(ended.firstProgram) ?: ended.programs.first()
        val given = assignment.start.firstOrNull { it.name == program.name } ?: assignment.start.firstOrNull()
        return HintsOfAssignment(assignment, current.project.world).after(
            program.files.first().text,
            given?.files?.first()?.text.orEmpty(),
            ended.state,
            tries.tries,
        )
    }

    /** Waits until everything is stored. */
    suspend fun saveNow() = memory.saveNow()

    /** Ends whatever is under way. */
    fun close() {
        maker.close()
        author.leave()
    }

    /** Keeps what the pupil began with, before it is changed. */
    private fun rememberStart() {
        val project = current.project
        val assignment = project.assignment ?: return
        val isFresh = assignment.start.isEmpty() && assignment.checks == null && project.handIn == null
        if (isFresh) assignments.changeAssignment(assignment.copy(start = plain(project.firstPrograms)))
    }

    private fun beginAgain() {
        val start = state?.assignment?.start.orEmpty().ifEmpty { return }
        val before = current.project.firstPrograms.map { it.asPupil() }
        tabs.replacePrograms(start.map { it.asPupil() })
        replaced = before
        hints = emptyList()
        notices.show(Notice.BegunAgain)
    }

    private fun undoBeginning() {
        replaced?.let(tabs::replacePrograms)
    }

    private fun show(found: NotAllowed) {
        val index = current.project.firstPrograms.indexOfFirst { it.name == found.program }
        if (index >= 0) tabs.showLine(index, (found as? NotAllowed.HasWord)?.line ?: 1)
    }

    private fun refresh() {
        val now = stateOf(current.project)
        if (now != state) state = now
    }

    private fun stateOf(project: Project): AssignmentState? {
        val assignment = project.assignment ?: return null
        val seen = checked?.takeIf { it.assignment === assignment && it.programs == project.firstPrograms }
            ?: check(assignment, project.firstPrograms)
        checked = seen
        val isAuthor = assignment.checks != null
        return AssignmentState(
            assignment,
            project.tries ?: AssignmentTries(),
            isAuthor,
            hints,
            if (isAuthor || project.handIn != null) emptyList() else seen.found,
            canBeginAgain = !isAuthor && project.handIn == null && seen.isChanged,
            memory.handedInAs(assignment.id),
            project.handIn,
            project.feedback,
            memory.isTaskFolded,
        )
    }

    private fun check(assignment: Assignment, programs: List<ProjectProgram>): Checked {
        val open = plain(programs)
        val isChanged = assignment.start.isNotEmpty() && assignment.start != open
        return Checked(assignment, programs, notAllowedIn(assignment, open), isChanged)
    }

    private fun plain(programs: List<ProjectProgram>) = programs.map { it.copy(view = null) }

    private class Checked(
        val assignment: Assignment,
        val programs: List<ProjectProgram>,
        val found: List<NotAllowed>,
        val isChanged: Boolean,
    )
}
