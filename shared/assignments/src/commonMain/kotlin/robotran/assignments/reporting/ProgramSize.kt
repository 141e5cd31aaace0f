package robotran.assignments.reporting

import robotran.assignments.collecting.Submission
import robotran.language.ProgramLanguage
import robotran.projects.ProjectProgram
import robotran.robolang.SourceTokenKind
import robotran.robolang.robolangTokens

/** The lines of the program of a submission that Run starts, without empty ones and comments; 0 if it is unusable. */
val Submission.linesOfCode: Int
    get() = (this as? Submission.Usable)?.robot?.let { it.programs.getOrNull(it.firstProgram) }?.let(::linesOfCode) ?: 0

private fun linesOfCode(program: ProjectProgram): Int = program.files.sumOf { file ->
    when (program.language) {
        ProgramLanguage.ROBOLANG -> file.text.lineSequence().count { line ->
            robolangTokens(line).any { it.kind != SourceTokenKind.COMMENT }
        }

        ProgramLanguage.JAVA, ProgramLanguage.NQC -> javaLines(file.text)
        ProgramLanguage.LASM -> file.text.lineSequence().count { it.substringBefore(';').isNotBlank() }
    }
}

private fun javaLines(text: String): Int {
    var isInComment = false
    return text.lineSequence().count { line ->
        var rest = line
        val code = StringBuilder()
        while (rest.isNotEmpty()) {
            val end = if (isInComment) rest.indexOf("*/") else rest.indexOf("/*")
            if (!isInComment) code.append(if (end < 0) rest else rest.take(end))
            if (end < 0) break
            rest = rest.drop(end + 2)
            isInComment = !isInComment
        }
        code.toString().substringBefore("//").isNotBlank()
    }
}
