package robotran.workshop.programs

import robotran.programs.ProgramDiagnostic
import robotran.programs.ProgramResult
import robotran.projects.ProgramView
import robotran.robolang.RobolangProgram
import robotran.robolang.translate.Translation
import robotran.robolang.translate.translateRobolang
import robotran.textediting.EditKind
import robotran.textediting.editBetween
import robotran.textediting.text.Draft
import robotran.workshop.state.InlineDiagnostic
import robotran.workshop.state.ProgramFile
import robotran.workshop.state.PupilProgram
import robotran.workshop.state.notesOf

/**
 * A program of a robot with its editor state.
 *
 * @property memories the editor states of its files, in order.
 * @property result the compile result; null if it was changed since the last compilation.
 * @property notes the diagnostics of its lines; until it is compiled again, the old ones.
 */
internal class ProgramBuffer private constructor(
    val program: PupilProgram,
    val memories: List<ProgramFileMemory>,
    val result: ProgramResult?,
    val notes: List<InlineDiagnostic>,
    private val earlierTranslation: Translation?,
    knownTranslation: Lazy<Translation?>? = null,
) {
    /** A program that was just opened and is shown as [view]. */
    constructor(program: PupilProgram, view: ProgramView) : this(
        program,
        program.files.map { ProgramFileMemory(Draft(it.text), view = view) },
        null,
        emptyList(),
        null,
    )

    /** Translates only on demand. */
    private val lazyTranslation: Lazy<Translation?> =
        knownTranslation ?: lazy(LazyThreadSafetyMode.NONE) { robolang?.let(::translateRobolang) ?: earlierTranslation }

    /** How the program is shown. */
    val view: ProgramView get() = memories.first().view

    val diagnostics: List<ProgramDiagnostic> get() = (result as? ProgramResult.HasErrors)?.diagnostics.orEmpty()

    /** The Java translation of a Robolang program. With errors, the last valid translation, if it was used. */
    val translation: Translation? get() = lazyTranslation.value

    /** Whether [translation] belongs to the current program. */
    val isTranslated: Boolean get() = robolang != null

    private val robolang: RobolangProgram? get() = (result as? ProgramResult.Ready)?.program as? RobolangProgram
    private val lastTranslation: Translation?
        get() = if (lazyTranslation.isInitialized()) translation else earlierTranslation

    /** The same program with the compile result [result]. */
    fun read(result: ProgramResult): ProgramBuffer =
        ProgramBuffer(program, memories, result, notesOf(result), earlierTranslation)

    /** The same program without a compile result. */
    fun unread(): ProgramBuffer = ProgramBuffer(program, memories, null, notes, lastTranslation)

    /** This program with [memory] for the file with the index [index]. */
    fun with(index: Int, memory: ProgramFileMemory): ProgramBuffer {
        val before = memories[index]
        val remembered = memories.mapIndexed { other, old -> if (other == index) memory else old }
        val edit = editBetween(before.draft, memory.draft)
            ?: return ProgramBuffer(program, remembered, result, notes, earlierTranslation, lazyTranslation)
        val file = program.files[index].name
        val moved = notes.mapNotNull { it.movedWith(edit, file, before.draft.lines, memory.draft.lines) }
        return ProgramBuffer(program.withText(index, memory.draft.text), remembered, null, moved, lastTranslation)
    }

    /** This program with the files of [other]; those of the same name keep their editor states, to be undone. */
    fun changedTo(other: PupilProgram): ProgramBuffer = if (other == program) {
        this
    } else {
        withFiles(
            other.files.map { file ->
                val known = memories.getOrNull(program.files.indexOfFirst { it.name == file.name })
                file to when {
                    known == null -> ProgramFileMemory(Draft(file.text), view = view)
                    known.draft.text == file.text -> known
                    else -> known.written(known.draft.changedTo(file.text), EditKind.OTHER)
                }
            },
        )
    }

    /** This program without [note], which was fixed. */
    fun without(note: InlineDiagnostic): ProgramBuffer =
        ProgramBuffer(program, memories, result, notes - note, earlierTranslation, lazyTranslation)

    /** This program with other [files] and their editor states. */
    fun withFiles(files: List<Pair<ProgramFile, ProgramFileMemory>>): ProgramBuffer =
        ProgramBuffer(PupilProgram(files.map { it.first }), files.map { it.second }, null, notes, lastTranslation)
}
