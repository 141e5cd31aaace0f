package robotran.cli.hub

import robotran.brick.kind.BrickKind
import robotran.cli.CommandTest
import robotran.hublink.program.HubProgram
import robotran.hublink.program.MpyFile
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull

class HubProgramTest : CommandTest() {
    private fun run(vararg arguments: String) = commandLine.execute(arguments.toList())

    @Test
    fun `a program becomes Python for a hub`() {
        assertEquals(0, run("translate", square, "--to", "python", "--brick", "spike-prime"))
        assertContains(console.said.single(), "from pybricks.hubs import PrimeHub")
        assertContains(console.said.single(), "    robot.straight(200)")
    }

    @Test
    fun `a hub alone says that Python is meant, and the Python goes to a file`() {
        val python = folder.resolve("square.py")
        assertEquals(0, run("translate", square, "--brick", "ev3", "-o", "$python"))
        assertContains(python.readText(), "from pybricks.hubs import EV3Brick")
        assertEquals(emptyList(), console.said)
    }

    @Test
    fun `Python without a hub, and a hub with Java, are refused`() {
        assertEquals(2, run("translate", square, "--to", "python"))
        assertEquals(2, run("translate", square, "--to", "java", "--brick", "spike-prime"))
        assertEquals(2, run("translate", square, "--to", "python", "--brick", "nxt"))
        assertEquals(2, run("translate", square, "--brick", "spike-prime", "--kit", "$folder/kit.zip"))
        assertContains(console.complaints.removeLast(), "--kit goes with Java only")
        console.complaints.forEach {
            assertContains(it, "--to python and a hub, such as --brick spike-prime or microbit, go together")
        }
    }

    @Test
    fun `the hub that a program names needs no option`() {
        val spike = program("robot\n  brick spike\nend\nforward 10")
        assertEquals(0, run("translate", spike), console.complaints.joinToString())
        assertContains(console.said.single(), "robot.straight(100)")
        assertEquals(0, run("translate", spike, "--to", "python"))
        val file = folder.resolve("mine.mpy")
        assertEquals(0, run("build", spike, "-o", "$file"), console.complaints.joinToString())
        assertNotNull(HubProgram.read(file.readBytes()))
        assertEquals(2, run("translate", spike, "--to", "java"))
        assertEquals(2, run("translate", spike, square, "--to", "nqc"))
    }

    @Test
    fun `every hub that is told can be chosen`() {
        for (hub in BrickKind.entries.filter { it.isHub }) {
            assertEquals(0, run("translate", square, "--brick", hub.word), console.complaints.joinToString())
        }
    }

    @Test
    fun `what a hub cannot do is told with its line, and the Python leaves it out`() {
        val program = program("wait until right bumper\nbeep")
        assertEquals(1, run("translate", program, "--brick", "spike-prime"))
        assertContains(console.complaints.first(), "mine.robo:1:")
        assertContains(console.said.single(), "hub.speaker.beep()")
    }

    @Test
    fun `a program is built as a hub takes it`() {
        val file = folder.resolve("square.mpy")
        assertEquals(0, run("build", square, "--brick", "spike-prime", "-o", "$file"), "${console.complaints}")
        val program = assertNotNull(HubProgram.read(file.readBytes()))
        assertNotNull(MpyFile.read(program.modules.single().mpy))
        assertContains(console.said.last(), "$file is written. The program has ${file.readBytes().size} bytes.")
    }

    @Test
    fun `the listing of a program for a hub is its Python`() {
        assertEquals(0, run("build", square, "--brick", "spike-prime", "--listing"))
        assertContains(console.said[console.said.size - 2], "    robot.straight(200)")
    }

    @Test
    fun `what a hub cannot do is not built`() {
        val file = folder.resolve("loud.mpy")
        assertEquals(1, run("build", program("show loudness"), "--brick", "spike-prime", "-o", "$file"))
        assertFalse(file.exists())
    }

    @Test
    fun `a program is checked as one for its hub`() {
        assertEquals(0, run("check", square, "--brick", "spike-prime"), console.complaints.joinToString())
        assertEquals(1, run("check", program("show loudness"), "--brick", "spike-prime"))
        assertContains((console.said + console.complaints).last(), "This hub has no sound sensor.")
    }

    @Test
    fun `a program runs on a robot with a hub`() {
        val robot = "${tree.resolve("worlds/spike-penbot.robot.json")}"
        assertEquals(0, run("run", square, "--robot-file", robot), console.complaints.joinToString())
        assertEquals(2, run("run", program("show loudness"), "--robot-file", robot))
        assertContains(console.complaints.joinToString("\n"), "This hub has no sound sensor.")
    }

    @Test
    fun `a program that asks for a distance is for the robot with a distance sensor`() {
        assertEquals(0, run("translate", program("show distance"), "--brick", "spike-prime"))
        assertContains(console.said.single(), "UltrasonicSensor(Port.F)")
    }

    @Test
    fun `an image is for a brick that takes images`() {
        assertEquals(0, run("build", square, "--brick", "rcx"))
        assertEquals(2, run("build", square, "--brick", "nxt"))
        assertContains(console.complaints.last(), "this goes with --brick rcx, spike-prime, ")
    }

    @Test
    fun `a program with a mistake is refused as elsewhere`() {
        assertEquals(1, run("build", program("forwards 20"), "--brick", "spike-prime"))
        assertContains(console.complaints.first(), "mine.robo:1:1:")
        assertEquals(2, run("build", square, square.replace("square", "star"), "--brick", "spike-prime"))
    }

    @Test
    fun `all examples can be built for a SPIKE Prime, apart from those that need two bumpers`() {
        val examples = tree.resolve("examples").listFiles().orEmpty().filter { it.extension == "robo" }.sorted()
        val refused = examples.filter { run("build", it.path, "--brick", "spike-prime") != 0 }
        assertEquals(examples.filter { "right bumper" in it.readText() }, refused)
        console.complaints.forEach { assertContains(it, "This robot has no such bumper.") }
    }
}
