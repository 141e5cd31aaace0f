package robotran.nqc.support

import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.languagesupport.simpleName

/** The names of the files that an NQC [text] includes, each once, as the text writes them. */
internal fun nqcIncludes(text: String): List<String> =
    INCLUDE.findAll(text).map { it.groupValues[1] }.distinct().toList()

/**
 * The programs that NQC [files] make: one for each `.nqc` file that no other includes, with all that it includes. A file
 * that no program includes belongs to the first one, so that none is lost.
 */
internal fun nqcProgramsOf(files: List<SourceFile>): List<List<SourceFile>> {
    if (files.isEmpty()) return emptyList()
    val included = files.flatMap { includedBy(it) }.toSet()
    val mains = files.filter { it.name.endsWith(ProgramLanguage.NQC.extension, ignoreCase = true) }
        .filter { simpleName(it.name) !in included }.ifEmpty { files.take(1) }
    val programs = mains.map { withIncluded(it, files) }
    val lost = files - programs.flatten().toSet()
    return listOf(programs.first() + lost) + programs.drop(1)
}

private fun withIncluded(main: SourceFile, files: List<SourceFile>): List<SourceFile> {
    val found = linkedSetOf(main)
    val waiting = ArrayDeque(listOf(main))
    while (waiting.isNotEmpty()) {
        val names = includedBy(waiting.removeFirst())
        files.filter { simpleName(it.name) in names }.filterTo(waiting) { found.add(it) }
    }
    return found.toList()
}

private fun includedBy(file: SourceFile): List<String> = nqcIncludes(file.text).map(::simpleName)

private val INCLUDE = Regex("""(?m)^[ \t]*#[ \t]*include[ \t]+"([^"\r\n]+)"""")
