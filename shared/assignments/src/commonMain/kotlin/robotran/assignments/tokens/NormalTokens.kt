package robotran.assignments.tokens

import robotran.programs.support
import robotran.projects.ProjectProgram

/** At most [MAXIMUM_TOKENS] of the words, numbers and signs of [program], see [robotran.languagesupport.ProgramMeasure]. */
internal fun normalTokens(program: ProjectProgram): List<String> {
    val measure = program.language.support.measure
    val files = if (measure.isAnyOrderOfFiles) program.files.sortedBy { it.name } else program.files
    return files.asSequence().flatMap { measure.normalTokens(it.text) }.take(MAXIMUM_TOKENS).toList()
}

/** Whether both are the same, whatever their comments, blanks and chosen names. */
fun isSameProgram(one: ProjectProgram, other: ProjectProgram): Boolean =
    one.language == other.language && normalTokens(one) == normalTokens(other)

internal const val MAXIMUM_TOKENS = 5_000
