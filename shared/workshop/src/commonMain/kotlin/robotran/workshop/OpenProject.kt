package robotran.workshop

import robotran.blockediting.BlockProgram
import robotran.documents.SavedBreakpoint
import robotran.programs.Program
import robotran.projects.Assignment
import robotran.projects.AssignmentTries
import robotran.projects.Project
import robotran.projects.ProjectSettings
import robotran.projects.repeatable
import robotran.projects.roomForPrograms
import robotran.simulation.RecordedInput
import robotran.simulation.state.SessionState
import robotran.workshop.learning.beginningIn
import robotran.workshop.learning.programsLeftBehind
import robotran.workshop.programs.ProgramsStateHolder
import robotran.workshop.run.RunStateHolder
import robotran.workshop.service.AssignmentRepository
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProjectEditor
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.RoomEvents
import robotran.world.RobotPlacement
import robotran.world.World

/**
 * The open project: world, assignment and settings are kept here; its programs and its run are asked for them. Publishes
 * each change.
 *
 * @param programsOf the programs, which are made after this.
 * @param runOf the run, likewise.
 */
internal class OpenProject(
    first: Project,
    private val events: RoomEvents,
    private val programsOf: () -> ProgramsStateHolder,
    private val runOf: () -> RunStateHolder,
) : CurrentProject,
    ProjectEditor,
    AssignmentRepository {
    private var opened = first
    private var measuredRoom: Pair<Project, Int>? = null
    private val programs get() = programsOf()
    private val run get() = runOf()

    override val world: World get() = opened.world
    override val project: Project get() = opened.copy(robots = programs.projectRobots(world), inputs = emptyList())

    override val replay: Project
        get() {
            val first = world.robots.map { it.name }.zip(run.startedPrograms).toMap()
            val files = run.filesAtStart
            val now = project
            val robots = now.robots.map {
                it.copy(firstProgram = first[it.name] ?: 0, files = files[it.name].orEmpty())
            }
            return now.copy(robots = robots, inputs = inputs.repeatable())
        }

    override val savedBreakpoints: List<SavedBreakpoint> get() = programs.savedBreakpoints
    override val shownProgram: Program get() = programs.shownProgram
    override val shownBlocks: BlockProgram? get() = programs.state.blocks?.program
    override val shownRobot: RobotPlacement get() = programs.state.robot
    override val session: SessionState get() = run.state.session

    /** The recorded inputs of the current session. */
    val inputs: List<RecordedInput> get() = run.inputs

    /** How many characters all programs may take in the project's file. The rest of the project is measured only once. */
    fun roomForPrograms(): Int {
        val known = measuredRoom?.takeIf { it.first === opened } ?: (opened to roomForPrograms(opened))
        measuredRoom = known
        return known.second
    }

    override fun openProject(project: Project) {
        events.publish(ProjectRoomEvent.Leaving(isAnother = true))
        opened = project
        events.publish(ProjectRoomEvent.Opened(project))
    }

    override fun restoreBreakpoints(breakpoints: List<SavedBreakpoint>) {
        programs.restoreBreakpoints(breakpoints)
        events.publish(ProgramRoomEvent.DebuggingChanged)
    }

    override fun changeWorld(world: World, isAnother: Boolean) {
        events.publish(ProjectRoomEvent.Leaving(isAnother))
        val before = run.state.world
        // An assignment belongs to its world.
        opened = if (isAnother) Project(world, opened.robots, opened.settings) else opened.copy(world = world)
        val hasNewTask = before.title != world.title || before.task != world.task
        val beginning = if (isAnother) beginningIn(world, shownProgram) else null
        events.publish(
            ProjectRoomEvent.WorldChanged(opened, isAnother, hasNewTask, programsLeftBehind(world), beginning),
        )
    }

    override fun saveWorld(world: World) {
        events.publish(ProjectRoomEvent.Leaving(isAnother = false))
        val before = opened.world.robots
        opened = opened.copy(world = world)
        // A robot with a new name would lose its programs.
        val isRenamed = before.size == world.robots.size && before.first().name != world.robots.first().name
        events.publish(ProjectRoomEvent.WorldSaved(world, isRenamed))
    }

    override fun changeAssignment(assignment: Assignment?) {
        opened = opened.copy(assignment = assignment)
        events.publish(ProjectRoomEvent.AssignmentChanged)
    }

    override fun saveTries(tries: AssignmentTries?) {
        opened = opened.copy(tries = tries)
        events.publish(ProjectRoomEvent.AssignmentChanged)
    }

    override fun changeProjectSettings(settings: ProjectSettings) {
        opened = opened.copy(settings = settings)
        events.publish(ProjectRoomEvent.RunSettingsChanged(opened))
    }
}
