package robotran.workshop.programs

import robotran.programs.ProgramDiagnostic
import robotran.programs.ProgramResult
import robotran.robolang.RobolangProgram
import robotran.robolang.translate.Translation
import robotran.robolang.translate.translateRobolang
import robotran.textediting.editBetween
import robotran.textediting.text.Draft
import robotran.workshop.state.InlineDiagnostic
import robotran.workshop.state.ProgramFile
import robotran.workshop.state.PupilProgram
import robotran.workshop.state.notesOf

/**
 * One program on a shelf.
 *
 * @property memories what is remembered of its files, in their order.
 * @property result what came of reading it; null if it was not read since it was changed.
 * @property notes what is told about its lines; until it is read again, what was told before.
 */
internal class ProgramBuffer private constructor(
    val program: PupilProgram,
    val memories: List<ProgramFileMemory>,
    val result: ProgramResult?,
    val notes: List<InlineDiagnostic>,
    private val earlierTranslation: Translation?,
    knownTranslation: Lazy<Translation?>? = null,
) {
    constructor(
        program: PupilProgram,
    ) : this(program, program.files.map { ProgramFileMemory(Draft(it.text)) }, null, emptyList(), null)

    /** Nobody waits for a translation that nobody looks at. */
    private val lazyTranslation: Lazy<Translation?> =
        knownTranslation ?: lazy(LazyThreadSafetyMode.NONE) { robolang?.let(::translateRobolang) ?: earlierTranslation }

    val diagnostics: List<ProgramDiagnostic> get() = (result as? ProgramResult.HasErrors)?.diagnostics.orEmpty()

    /** As Java, if it is in Robolang; while it has mistakes, as it was before them, if somebody looked at it then. */
    val translation: Translation? get() = lazyTranslation.value

    /** Whether [translation] is that of the program as it is now. */
    val isTranslated: Boolean get() = robolang != null

    private val robolang: RobolangProgram? get() = (result as? ProgramResult.Ready)?.program as? RobolangProgram
    private val lastTranslation: Translation?
        get() = if (lazyTranslation.isInitialized()) translation else earlierTranslation

    /** The same program once [result] came of reading it. */
    fun read(result: ProgramResult): ProgramBuffer =
        ProgramBuffer(program, memories, result, notesOf(result), earlierTranslation)

    /** The same program, as if nobody had read it. */
    fun unread(): ProgramBuffer = ProgramBuffer(program, memories, null, notes, lastTranslation)

    /** This program with [memory] for the file at [place]. */
    fun with(place: Int, memory: ProgramFileMemory): ProgramBuffer {
        val before = memories[place]
        val remembered = memories.mapIndexed { index, old -> if (index == place) memory else old }
        val edit = editBetween(before.draft, memory.draft)
            ?: return ProgramBuffer(program, remembered, result, notes, earlierTranslation, lazyTranslation)
        val file = program.files[place].name
        val moved = notes.mapNotNull { it.movedWith(edit, file, before.draft.lines, memory.draft.lines) }
        return ProgramBuffer(program.withText(place, memory.draft.text), remembered, null, moved, lastTranslation)
    }

    /** This program without [note], which somebody has seen to. */
    fun without(note: InlineDiagnostic): ProgramBuffer =
        ProgramBuffer(program, memories, result, notes - note, earlierTranslation, lazyTranslation)

    /** This program with other [files], each with what is remembered of it. */
    fun withFiles(files: List<Pair<ProgramFile, ProgramFileMemory>>): ProgramBuffer =
        ProgramBuffer(PupilProgram(files.map { it.first }), files.map { it.second }, null, notes, lastTranslation)
}
