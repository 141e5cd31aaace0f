package robotran.cli.input

import robotran.cli.files.NamedProgram
import robotran.language.source.Diagnostic
import robotran.programs.Program
import robotran.programs.ProgramSource

/** [diagnostic] in one line, in the `file:line:column: message` format that editors recognise. */
internal fun lineOf(program: NamedProgram, diagnostic: Diagnostic): String {
    val file =
        when (val source = program.source) {
            is Program -> if (source.language.mayHaveFiles) diagnostic.file else program.path
            is ProgramSource.FirmwareImage -> program.path

            is ProgramSource.CompiledClasses -> listOf(program.path, diagnostic.file).filter {
                it.isNotEmpty()
            }.joinToString(": ")
        }
    return lineOf(listOfNotNull(program.project, file).joinToString(": "), diagnostic)
}

/** [diagnostic] of the file [name] in one line. */
internal fun lineOf(name: String, diagnostic: Diagnostic): String {
    val place = diagnostic.range?.let { ":${it.line}:${it.column}" }.orEmpty()
    return "$name$place: ${diagnostic.message}"
}

/** [diagnostic] of one of [programs] in one line. */
internal fun lineOf(programs: List<NamedProgram>, diagnostic: Diagnostic): String =
    lineOf(programs.find { owns(it.source, diagnostic.file) } ?: programs.first(), diagnostic)

private fun owns(source: ProgramSource, file: String) = source.name == file || source.files.any { it.name == file }
