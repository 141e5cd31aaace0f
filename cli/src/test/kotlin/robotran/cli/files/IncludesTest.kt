package robotran.cli.files

import robotran.cli.CommandTest
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** What a program in NQC includes, in every command that reads one. */
class IncludesTest : CommandTest() {
    private val secret = program("int SECRET_LINE_42;\n", "secret.nqh")

    private fun including(name: String) = program("#define N 1\n#include \"$name\"\ntask main() { }\n", "work/mine.nqc")

    private fun link(name: String, target: String) =
        folder.resolve("work").createDirectories().resolve(name).createSymbolicLinkPointingTo(Path.of(target))

    private val commands = listOf("run", "check", "build", "translate", "link", "send")

    @Test
    fun `files outside of the program's folder are not read, by whatever name`() {
        link("link.nqh", "../secret.nqh")
        link("up", "..")
        link("missing.nqh", "../nothing.nqh")
        val names =
            listOf(
                "../secret.nqh",
                secret,
                "/etc/hostname",
                "sub/../../secret.nqh",
                "link.nqh",
                "up/secret.nqh",
                "../nothing.nqh",
            )
        for (name in names) {
            val file = including(name)
            for (command in commands) {
                console.complaints.clear()
                console.said.clear()
                val status = commandLine.execute(listOf(command, file))
                assertTrue(status != 0, "$command $name")
                assertEquals(
                    "$file:2: it includes $name, which is not in the program's own folder. Copy that file there.",
                    console.complaints.single(),
                    command,
                )
                assertEquals(emptyList(), console.said, "$command $name")
            }
        }
    }

    @Test
    fun `a hand-in reads none either`() {
        including("../secret.nqh")
        val world = tree.resolve("worlds/maze.world.json").path
        commandLine.execute(listOf("grade", world, "$folder/work", "--html", "$folder/page.html"))
        val page = folder.resolve("page.html").toFile().readText()
        assertTrue("SECRET_LINE_42" !in page + console.said + console.complaints, page)
        console.complaints.clear()
        assertEquals(2, commandLine.execute(listOf("grade", world, "$folder/work/mine.nqc")))
        assertContains(console.complaints.first(), "which is not in the program's own folder")
    }

    @Test
    fun `a link in a folder of hand-ins that leads out of it is a row that says so`() {
        program("beep\n", "work/Ida/mine.robo")
        link("leak.txt", "../secret.nqh")
        val world = tree.resolve("worlds/maze.world.json").path
        assertEquals(2, commandLine.execute(listOf("grade", world, "$folder/work")))
        assertContains(console.complaints.joinToString(), "leak.txt is a link to a file outside of its folder")
    }

    @Test
    fun `files beside it and below it are read, from a folder below also one above`() {
        program("#include \"../above.nqh\"\n#define TONE 440\n", "work/parts/tone.nqh")
        program("#define LENGTH 10\n", "work/above.nqh")
        val file = program(
            "#include \"parts/tone.nqh\"\ntask main() { PlayTone(TONE, LENGTH); }\n",
            "work/whole.nqc",
        )
        assertEquals(0, commandLine.execute(listOf("check", file)), "${console.complaints}")
        assertEquals(0, commandLine.execute(listOf("link", file)), "${console.complaints}")
    }
}
