package robotran.ui.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.programs.ProgramReader
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.projects.ProjectRobot
import robotran.world.RobotLoad
import robotran.world.RobotPlace
import robotran.world.World

/**
 * Keeps the programs: what the pupil writes, and what came of reading it.
 *
 * @param onRead is told how far the programs were read.
 */
class ProgramsHolder(
    programs: List<PupilProgram>,
    private val bench: Bench,
    private val onRead: (ProgramReading) -> Unit,
) {
    private val reader = ProgramReader(PENBOT_CALIBRATION)
    private val shelf = ProgramShelf(programs.map { it.withPlainLineEnds() }, reader)
    private val readingLoop = ReadingLoop(shelf, ::showReading)

    var state: ProgramsState by mutableStateOf(firstState())
        private set

    private val editing = ProgramEditing(shelf, { state }, { state = it }) { bench.show(Pane.PROGRAM) }

    fun handle(event: ProgramEvent) {
        editing.handle(event)
        readingLoop.programsChanged()
        refresh()
    }

    /** All programs as they are written now, and what the brick's slots get of them. */
    internal val written: WrittenPrograms get() = WrittenPrograms(shelf.programs, shelf.slots.map { it != null })

    /** How many programs there are. */
    val count: Int get() = shelf.programs.size

    /** The programs as a project keeps them. */
    fun projectRobots(world: World): List<ProjectRobot> = listOf(ProjectRobot(world.robots.first().name, shelf.programs.map { it.asProject() }))

    /** What the robots of [world] are loaded with, the first with the programs as they were last read; Run starts that in [firstSlot]. */
    fun loads(world: World, firstSlot: Int): List<RobotLoad> =
        listOf(RobotLoad(shelf.slots, firstSlot)) + world.robots.drop(1).map { RobotLoad(listOfNotNull(ownProgram(it))) }

    /**
     * Whether the program in [slot] can run now; if it has mistakes, the first is pointed out, and if it was not read yet, it is being read from now
     * on, and [onRead] tells when that is done.
     */
    fun canStart(slot: Int): Boolean {
        if (!shelf.isRead(slot)) readingLoop.hurry()
        val possible = shelf.canRun(slot)
        if (!possible && shelf.isRead(slot)) {
            editing.pointOutMistakes(slot)
        }
        return possible
    }

    /** Whether the program in [slot] was read since it was changed. */
    fun isRead(slot: Int): Boolean = shelf.isRead(slot)

    /** Puts [programs] in place of all there are. */
    fun replaceAll(programs: List<PupilProgram>) {
        shelf.replaceAll(programs.map { it.withPlainLineEnds() })
        state = firstState()
        readingLoop.programsChanged()
    }

    /** Compiles Java programs in the pauses of typing, for ever. */
    suspend fun keepReading() = readingLoop.run()

    /** Reads all programs that were not read yet. */
    suspend fun readPrograms() = readingLoop.readAll()

    private fun ownProgram(robot: RobotPlace) = robot.program
        ?.let { reader.readNow(ProgramSource.Robolang("${robot.name}${ProgramLanguage.ROBOLANG.extension}", it)) as? ProgramResult.Ready }
        ?.program

    private fun showReading(reading: ProgramReading) {
        state = state.copy(reading = reading)
        refresh()
        onRead(reading)
    }

    private fun refresh() {
        state = state.copy(programs = shelf.programs, mistakes = shelf.mistakes(state.shownProgram))
    }

    private fun firstState() = ProgramsState(
        programs = shelf.programs,
        mistakes = shelf.mistakes(0),
        reading = if (shelf.hasUnread) ProgramReading.WAITING else ProgramReading.DONE,
    )
}

/** What the pupil has written and which of it can run: two of them are alike if nothing has changed between them. */
internal data class WrittenPrograms(val programs: List<PupilProgram>, val runnable: List<Boolean>)
