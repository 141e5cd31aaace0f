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
 * The programs of one robot: those that a pupil has given it or, as long as they were not touched, the one that its
 * world gives it.
 *
 * @property place the robot as its world has it.
 * @param kept what a project says about it.
 */
internal class RobotPrograms(
    val place: RobotPlacement,
    private val kept: ProjectRobot,
    private val reader: ProgramCompiler,
    first: List<PupilProgram>,
) {
    private val given: PupilProgram = ownProgramOf(place)

    val shelf = ProgramList((first.ifEmpty { listOf(given) }).map { it.withPlainLineEnds() }, reader)
    var shownProgram = kept.firstProgram.coerceIn(shelf.entries.indices)
    var shownFile = 0
    var closed: ClosedFile? = null
        set(value) {
            field = value
            closedShown = value != null
        }

    /** Whether it is told what was taken away last. */
    var closedShown = false

    val entry: ProgramBuffer get() = shelf.entries[shownProgram]
    val memory: ProgramFileMemory get() = entry.memories[shownFile]

    /** Whether there is room for what was taken away last. */
    val canReopen: Boolean
        get() = when (val closed = closed) {
            null -> false
            is ClosedFile.Program -> shelf.entries.size < Brick.MAX_PROGRAMS
            is ClosedFile.OfProgram -> shelf.entries[closed.slot].program.files.none { it.name == closed.name }
        }

    /** Whether nobody has given it anything, so that it has what the world gives it. */
    val isUntouched: Boolean get() = shelf.programs == listOf(given)

    /** Whether it would do anything when it runs. */
    val isBlank: Boolean get() = shelf.programs.all { it.isBlank }

    /** As a project keeps it; null if there is nothing to keep. */
    fun asProject(): ProjectRobot? {
        val written: List<ProjectProgram> = if (isUntouched) emptyList() else shelf.programs.map { it.asProject() }
        return kept.copy(programs = written, firstProgram = kept.firstProgram.coerceAtMost(maxOf(0, written.size - 1)))
            .takeIf { it != ProjectRobot(place.name) }
    }

    /** What it is loaded with; Run starts what is in [firstSlot]. */
    fun load(firstSlot: Int): RobotLoad {
        val slots = shelf.slots
        val facing = kept.lightFacing ?: slots.getOrNull(firstSlot)?.let { lightFacingOf(it) }
        return RobotLoad(slots, firstSlot, facing)
    }

    /** Where the program in [slot] is to stop. */
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

    /** The same programs for [place], with all that is remembered of them. */
    fun movedTo(place: RobotPlacement): RobotPrograms {
        val isOwn = isUntouched && ownProgramOf(place) != given
        val moved =
            RobotPrograms(place, kept.copy(name = place.name), reader, if (isOwn) emptyList() else shelf.programs)
        if (!isOwn) moved.remember(this) { it }
        moved.closed = closed
        moved.closedShown = closedShown
        return moved
    }

    /** The same programs, with all that is remembered of them, read again by [reader]. */
    fun readBy(reader: ProgramCompiler): RobotPrograms {
        val again = RobotPrograms(place, kept, reader, shelf.programs)
        again.remember(this) { it.unread() }
        again.closed = closed.let { if (it is ClosedFile.Program) ClosedFile.Program(it.entry.unread()) else it }
        again.closedShown = closedShown
        return again
    }

    private fun remember(other: RobotPrograms, change: (ProgramBuffer) -> ProgramBuffer) {
        other.shelf.entries.forEachIndexed { slot, entry -> shelf.change(slot, change(entry)) }
        shownProgram = other.shownProgram
        shownFile = other.shownFile
    }
}

/** What the world gives a robot to do, as a program. */
private fun ownProgramOf(place: RobotPlacement) =
    PupilProgram("${place.name}${ProgramLanguage.ROBOLANG.extension}", place.program.orEmpty())
