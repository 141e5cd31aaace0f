package robotran.workshop.programs

import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.programs.support
import robotran.textediting.EditKind
import robotran.workshop.service.endingOf
import robotran.workshop.service.fileNameFor

/** Why a file name is invalid. */
enum class NameError { EMPTY, TAKEN, NO_CLASS_NAME, STRANGE_CHARACTER }

/**
 * The reason why the file with the index [index] of a program cannot be named [typed]; null if it can.
 *
 * @param programs all programs of the robot.
 * @param slot the slot of the program.
 */
fun nameError(programs: List<Program>, slot: Int, index: Int, typed: String): NameError? {
    val program = programs[slot]
    val old = program.files[index].name
    val name = fileNameFor(typed, old, program.language)
    val bare = name.removeSuffix(endingOf(old, program.language))
    val others = programs.filterIndexed { index, _ -> index != slot }.map { it.name } +
        program.files.filterIndexed { other, _ -> other != index }.map { it.name }
    return when {
        bare.isBlank() -> NameError.EMPTY
        name in others -> NameError.TAKEN
        !program.language.support.files.isValidName(bare) -> NameError.NO_CLASS_NAME
        bare.length > MAX_CHARACTERS || bare.any { it in FORBIDDEN || it < ' ' } -> NameError.STRANGE_CHARACTER
        else -> null
    }
}

/**
 * This program with the file at the index [index] renamed to [name], and what names it in all files.
 */
internal fun ProgramBuffer.withFileRenamed(index: Int, name: String): ProgramBuffer {
    val before = program.files[index].name
    val files = program.language.support.files
    return withFiles(
        program.files.mapIndexed { other, file ->
            val text = files.renamed(file.text, before, name)
            val editorState = editorStates[other]
            val draft = editorState.draft.copy(text = text, selection = editorState.draft.selection.within(text.length))
            SourceFile(if (other == index) name else file.name, text) to editorState.written(draft, EditKind.OTHER)
        },
    )
}

private const val MAX_CHARACTERS = 60

/** Characters that some file systems forbid in file names. */
private const val FORBIDDEN = "/\\:*?\"<>|"
