package robotran.workshop.programs

import robotran.language.ProgramLanguage
import robotran.programs.ProgramCompiler
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.lightFacingOf
import robotran.rcxrom.Brick
import robotran.simulation.Breakpoint
import robotran.simulation.RobotLoad
import robotran.workshop.state.PupilProgram
import robotran.workshop.state.withPlainLineEnds
import robotran.world.RobotPlacement

/**
 * The programs of one robot: the pupil's programs or, until they are edited, the world's program for it.
 *
 * @property place the robot in its world.
 * @param kept its programs in the project.
 */
internal class RobotPrograms(
    val place: RobotPlacement,
    private val kept: ProjectRobot,
    private val reader: ProgramCompiler,
    first: List<PupilProgram>,
) {
    private val given: PupilProgram = worldProgramOf(place)

    val shelf = ProgramList((first.ifEmpty { listOf(given) }).map { it.withPlainLineEnds() }, reader)
    var shownProgram = kept.firstProgram.coerceIn(shelf.entries.indices)
    var shownFile = 0
    var closed: ClosedFile? = null
        set(value) {
            field = value
            closedMessageShown = value != null
        }

    /** Whether the message about the last removed file is shown. */
    var closedMessageShown = false

    val entry: ProgramBuffer get() = shelf.entries[shownProgram]
    val memory: ProgramFileMemory get() = entry.memories[shownFile]

    /** Whether there is room to restore the last removed file. */
    val canReopen: Boolean
        get() = when (val closed = closed) {
            null -> false
            is ClosedFile.Program -> shelf.entries.size < Brick.MAX_PROGRAMS
            is ClosedFile.OfProgram -> shelf.entries[closed.slot].program.files.none { it.name == closed.name }
        }

    /** Whether the pupil has changed nothing, so that it has the world's program. */
    val isUntouched: Boolean get() = shelf.programs == listOf(given)

    /** Whether all its programs are blank. */
    val isBlank: Boolean get() = shelf.programs.all { it.isBlank }

    /** The robot as stored in a project; null if there is nothing to store. */
    fun asProject(): ProjectRobot? {
        val written: List<ProjectProgram> = if (isUntouched) emptyList() else shelf.programs.map { it.asProject() }
        return kept.copy(programs = written, firstProgram = kept.firstProgram.coerceAtMost(maxOf(0, written.size - 1)))
            .takeIf { it != ProjectRobot(place.name) }
    }

    /** The programs to load; Run starts the one in [firstSlot]. */
    fun load(firstSlot: Int): RobotLoad {
        val slots = shelf.slots
        val facing = kept.lightFacing ?: slots.getOrNull(firstSlot)?.let { lightFacingOf(it) }
        return RobotLoad(slots, firstSlot, facing)
    }

    /** The breakpoints of the program in [slot]. */
    fun breakpoints(slot: Int): Set<Breakpoint> {
        val entry = shelf.entries.getOrNull(slot) ?: return emptySet()
        val file = { index: Int ->
            entry.program.files[index].name.takeIf {
                entry.program.language ==
                    ProgramLanguage.JAVA
            }
        }
        return entry.memories.flatMapIndexedTo(mutableSetOf()) { index, memory ->
            memory.breakpoints.map { Breakpoint(it, file(index)) }
        }
    }

    /** The same programs and editor states for [place]. */
    fun movedTo(place: RobotPlacement): RobotPrograms {
        val isOwn = isUntouched && worldProgramOf(place) != given
        val moved =
            RobotPrograms(place, kept.copy(name = place.name), reader, if (isOwn) emptyList() else shelf.programs)
        if (!isOwn) moved.remember(this) { it }
        moved.closed = closed
        moved.closedMessageShown = closedMessageShown
        return moved
    }

    /** The same programs and editor states, compiled again by [reader]. */
    fun readBy(reader: ProgramCompiler): RobotPrograms {
        val again = RobotPrograms(place, kept, reader, shelf.programs)
        again.remember(this) { it.unread() }
        again.closed = closed.let { if (it is ClosedFile.Program) ClosedFile.Program(it.entry.unread()) else it }
        again.closedMessageShown = closedMessageShown
        return again
    }

    private fun remember(other: RobotPrograms, change: (ProgramBuffer) -> ProgramBuffer) {
        other.shelf.entries.forEachIndexed { slot, entry -> shelf.change(slot, change(entry)) }
        shownProgram = other.shownProgram
        shownFile = other.shownFile
    }
}

/** The program that the world gives to a robot. */
private fun worldProgramOf(place: RobotPlacement) =
    PupilProgram("${place.name}${ProgramLanguage.ROBOLANG.extension}", place.program.orEmpty())
