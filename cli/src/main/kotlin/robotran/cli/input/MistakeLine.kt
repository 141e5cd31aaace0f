package robotran.cli.input

import robotran.cli.files.NamedProgram
import robotran.programs.Mistake
import robotran.programs.ProgramSource

/** [mistake] in one line for a person, with the place that editors jump to. */
internal fun lineOf(
    program: NamedProgram,
    mistake: Mistake,
): String {
    val file =
        when (program.source) {
            is ProgramSource.Robolang -> program.path
            is ProgramSource.Java -> mistake.file
            is ProgramSource.ClassFiles -> listOf(program.path, mistake.file).filter { it.isNotEmpty() }.joinToString(": ")
        }
    return lineOf(listOfNotNull(program.project, file).joinToString(": "), mistake)
}

/** [mistake] of the file [name] in one line for a person. */
internal fun lineOf(
    name: String,
    mistake: Mistake,
): String {
    val place = mistake.range?.let { ":${it.line}:${it.column}" }.orEmpty()
    return "$name$place: ${mistake.message}"
}
