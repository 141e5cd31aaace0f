package robotran.cli.files

import robotran.cli.CommandTest
import java.nio.file.Path
import kotlin.io.path.createLinkPointingTo
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** What commands write never costs anything that was there. */
class OutputsTest : CommandTest() {
    private val maze = tree.resolve("worlds/maze.world.json").readText()

    /** Runs the command, which must refuse with one sentence and leave all files as they are. */
    private fun refusal(vararg arguments: String): String {
        console.complaints.clear()
        val before = contents()
        assertEquals(2, commandLine.execute(arguments.toList()), "${arguments.toList()}: ${console.complaints}")
        assertEquals(before, contents(), "${arguments.toList()}")
        return console.complaints.single()
    }

    private fun contents() = folder.toFile().walk().filter {
        it.isFile
    }.associate { it.path to it.readBytes().toList() }

    @Test
    fun `no command writes over what it reads`() {
        val robolang = program("beep\n")
        val nqc = program("#include \"part.nqh\"\ntask main() { PlaySound(1); }\n", "sound.nqc")
        val part = program("#define X 1\n", "part.nqh")
        val java = javaProgram("Mine", "Sound.beep();")
        val world = program(maze, "a.world.json")
        val inputs = mapOf(
            robolang to listOf(
                listOf("run", robolang, "--report"),
                listOf("run", robolang, "--rom-log"),
                listOf("run", robolang, "--memory"),
                listOf("run", robolang, "--brick-report"),
                listOf("grade", world, robolang, "--csv"),
                listOf("grade", world, robolang, "--html"),
                listOf("grade", world, robolang, "--junit"),
                listOf("grade", world, square, "--robot", "red=$robolang", "--report"),
                listOf("translate", robolang, "-o"),
                listOf("translate", robolang, "--kit"),
                listOf("build", robolang, "-o"),
                listOf("package", robolang, "-o"),
            ),
            nqc to listOf(listOf("build", nqc, "-o"), listOf("translate", nqc, "-o")),
            part to listOf(listOf("build", nqc, "-o"), listOf("run", nqc, "--report")),
            java to listOf(listOf("translate", java, "--kit"), listOf("run", java, "--report")),
            world to listOf(
                listOf("run", robolang, "--world", world, "--report"),
                listOf("grade", world, robolang, "--report"),
            ),
        )
        for ((input, commands) in inputs) {
            for (command in commands) {
                val described = refusal(*command.toTypedArray(), input)
                assertEquals(
                    "$input is read by this command, so nothing is written there. Choose another name for the result.",
                    described,
                    "$command",
                )
            }
        }
    }

    @Test
    fun `another name of the same file does not help`() {
        val mine = program("beep\n")
        val hard = folder.resolve("hard.txt").createLinkPointingTo(Path.of(mine)).toString()
        val soft = folder.resolve("soft.txt").createSymbolicLinkPointingTo(Path.of(mine)).toString()
        for (name in listOf(hard, soft, "$folder/../${folder.name}/mine.robo")) {
            assertContains(refusal("run", mine, "--report", name), "is read by this command")
        }
    }

    @Test
    fun `a folder of hand-ins takes results, but not in place of a hand-in`() {
        val world = program(maze, "a.world.json")
        val handIn = program("forward 10\n", "class/Ida/mine.robo")
        assertContains(refusal("grade", world, "$folder/class", "--csv", handIn), "is read by this command")
        console.complaints.clear()
        repeat(2) {
            commandLine.execute(listOf("grade", world, "$folder/class", "--csv", "$folder/class/grades.csv"))
            assertTrue(console.complaints.none { "is read by this command" in it }, "${console.complaints}")
            assertContains(folder.resolve("class/grades.csv").readText(), "Ida")
        }
    }

    @Test
    fun `two results do not go to one file`() {
        val described = refusal("run", program("beep\n"), "--report", "$folder/x.txt", "--memory", "$folder/./x.txt")
        assertContains(described, "Two results would go to")
    }

    @Test
    fun `a link is not followed to another file`() {
        val precious = program("Beep\n", "precious.robo")
        val link = folder.resolve("link.robo").createSymbolicLinkPointingTo(Path.of("precious.robo")).toString()
        assertEquals(
            "$link is a link to precious.robo. To change that file, use its own name.",
            refusal("format", link),
        )
        assertContains(refusal("translate", square, "-o", link), "is a link to")
        assertEquals("Beep\n", Path.of(precious).readText())
    }

    @Test
    fun `a result leaves nothing beside it`() {
        assertEquals(0, commandLine.execute(listOf("run", square, "--report", "$folder/out/report.json")))
        assertEquals(listOf("report.json"), folder.resolve("out").listDirectoryEntries().map { it.name })
        assertEquals(0, commandLine.execute(listOf("format", program("  Beep\n"))))
        assertEquals("beep\n", folder.resolve("mine.robo").readText())
    }

    @Test
    fun `a full disk is told, and a device is written as it is`() {
        assertEquals(2, commandLine.execute(listOf("translate", square, "-o", "/dev/full")))
        assertContains(console.complaints.single(), "/dev/full could not be written: the disk is full.")
        assertEquals(0, commandLine.execute(listOf("translate", square, "-o", "/dev/null")))
    }

    @Test
    fun `a picture is a kind that can be drawn`() {
        for (name in listOf("x.jpg", "x.JPEG", "x.pdf", "x.png.gif")) {
            assertEquals(
                "$folder/$name cannot be written: a picture can be .png or .svg.",
                refusal("run", square, "--picture", "$folder/$name"),
            )
        }
        for (name in listOf("x.png", "x.SVG", "x")) {
            assertEquals(0, commandLine.execute(listOf("run", square, "--picture", "$folder/$name")))
        }
    }
}
