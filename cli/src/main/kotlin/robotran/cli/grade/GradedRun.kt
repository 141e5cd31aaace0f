package robotran.cli.grade

import robotran.cli.files.filesOfProgram
import robotran.projects.isLink
import kotlin.io.path.Path
import kotlin.io.path.name

/**
 * The command that repeats a graded run.
 *
 * @param options the other options as command-line arguments.
 */
internal class GradedRun(private val world: String, private val milliseconds: Int, private val options: List<String>) {
    /** The command that repeats the run of [program] with [seed] and writes a picture. */
    fun command(program: String, seed: Int): String {
        val name = if (isLink(
                program,
            )
        ) {
            "link"
        } else {
            Path(program).toAbsolutePath().normalize().name.substringBeforeLast('.')
        }
        val words =
            listOf("./robotran", "run") + filesOfProgram(program) + listOf("--world", world, "--seed", "$seed") +
                listOf("--for", seconds()) + options + listOf("--picture", "$name-$seed.png")
        return words.joinToString(" ", transform = ::quoted)
    }

    private fun seconds() = (milliseconds / 1000.0).toString().removeSuffix(".0")

    /** Quotes [word] for a shell if needed. */
    private fun quoted(word: String): String = if (PLAIN.matches(word)) word else "'" + word.replace("'", "'\\''") + "'"

    private companion object {
        val PLAIN = Regex("[A-Za-z0-9_./=+,:@%-]+")
    }
}
