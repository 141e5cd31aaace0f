package robotran.workshop.programs

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.language.Language
import robotran.programs.CompilerLoading
import robotran.programs.JavaSettings
import robotran.programs.ProgramCompiler
import robotran.projects.PENBOT_CALIBRATION
import robotran.projects.Project
import robotran.projects.ProjectLimits
import robotran.projects.ProjectRobot
import robotran.simulation.Breakpoint
import robotran.simulation.RobotLoad
import robotran.workshop.event.ProgramEvent
import robotran.workshop.examples.firstProgram
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.service.ScreenNavigator
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.ProgramReading
import robotran.workshop.state.ProgramsState
import robotran.workshop.state.PupilProgram
import robotran.world.World

/**
 * Keeps the programs of all robots of a world: what the pupil writes, and what came of reading it.
 *
 * @param project what is there to begin with; its first robot gets the square if it has been given nothing.
 * @param onRead is told how far the programs were read.
 */
class ProgramsStateHolder(
    project: Project,
    private val preferences: Preferences,
    private val navigator: ScreenNavigator,
    private val notices: Notices,
    private val onRead: (ProgramReading) -> Unit,
) {
    private var reader = ProgramCompiler(PENBOT_CALIBRATION, project.settings.java, preferences.language)
    private var robots = robotsOf(project)
    private var shownRobot = robots.first().place.name
    private var translationShown = false
    private var findingWanted = false
    private val shown: RobotPrograms get() = robots.firstOrNull { it.place.name == shownRobot } ?: robots.first()
    private val readingLoop = CompileScheduler(
        { robots.any { it.shelf.hasUnread } },
        ::readUnread,
        { robots.sumOf { it.shelf.unreadCharacters } },
        ::showReading,
    )
    private val editing = ProgramEditing({ shown }, ::sayTooLong, ::sayFixGone) { navigator.show(Pane.PROGRAM) }
    private var reading = if (robots.any { it.shelf.hasUnread }) ProgramReading.WAITING else ProgramReading.DONE

    var state: ProgramsState by mutableStateOf(stateNow())
        private set

    fun handle(event: ProgramEvent) {
        if (event is ProgramEvent.RobotChosen) shownRobot = event.name
        if (event is ProgramEvent.TranslationShown) translationShown = event.shown
        if (event == ProgramEvent.FindingRequested ||
            event == ProgramEvent.FindingBegun
        ) {
            return want(event == ProgramEvent.FindingRequested)
        }
        editing.handle(event)
        readingLoop.programsChanged()
        if (editing.waitsForReading) readingLoop.hurry()
        refresh()
    }

    /** All programs as they are written now, and what the bricks' slots get of them. */
    internal val written: WrittenPrograms
        get() = WrittenPrograms(
            robots.map { it.shelf.programs },
            robots.map { robot ->
                robot.shelf.slots.map {
                    it !=
                        null
                }
            },
        )

    /** How many programs the first robot has. */
    val count: Int get() = robots.first().shelf.entries.size

    /** The slot of the first robot's program that Run in the run bar starts: the one that was shown last. */
    val slotToRun: Int get() = robots.first().shownProgram

    /** The programs of all robots of [world] as a project keeps them. */
    fun projectRobots(world: World): List<ProjectRobot> =
        robots.filter { robot -> world.robots.any { it.name == robot.place.name } }.mapNotNull { it.asProject() }

    /**
     * The slots whose programs Run in the run bar starts: [first] of the first robot, and of the others what was shown
     * last.
     */
    fun slotsBeginning(first: Int): List<Int> = starting(first).map { it.second }

    /**
     * What the robots of [world] are loaded with, as the programs were last read; Run starts the programs in
     * [firstSlots], robot by robot.
     */
    fun loads(world: World, firstSlots: List<Int>): List<RobotLoad> = world.robots.mapIndexed { index, place ->
        robots.firstOrNull { it.place.name == place.name }?.load(firstSlots.getOrElse(index) { 0 })
            ?: RobotLoad(emptyList())
    }

    /** Where the program in [slot] of the robot called [robot] is to stop. */
    fun breakpoints(robot: String, slot: Int): Set<Breakpoint> =
        robots.firstOrNull { it.place.name == robot }?.breakpoints(slot).orEmpty()

    /**
     * Whether the program in [slot] of the first robot, and those of the others, can run now; if one has mistakes, the
     * first is pointed out, and if one was not read yet, it is being read from now on, and [onRead] tells when that is
     * done.
     */
    fun canStart(slot: Int): Boolean {
        if (!isRead(slot)) readingLoop.hurry()
        if (!isRead(slot)) return false
        val mistaken =
            starting(slot).firstOrNull { (robot, itsSlot) -> robot.isNeeded() && !robot.shelf.canRun(itsSlot) }
                ?: return true
        shownRobot = mistaken.first.place.name
        editing.pointOutMistakes(mistaken.first, mistaken.second)
        refresh()
        return false
    }

    /** Whether the program in [slot] of the first robot, and those of the others, were read since they were changed. */
    fun isRead(slot: Int): Boolean = starting(slot).all { (robot, itsSlot) -> robot.shelf.isRead(itsSlot) }

    /**
     * Shows the file [name] of the program in [slot] of the robot called [robot], if it is that program that is shown.
     */
    internal fun showFile(robot: String, slot: Int, name: String) {
        if (shown.place.name != robot || shown.shownProgram != slot) return
        val place = shown.entry.program.files.indexOfFirst { it.name == name }
        if (place < 0 || place == shown.shownFile) return
        shown.shownFile = place
        refresh()
    }

    /** Puts the programs of [project] in place of all there are. */
    fun open(project: Project) {
        reader = reader.running(project.settings.java)
        robots = robotsOf(project)
        shownRobot = robots.first().place.name
        reading = if (robots.any { it.shelf.hasUnread }) ProgramReading.WAITING else ProgramReading.DONE
        readingLoop.programsChanged()
        refresh()
    }

    /** The robots are those of [world] now: each keeps its programs, and the first those of the first. */
    fun worldChanged(world: World) {
        val before = robots
        robots = world.robots.mapIndexed { index, place ->
            val known = before.firstOrNull { it.place.name == place.name } ?: before.first().takeIf { index == 0 }
            known?.movedTo(place) ?: RobotPrograms(place, ProjectRobot(place.name), reader, emptyList())
        }
        if (robots.none { it.place.name == shownRobot }) shownRobot = robots.first().place.name
        refresh()
    }

    /** Reads all programs again, to tell what is wrong with them in [language]. */
    fun speak(language: Language) = readBy(reader.telling(language))

    /** Reads all programs again, to run Java as [java] says. */
    fun runJava(java: JavaSettings) = readBy(reader.running(java))

    private fun readBy(next: ProgramCompiler) {
        if (next === reader) return
        reader = next
        robots = robots.map { it.readBy(reader) }
        reading = if (robots.any { it.shelf.hasUnread }) ProgramReading.WAITING else ProgramReading.DONE
        readingLoop.programsChanged()
        refresh()
    }

    /** Compiles Java programs in the pauses of typing, for ever. */
    suspend fun keepReading() = readingLoop.run()

    /** Reads all programs that were not read yet. */
    suspend fun readPrograms() = readingLoop.readAll()

    private suspend fun readUnread(): CompilerLoading {
        for (robot in robots) {
            val loading = robot.shelf.readUnread()
            if (loading is CompilerLoading.Failed) return loading
        }
        return CompilerLoading.Loaded
    }

    private fun starting(slot: Int): List<Pair<RobotPrograms, Int>> =
        robots.mapIndexed { index, robot -> robot to if (index == 0) slot else robot.shownProgram }

    /** A robot that nobody has given a program only stands there. */
    private fun RobotPrograms.isNeeded() = this === robots.first() || !isBlank

    private fun robotsOf(project: Project): List<RobotPrograms> = project.world.robots.mapIndexed { index, place ->
        val kept = project.robots.firstOrNull { it.name == place.name } ?: ProjectRobot(place.name)
        val programs = kept.programs.map { it.asPupil() }
        val isAlone = index == 0 && programs.isEmpty() && place.program == null
        RobotPrograms(place, kept, reader, if (isAlone) listOf(firstProgram()) else programs)
    }

    private fun sayTooLong() {
        // In thousands: every language writes longer numbers in its own way.
        notices.say(
            Notice.ProgramTooLong(
                ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS / THOUSAND,
                ProjectLimits.MAXIMUM_LINES / THOUSAND,
            ),
        )
    }

    private fun sayFixGone() = notices.say(Notice.FixOutdated)

    private fun want(finding: Boolean) {
        findingWanted = finding
        if (finding) navigator.show(Pane.PROGRAM)
        refresh()
    }

    private fun showReading(reading: ProgramReading) {
        this.reading = reading
        if (reading.isOver) editing.programsRead()
        refresh()
        onRead(reading)
        // What waited for it may have changed a program.
        if (reading == ProgramReading.DONE) readingLoop.programsChanged()
    }

    private fun refresh() {
        state = stateNow()
    }

    private fun stateNow(): ProgramsState {
        val robot = shown
        val entry = robot.entry
        return ProgramsState(
            robots = robots.map { it.place },
            shownRobot = robot.place.name,
            isWorldsOwn = robot.isUntouched && !robot.isBlank,
            programs = robot.shelf.programs,
            shownProgram = robot.shownProgram,
            shownFile = robot.shownFile,
            draft = robot.memory.draft,
            canUndo = robot.memory.history.canUndo,
            canRedo = robot.memory.history.canRedo,
            breakpoints = robot.memory.breakpoints,
            closed = robot.closed?.name,
            closedShown = robot.closedShown,
            canReopen = robot.canReopen,
            diagnostics = entry.diagnostics,
            notes = entry.notes,
            reading = reading,
            mistakePointedOut = editing.mistakePointedOut,
            translationShown = translationShown,
            translation = if (translationShown) entry.translation else null,
            isTranslated = entry.isTranslated,
            findingWanted = findingWanted,
        )
    }
}

private const val THOUSAND = 1_000

/**
 * What the pupil has written and which of it can run, robot by robot: two of them are alike if nothing has changed
 * between them.
 */
internal data class WrittenPrograms(val programs: List<List<PupilProgram>>, val runnable: List<List<Boolean>>)
