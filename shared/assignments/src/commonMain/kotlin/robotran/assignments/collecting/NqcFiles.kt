package robotran.assignments.collecting

import robotran.documents.plainFileName
import robotran.programs.nqcIncludes

/** Which of the [files] of a folder programs in NQC include; they are part of these programs. */
internal class NqcFiles(private val files: List<FoundFile>) {
    private val names: Map<FoundFile, List<String>> = files.filter { it.kind == FoundKind.NQC }
        .associateWith { file -> nqcIncludes(file.text).map { it.substringAfterLast('/') } }

    /** Those that another one includes, unless both include each other. */
    val included: Set<FoundFile> = names.keys.flatMap { includedBy(it) }.filterNot { it in includedBy(it) }.toSet()

    /** What [file] includes, and what that includes. */
    fun includedBy(file: FoundFile): List<FoundFile> {
        val found = linkedSetOf<FoundFile>()
        val waiting = ArrayDeque(listOf(file))
        while (waiting.isNotEmpty()) {
            val included = names[waiting.removeFirst()].orEmpty()
            names.keys.filter { plainFileName(it.name) in included }.filterTo(waiting) { found.add(it) }
        }
        return found.toList()
    }
}
