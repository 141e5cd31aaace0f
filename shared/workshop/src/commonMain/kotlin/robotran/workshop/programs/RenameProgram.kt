package robotran.workshop.programs

import robotran.language.ProgramLanguage
import robotran.textediting.EditKind
import robotran.textediting.code.isJavaName
import robotran.textediting.code.renamedInJava
import robotran.workshop.state.ProgramFile
import robotran.workshop.state.PupilProgram

/** Why a file name is invalid. */
enum class NameProblem { EMPTY, TAKEN, NO_CLASS_NAME, STRANGE_CHARACTER }

/** The ending of the file [name] of a program in [language]: what NQC includes may have another one. */
fun endingOf(name: String, language: ProgramLanguage): String =
    if (language == ProgramLanguage.NQC && '.' in name) name.substring(name.lastIndexOf('.')) else language.extension

/** The name that the file [old] of a program in [language] gets by the input [typed], with or without ending. */
internal fun fileNameFor(typed: String, old: String, language: ProgramLanguage): String =
    endingOf(old, language).let { typed.trim().removeSuffix(it) + it }

/**
 * The reason why the file with the index [index] of a program cannot be named [typed]; null if it can.
 *
 * @param programs all programs of the robot.
 * @param slot the slot of the program.
 */
fun nameProblem(programs: List<PupilProgram>, slot: Int, index: Int, typed: String): NameProblem? {
    val program = programs[slot]
    val old = program.files[index].name
    val name = fileNameFor(typed, old, program.language)
    val bare = name.removeSuffix(endingOf(old, program.language))
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

/**
 * This program with the file at the index [index] renamed to [name]. In Java, also renames its class in all files, in
 * NQC what includes it.
 */
internal fun ProgramBuffer.withFileRenamed(index: Int, name: String): ProgramBuffer {
    val before = program.files[index].name
    val old = before.removeSuffix(program.language.extension)
    val new = name.removeSuffix(program.language.extension)
    return withFiles(
        program.files.mapIndexed { other, file ->
            val text = when (program.language) {
                ProgramLanguage.JAVA -> renamedInJava(file.text, old, new)
                ProgramLanguage.NQC -> renamedInIncludes(file.text, before, name)
                ProgramLanguage.ROBOLANG, ProgramLanguage.LASM -> file.text
            }
            val memory = memories[other]
            val draft = memory.draft.copy(text = text, selection = memory.draft.selection.within(text.length))
            ProgramFile(if (other == index) name else file.name, text) to memory.written(draft, EditKind.OTHER)
        },
    )
}

private fun renamedInIncludes(text: String, old: String, new: String): String =
    Regex("(?m)^([ \\t]*#[ \\t]*include[ \\t]+\")" + Regex.escape(old) + "\"")
        .replace(text) { "${it.groupValues[1]}$new\"" }

private const val MAX_CHARACTERS = 60

/** Characters that some file systems forbid in file names. */
private const val FORBIDDEN = "/\\:*?\"<>|"
