package robotran.cli.files

import robotran.programs.ProgramSource

/** The result of reading the files of one program. */
internal sealed interface ReadProgram {
    /** @property notes how its files were read although they are unusual, in sentences. */
    data class Success(val source: ProgramSource, val notes: List<String> = emptyList()) : ReadProgram

    /** The program cannot be used. [reason] is a sentence that names the file. */
    data class Failure(val reason: String) : ReadProgram
}
