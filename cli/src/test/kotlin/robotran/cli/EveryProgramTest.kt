package robotran.cli

import robotran.console.RecordingConsole
import java.io.File
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Runs the commands that read program text on every example and every test program. */
class EveryProgramTest {
    private val tree = File(System.getProperty("robotran.tree"))
    private val programs =
        listOf("examples", "shared/robolang/src/commonTest/resources/programs")
            .flatMap { folder -> tree.resolve(folder).walk().filter { it.extension == "robo" } }
            .sortedBy { it.path }

    @Test
    fun `there are enough of them`() {
        assertTrue(programs.size >= 250, "only ${programs.size} programs were found")
        assertTrue(programs.count { it.expected("error").isNotEmpty() } >= 60)
    }

    @Test
    fun `check tells exactly the mistakes and warnings that are expected`() {
        for (program in programs) {
            val (status, console) = execute("check", program.path)
            val diagnostics = program.expected("error")
            assertEquals(if (diagnostics.isEmpty()) 0 else 1, status, program.path)
            assertEquals(diagnostics.map { "${program.path}:$it" }, console.complaints, program.path)
            val warnings = program.expected("warning").map { "${program.path}:$it (a warning)" }
            if (warnings.isNotEmpty()) assertEquals(warnings, console.said.dropLast(1))
        }
    }

    @Test
    fun `translate writes Java, or tells exactly the mistakes that are expected`() {
        for (program in programs) {
            val (status, console) = execute("translate", program.path)
            val diagnostics = program.expected("error")
            assertEquals(if (diagnostics.isEmpty()) 0 else 1, status, program.path)
            assertEquals(diagnostics.map { "${program.path}:$it" }, console.complaints, program.path)
            assertEquals(
                diagnostics.isEmpty(),
                console.said.singleOrNull().orEmpty().contains("public class "),
                program.path,
            )
        }
    }

    @Test
    fun `every program is formatted, or has mistakes that are expected`() {
        for (program in programs) {
            val (status, console) = execute("format", "--check", program.path)
            val expected = program.expected("error").map { "${program.path}:$it" }
            assertEquals(if (console.complaints.isEmpty()) 0 else 1, status, program.path)
            assertEquals(emptyList(), console.complaints - expected.toSet(), program.path)
        }
    }

    @Test
    fun `all at once give the worst status and all mistakes`() {
        val (status, console) = execute("check", *programs.map { it.path }.toTypedArray())
        assertEquals(1, status)
        assertEquals(programs.sumOf { it.expected("error").size }, console.complaints.size)
    }

    private fun execute(vararg arguments: String): Pair<Int, RecordingConsole> {
        val console = RecordingConsole()
        return CommandLine(console, desktop = null).execute(arguments.toList()) to console
    }

    /** The diagnostics that a test program expects in its comments, as `line:column: message`. */
    private fun File.expected(kind: String): List<String> {
        val comment = Regex("""// $kind (\d+:\d+) (.+?)\s*$""")
        return readLines().mapNotNull { line ->
            comment.find(line)?.destructured?.let { (place, message) -> "$place: $message" }
        }
    }
}
