package robotran.cli.console

import robotran.cli.CommandLine
import robotran.cli.CommandTest
import robotran.console.ExitCode
import robotran.simulation.picture.WorldPictures
import java.io.RandomAccessFile
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Whatever happens, a command says a sentence and not a stack trace. */
class UnexpectedTest : CommandTest() {
    private val maze = tree.resolve("worlds/maze.world.json").path

    private class BrokenDesktop(private val problem: Throwable) : DesktopApp {
        override val pictures: WorldPictures get() = throw problem

        override fun openWindow(files: List<String>): ExitCode = throw problem
    }

    @Test
    fun `a mistake of Robotran's own is one sentence in the language of the command`() {
        val problems = listOf(
            IllegalStateException("first line\nsecond line", IllegalArgumentException("the cause\u001B[31m\nmore")),
            StackOverflowError(),
            OutOfMemoryError("Java heap space"),
        )
        for (problem in problems) {
            console.complaints.clear()
            assertEquals(70, CommandLine(console, BrokenDesktop(problem)).execute(listOf("app")))
            val described = console.complaints.single()
            assertContains(described, "Something went wrong in Robotran itself.")
            assertTrue('\n' !in described && "\tat " !in described, described)
        }
        console.complaints.clear()
        val arguments = listOf("run", square, "--picture", "$folder/x.png", "--language", "de")
        assertEquals(70, CommandLine(console, BrokenDesktop(problems.first())).execute(arguments))
        val described = console.complaints.last()
        assertContains(described, "In Robotran selbst ist etwas schiefgegangen.")
        assertContains(described, "IllegalArgumentException: the cause\\u001b[31m (UnexpectedTest.kt:")
    }

    @Test
    fun `of a class with a folder that cannot be read, all else is graded`() {
        program("forward 10\n", "class/Ida/mine.robo")
        val deep = folder.resolve("class").tooDeep()
        try {
            assertEquals(2, commandLine.execute(listOf("grade", maze, "$folder/class")))
        } finally {
            deep.undo()
        }
        assertTrue(console.complaints.any { "could not be read: " in it }, "${console.complaints}")
        assertContains(console.said.joinToString("\n"), "Ida")
    }

    @Test
    fun `a course that names a file of three gigabytes says that it is too large`() {
        RandomAccessFile(folder.resolve("huge.robotran").toFile(), "rw").use { it.setLength(HUGE) }
        val course = program(
            """{"format": "robotran-course", "version": 1, "title": "T", "assignments": ["huge.robotran"]}""",
            "course.json",
        )
        for (command in listOf(listOf("link", course), listOf("package", "$folder", "-o", "$folder/out.zip"))) {
            console.complaints.clear()
            assertEquals(2, commandLine.execute(command))
            assertContains(
                console.complaints.single(),
                "huge.robotran is too large: it can have 16000000 bytes at most.",
            )
        }
    }

    /** A folder in this one whose path is too long for the system, so that nobody can read it, not even root. */
    private fun Path.tooDeep(): Deep {
        fun chain(start: Path) = generateSequence(start) { it.resolve("d".repeat(LONGEST_NAME)) }.take(LEVELS).last()
        val (first, second) = listOf("first", "second").map { resolve(it) }
        val inner = chain(first).createDirectories()
        chain(second).createDirectories().resolve("mine.robo").writeText("beep\n")
        val moved = inner.resolve("second")
        Files.move(second, moved)
        return Deep(moved, second)
    }

    private class Deep(val moved: Path, val original: Path) {
        /** Otherwise it could not be deleted. */
        fun undo() {
            Files.move(moved, original)
        }
    }

    private companion object {
        const val HUGE = 3_000_000_000L
        const val LONGEST_NAME = 200
        const val LEVELS = 12
    }
}
