package robotran.cli.files

import robotran.cli.CommandTest
import robotran.cli.messages.CommandMessages
import robotran.language.Language
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.io.path.createDirectory
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.writeBytes
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** Files that never end or never deliver data, in every place where a command takes a file. */
class EndlessFileTest : CommandTest() {
    private fun linkTo(device: String, name: String): String =
        folder.resolve(name).createSymbolicLinkPointingTo(Path.of(device)).toString()

    private fun pipe(name: String): String = "$folder/$name".also { path ->
        val made = ProcessBuilder("mkfifo", path).start()
        check(made.waitFor(10, TimeUnit.SECONDS) && made.exitValue() == 0)
    }

    /** Runs the command with a timeout and returns its only error. */
    private fun refusal(vararg arguments: String): String {
        console.complaints.clear()
        var status: Int? = null
        val command = thread(isDaemon = true) { status = commandLine.execute(arguments.toList()) }
        command.join(SOON)
        assertEquals(2, status, "${arguments.toList()}: ${console.complaints}")
        return console.complaints.single()
    }

    @Test
    fun `a device or a pipe is refused at once with a sentence, whatever it is named for`() {
        for (ending in listOf("robo", "java", "class", "jar", "robotran", "world.json")) {
            val files =
                listOf(
                    linkTo("/dev/zero", "zero.$ending"),
                    linkTo("/dev/urandom", "random.$ending"),
                    pipe("pipe.$ending"),
                )
            for (file in files) {
                val name = if (ending == "class") file.substringAfterLast('/') else file
                val described = "$name is not a file with an end but a device or a pipe, which cannot be read."
                if (ending == "world.json") {
                    assertEquals(described, refusal("run", square, "--world", file))
                    assertEquals(described, refusal("grade", file, square))
                    assertEquals(described, refusal("link", file))
                } else {
                    assertEquals(described, refusal("run", file))
                    if (ending != "robotran") assertEquals(described, refusal("run", square, "--robot", "red=$file"))
                }
            }
        }
        for (command in listOf("check", "format", "translate", "link")) {
            assertContains(refusal(command, "$folder/zero.robo"), "a device or a pipe")
        }
    }

    @Test
    fun `in a folder of classes and among sources it is no other`() {
        val classes = folder.resolve("classes").createDirectory()
        classes.resolve("Zero.class").createSymbolicLinkPointingTo(Path.of("/dev/zero"))
        assertContains(refusal("run", "$classes"), "There is no class file in classes.")
        val sources = folder.resolve("sources").createDirectory()
        sources.resolve("Zero.java").createSymbolicLinkPointingTo(Path.of("/dev/zero"))
        assertContains(refusal("grade", tree.resolve("worlds/maze.world.json").path, "$sources"), "a device or a pipe")
    }

    @Test
    fun `of a file that says that it is small no more is read than a byte too many`() {
        val large = folder.resolve("large.robo").also { it.writeBytes(ByteArray(LARGEST_FILE_BYTES + 1)) }
        assertContains(refusal("run", "$large"), "large.robo is too large")
        // Files in /proc report a length of 0 but have content, like a file that grows after its size was read.
        val growing =
            assertIs<FileContent.Failure>(
                readContent(Path.of("/proc/self/status"), "growing.robo", 10, CommandMessages.of(Language.ENGLISH)),
            )
        assertEquals("growing.robo is too large: it can have 10 bytes at most.", growing.reason)
        assertIs<FileContent.Success>(
            readContent(Path.of("/proc/self/status"), "growing.robo", 100_000, CommandMessages.of(Language.ENGLISH)),
        )
    }

    private companion object {
        const val SOON = 20_000L
    }
}
