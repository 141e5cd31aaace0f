package robotran.workshop.programs

import robotran.language.ProgramLanguage
import robotran.textediting.EditKind
import robotran.textediting.code.isJavaName
import robotran.textediting.code.renamedInJava
import robotran.workshop.state.ProgramFile
import robotran.workshop.state.PupilProgram

/** Why a file name is invalid. */
enum class NameProblem { EMPTY, TAKEN, NO_CLASS_NAME, STRANGE_CHARACTER }

/** The file name for the input [typed], with or without extension, in [language]. */
internal fun fileNameFor(typed: String, language: ProgramLanguage): String =
    typed.trim().removeSuffix(language.extension) + language.extension

/**
 * The reason why the file with the index [index] of a program cannot be named [typed]; null if it can.
 *
 * @param programs all programs of the robot.
 * @param slot the slot of the program.
 */
fun nameProblem(programs: List<PupilProgram>, slot: Int, index: Int, typed: String): NameProblem? {
    val program = programs[slot]
    val name = fileNameFor(typed, program.language)
    val bare = name.removeSuffix(program.language.extension)
    val others = programs.filterIndexed { index, _ -> index != slot }.map { it.name } +
        program.files.filterIndexed { other, _ -> other != index }.map { it.name }
    return when {
        bare.isBlank() -> NameProblem.EMPTY
        name in others -> NameProblem.TAKEN
        program.language == ProgramLanguage.JAVA && !isJavaName(bare) -> NameProblem.NO_CLASS_NAME
        bare.length > MAX_CHARACTERS || bare.any { it in FORBIDDEN || it < ' ' } -> NameProblem.STRANGE_CHARACTER
        else -> null
    }
}

/** This program with the file at the index [index] renamed to [name]. In Java, also renames its class in all files. */
internal fun ProgramBuffer.withFileRenamed(index: Int, name: String): ProgramBuffer {
    val old = program.files[index].name.removeSuffix(program.language.extension)
    val new = name.removeSuffix(program.language.extension)
    return withFiles(
        program.files.mapIndexed { other, file ->
            val text = if (program.language == ProgramLanguage.JAVA) renamedInJava(file.text, old, new) else file.text
            val memory = memories[other]
            val draft = memory.draft.copy(text = text, selection = memory.draft.selection.within(text.length))
            ProgramFile(if (other == index) name else file.name, text) to memory.written(draft, EditKind.OTHER)
        },
    )
}

private const val MAX_CHARACTERS = 60

/** Characters that some file systems forbid in file names. */
private const val FORBIDDEN = "/\\:*?\"<>|"
