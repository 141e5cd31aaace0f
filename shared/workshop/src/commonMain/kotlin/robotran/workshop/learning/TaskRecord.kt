package robotran.workshop.learning

import kotlinx.serialization.Serializable
import robotran.programs.Program

/**
 * The pupil's own best results for a task on this device.
 *
 * @property milliseconds the shortest virtual time of a run that met all goals.
 * @property lines the fewest lines of a program that did.
 */
@Serializable
internal data class TaskRecord(val milliseconds: Long, val lines: Int) {
    /** The better of both results, each figure by itself. */
    fun with(other: TaskRecord) = TaskRecord(minOf(milliseconds, other.milliseconds), minOf(lines, other.lines))
}

/** The lines of a program that are neither empty nor only a comment. */
internal fun linesOf(program: Program): Int = program.files.sumOf { file ->
    file.text.lines().map { it.trim() }.count { line -> line.isNotEmpty() && COMMENTS.none { line.startsWith(it) } }
}

/** How a line of only a comment begins, in Robolang or Java. */
private val COMMENTS = listOf("//", "/*", "*", "#")
