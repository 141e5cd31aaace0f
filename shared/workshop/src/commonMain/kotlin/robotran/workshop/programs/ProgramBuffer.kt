package robotran.workshop.programs

import robotran.language.Language
import robotran.language.ShownLanguage
import robotran.language.source.Diagnostic
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.programs.ProgramResult
import robotran.programs.ProgramTranslation
import robotran.programs.translated
import robotran.projects.ProgramView
import robotran.robolang.syntax.ParsedText
import robotran.textediting.EditKind
import robotran.textediting.editBetween
import robotran.textediting.text.TextDocument
import robotran.workshop.state.InlineDiagnostic
import robotran.workshop.state.notesOf

/**
 * A program of a robot with its editor state.
 *
 * @property editorStates the editor states of its files, in order.
 * @property result the compile result; null if it was changed since the last compilation.
 * @property notes the diagnostics of its lines; until it is compiled again, the old ones.
 * @param translations those made so far.
 */
internal class ProgramBuffer private constructor(
    val program: Program,
    val editorStates: List<FileEditorState>,
    val result: ProgramResult?,
    val notes: List<InlineDiagnostic>,
    private val translations: KnownTranslations = KnownTranslations(),
) {
    /** A program that was just opened and is shown as [view]. */
    constructor(program: Program, view: ProgramView) : this(
        program,
        program.files.map { FileEditorState(TextDocument(it.text), view = view) },
        null,
        emptyList(),
    )

    /** How the program is shown. */
    val view: ProgramView get() = editorStates.first().view

    val diagnostics: List<Diagnostic> get() = (result as? ProgramResult.Failure)?.diagnostics.orEmpty()

    /**
     * This program in the language [to], with remarks in [language]; translates only on demand. With errors, the last valid
     * translation, if it was used.
     */
    fun translation(to: ShownLanguage, language: Language): ProgramTranslation? =
        translations.current.getOrPut(to to language) {
            runnable?.let { program.translated(it, to, language) } ?: translations.earlier(to)
        }

    /** Whether the translations belong to the current program. */
    val isTranslated: Boolean get() = runnable != null

    /** Its text as the blocks have read it; null if they have not. */
    val parsed: ParsedText? get() = editorStates.first().blocks?.program?.outline?.parsed

    private val runnable get() = (result as? ProgramResult.Success)?.program

    /** The same program with the compile result [result]. */
    fun read(result: ProgramResult): ProgramBuffer =
        ProgramBuffer(program, editorStates, result, notesOf(result), translations.older())

    /** The same program without a compile result. */
    fun unread(): ProgramBuffer = ProgramBuffer(program, editorStates, null, notes, translations.older())

    /** This program with [editorState] for the file with the index [index]. */
    fun with(index: Int, editorState: FileEditorState): ProgramBuffer {
        val before = editorStates[index]
        val remembered = editorStates.mapIndexed { other, old -> if (other == index) editorState else old }
        val edit = editBetween(before.draft, editorState.draft)
            ?: return ProgramBuffer(program, remembered, result, notes, translations)
        val file = program.files[index].name
        val moved = notes.mapNotNull { it.movedWith(edit, file, before.draft.lines, editorState.draft.lines) }
        return ProgramBuffer(
            program.withText(index, editorState.draft.text),
            remembered,
            null,
            moved,
            translations.older(),
        )
    }

    /** This program with the files of [other]; those of the same name keep their editor states, to be undone. */
    fun changedTo(other: Program): ProgramBuffer = if (other == program) {
        this
    } else {
        withFiles(
            other.files.map { file ->
                val known = editorStates.getOrNull(program.files.indexOfFirst { it.name == file.name })
                file to when {
                    known == null -> FileEditorState(TextDocument(file.text), view = view)
                    known.draft.text == file.text -> known
                    else -> known.written(known.draft.changedTo(file.text), EditKind.OTHER)
                }
            },
        )
    }

    /** This program without [note], which was fixed. */
    fun without(note: InlineDiagnostic): ProgramBuffer =
        ProgramBuffer(program, editorStates, result, notes - note, translations)

    /** This program with other [files] and their editor states. */
    fun withFiles(files: List<Pair<SourceFile, FileEditorState>>): ProgramBuffer =
        ProgramBuffer(Program.of(files.map { it.first }), files.map { it.second }, null, notes, translations.older())
}
