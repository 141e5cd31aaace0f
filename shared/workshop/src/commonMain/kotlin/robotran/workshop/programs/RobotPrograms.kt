package robotran.workshop.programs

import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.nxt.storage.NxtFile
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.support
import robotran.projects.ProgramView
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.givenProgram
import robotran.projects.lightFacingOf
import robotran.projects.target
import robotran.simulation.Breakpoint
import robotran.simulation.RobotProgramSet
import robotran.workshop.service.Preferences
import robotran.workshop.service.asProject
import robotran.workshop.state.withPlainLineEnds
import robotran.world.RobotPlacement

/**
 * The programs of one robot: the pupil's programs or, until they are edited, the world's program for it.
 *
 * @property placement the robot in its world.
 * @param saved its programs and files in the project.
 * @param view how programs are shown first of which [saved] does not say it.
 */
internal class RobotPrograms(
    val placement: RobotPlacement,
    private var saved: ProjectRobot,
    anyCompiler: ProgramCompiler,
    first: List<Program>,
    private val view: ProgramView,
) {
    private val compiler = anyCompiler.forTarget(placement.description.target)
    private val given: Program = worldProgramOf(placement)

    val list = ProgramList((first.ifEmpty { listOf(given) }).map { it.withPlainLineEnds() }, compiler) { slot ->
        saved.programs.getOrNull(slot)?.view ?: view
    }
    var shownProgram = saved.firstProgram.coerceIn(list.entries.indices)
    var shownFile = 0
    var closed: ClosedFile? = null
        set(value) {
            field = value
            closedMessageShown = value != null
        }

    /** Whether the message about the last removed file is shown. */
    var closedMessageShown = false

    /** What the compiler of this robot makes of [program], whose language needs no loading. */
    fun compiled(program: Program): ProgramResult = compiler.compileNow(program)

    val brick: BrickKind get() = placement.description.brick

    val entry: ProgramBuffer get() = list.entries[shownProgram]
    val editorState: FileEditorState get() = entry.editorStates[shownFile]

    /** Whether there is room to restore the last removed file. */
    val canReopen: Boolean
        get() = when (val closed = closed) {
            null -> false
            is ClosedFile.Program -> list.entries.size < BrickProgram.MAX_PROGRAMS
            is ClosedFile.OfProgram -> list.entries[closed.slot].program.files.none { it.name == closed.name }
        }

    /**
     * Puts [editorState] in the place of that of the shown file; its blocks are read anew if it is shown in blocks and its
     * text has changed. The compiler, which comes next, gets what they have read.
     */
    fun change(editorState: FileEditorState, preferences: Preferences) {
        val hasBlocks = entry.program.language.support.hasBlocks
        val read = if (hasBlocks) editorState.withBlocksRead(preferences, brick) else editorState
        if (read !== this.editorState) list.change(shownProgram, entry.with(shownFile, read))
    }

    /** Whether the pupil has changed nothing, so that it has the world's program. */
    val isUntouched: Boolean get() = list.programs == listOf(given)

    /** Whether all its programs are blank. */
    val isBlank: Boolean get() = list.programs.all { it.isBlank }

    /**
     * The robot as stored in a project; null if there is nothing to store. It does not say of a program that it is
     * shown as text where [usual], how programs are shown first, is text: others may be used to something else.
     */
    fun asProject(usual: ProgramView): ProjectRobot? {
        val written: List<ProjectProgram> = if (isUntouched) {
            emptyList()
        } else {
            list.entries.map { entry ->
                val isUsual = entry.view == ProgramView.TEXT && usual == ProgramView.TEXT
                entry.program.asProject(entry.view.takeUnless { isUsual })
            }
        }
        // Run starts what is in front, also after a reload and for whoever gets a link.
        val first = shownProgram.coerceAtMost(maxOf(0, written.size - 1))
        return saved.copy(programs = written, firstProgram = first).takeIf { it != ProjectRobot(placement.name) }
    }

    /** The programs to load; Run starts the one in [firstSlot]. */
    fun load(firstSlot: Int): RobotProgramSet {
        val slots = list.slots
        val facing = saved.lightFacing ?: slots.getOrNull(firstSlot)?.let { lightFacingOf(it) }
        return RobotProgramSet(slots, firstSlot, facing, saved.files)
    }

    /** Keeps [files] in its flash memory for the next run; returns whether they are others than before. */
    fun keep(files: List<NxtFile>): Boolean {
        if (files === saved.files || files == saved.files) return false
        saved = saved.copy(files = files)
        return true
    }

    /** The breakpoints of the program in [slot]. */
    fun breakpoints(slot: Int): Set<Breakpoint> {
        val entry = list.entries.getOrNull(slot) ?: return emptySet()
        val program = entry.program
        // Programs of other languages have files in their lines only if there are several.
        val hasFiles = program.language.support.namesFileOfLines || program.files.size > 1
        val file = { index: Int -> program.files[index].name.takeIf { hasFiles } }
        return entry.editorStates.flatMapIndexedTo(mutableSetOf()) { index, editorState ->
            editorState.breakpoints.map { Breakpoint(it, file(index)) }
        }
    }

    /** Puts [program] in the place of all others, which are not the pupil's own. */
    fun beginWith(program: Program) {
        shownProgram = 0
        shownFile = 0
        if (closed is ClosedFile.OfProgram) closed = null
        saved = ProjectRobot(placement.name, files = saved.files)
        list.replace(listOf(ProgramBuffer(program, entry.view)))
    }

    /** Puts [program] in the place of the one in [slot], of which it says nothing new, with its breakpoints. */
    fun replace(slot: Int, program: Program) {
        val before = list.entries[slot]
        val fresh = ProgramBuffer(program, before.view)
        val breakpoints = before.editorStates.first().breakpoints
        list.change(slot, fresh.with(0, fresh.editorStates.first().copy(breakpoints = breakpoints)))
    }

    /** Removes the programs that [isMeant], unless no other would be left. Returns whether it did. */
    fun removeAll(isMeant: (Program) -> Boolean): Boolean {
        val slots = list.entries.indices.filterNot { isMeant(list.entries[it].program) }
        if (slots.isEmpty()) return false
        if (shownProgram !in slots) shownFile = 0
        shownProgram = maxOf(0, slots.indexOfLast { it <= shownProgram })
        (closed as? ClosedFile.OfProgram)?.let { file ->
            val isMessageShown = closedMessageShown
            closed = slots.indexOf(file.slot).takeIf { it >= 0 }?.let(file::inSlot)
            closedMessageShown = isMessageShown && closed != null
        }
        list.replace(slots.map { list.entries[it] })
        return true
    }

    /** The same programs and editor states for [placement]. */
    fun movedTo(placement: RobotPlacement): RobotPrograms {
        val isOwn = isUntouched && worldProgramOf(placement) != given
        val moved =
            RobotPrograms(
                placement,
                saved.copy(name = placement.name),
                compiler,
                if (isOwn) emptyList() else list.programs,
                entry.view,
            )
        if (!isOwn) moved.remember(this) { if (moved.compiler === compiler) it else it.unread() }
        moved.closed = closed
        moved.closedMessageShown = closedMessageShown
        return moved
    }

    /** The same programs and editor states, compiled again by [compiler]. */
    fun compiledBy(compiler: ProgramCompiler): RobotPrograms {
        val again = RobotPrograms(placement, saved, compiler, list.programs, view)
        again.remember(this) { it.unread() }
        again.closed = closed.let { if (it is ClosedFile.Program) ClosedFile.Program(it.entry.unread()) else it }
        again.closedMessageShown = closedMessageShown
        return again
    }

    private fun remember(other: RobotPrograms, change: (ProgramBuffer) -> ProgramBuffer) {
        other.list.entries.forEachIndexed { slot, entry -> list.change(slot, change(entry)) }
        shownProgram = other.shownProgram
        shownFile = other.shownFile
    }
}

/** The program that the world gives to a robot. */
private fun worldProgramOf(placement: RobotPlacement): Program =
    checkNotNull(placement.copy(program = placement.program.orEmpty()).givenProgram)
