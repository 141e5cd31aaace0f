package robotran.cli.legofirmware

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import robotran.cli.CommandTest
import kotlin.io.path.readText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests `robotran run` with programs for LEGO's own firmware. */
class NqcRunTest : CommandTest() {
    private val drive = program("task main()\n{\n  OnFwd(OUT_A);\n  Wait(100);\n  Off(OUT_A);\n}\n", "drive.nqc")

    private fun run(vararg arguments: String) = commandLine.execute(listOf("run") + arguments)

    private fun motorLog(vararg arguments: String): List<String> {
        val log = folder.resolve("log.txt")
        val status = run(*arguments, "--rom-log", "$log", "--rom-log-only", "motors")
        assertEquals(0, status, console.complaints.joinToString())
        return log.readText().trimEnd().lines().map { it.substringAfter("; ") }
    }

    private fun reportOf(vararg arguments: String): String {
        console.said.clear()
        assertEquals(0, run(*arguments, "--report", "-"), console.complaints.joinToString())
        return console.said.single()
    }

    private fun brickOf(vararg arguments: String): String {
        console.said.clear()
        assertEquals(0, run(*arguments, "--brick-report", "-"), console.complaints.joinToString())
        return console.said.single()
    }

    @Test
    fun `every NQC example leaves its recorded report and ROM log`() {
        val examples = tree.resolve("examples/nqc").listFiles { file -> file.extension == "nqc" }.orEmpty()
        val records = tree.resolve("shared/programs/src/commonTest/resources/nqc-runs")
        assertTrue(examples.isNotEmpty())
        for (example in examples) {
            val report = folder.resolve("report.json")
            val callLog = folder.resolve("rom.txt")
            assertEquals(0, run(example.path, "--report", "$report", "--rom-log", "$callLog"), example.name)
            val name = example.nameWithoutExtension
            assertEquals(records.resolve("$name.report.json").readText(), report.readText(), name)
            val recordedLog = records.resolve("$name.rom-log.txt")
            if (recordedLog.exists()) assertEquals(recordedLog.readText(), callLog.readText(), name)
        }
    }

    @Test
    fun `the ROM log names the line of each call`() {
        val calls = motorLog(drive).filterNot { it.endsWith("firmware") }
        assertContains(calls, "motor A forward 7 ; 3")
        assertContains(calls, "motor A brake 7 ; 5")
    }

    @Test
    fun `files beside a program can be included, and the ROM log names them`() {
        program("#include \"more/turn.nqh\"\nvoid go()\n{\n  OnFwd(OUT_A);\n  turn();\n}\n", "moves.nqh")
        program("void turn()\n{\n\n  OnRev(OUT_C);\n}\n", "more/turn.nqh")
        val main = program("#include \"moves.nqh\"\ntask main()\n{\n  go();\n  Off(OUT_A + OUT_C);\n}\n", "main.nqc")
        val calls = motorLog(main)
        assertContains(calls, "motor A forward 7 ; moves.nqh:4")
        assertContains(calls, "motor C backward 7 ; turn.nqh:4")
        assertContains(calls, "motor A brake 7 ; main.nqc:5")
    }

    @Test
    fun `a mistake names the file that it is in, and nothing runs`() {
        val header = program("void go()\n{\n  onfwd(OUT_A);\n}\n", "moves.nqh")
        assertEquals(2, run(program("#include \"moves.nqh\"\ntask main()\n{\n  go();\n}\n", "main.nqc")))
        assertTrue(console.complaints.single().startsWith("$header:3:3: "), console.complaints.single())
        assertEquals(emptyList(), console.said)
    }

    @Test
    fun `an included file that is not there is a mistake at its line`() {
        val main = program("\n#include \"gone.nqh\"\ntask main()\n{\n}\n", "main.nqc")
        assertEquals(2, run(main))
        assertTrue(console.complaints.first().startsWith("$main:2:"), console.complaints.first())
    }

    @Test
    fun `an image and assembly text run like the program that they are made of`() {
        val image = folder.resolve("drive.rcx").toString()
        val lasm = folder.resolve("drive.lasm").toString()
        assertEquals(0, commandLine.execute(listOf("build", drive, "-o", image)))
        assertEquals(0, commandLine.execute(listOf("translate", image, "-o", lasm)))
        val poses = listOf(drive, image, lasm).map { reportOf(it).substringAfter("\"pose\"") }
        assertEquals(1, poses.toSet().size)
        assertEquals(motorLog(image), motorLog(lasm))
        assertTrue(motorLog(lasm).any { it.startsWith("motor A forward 7 ; ") && !it.endsWith("; 3") })
    }

    @Test
    fun `a file that is no image is refused with a sentence`() {
        val image = program("no image", "odd.rcx")
        assertEquals(2, run(image))
        assertTrue(console.complaints.single().startsWith("$image: "), console.complaints.single())
    }

    @Test
    fun `Run starts and stops a program as under LEGO's firmware`() {
        val forever = program("task main()\n{\n  OnFwd(OUT_A);\n  while (true);\n}\n", "on.nqc")
        val on = brickOf(forever, "--press", "run@2", "--for", "4")
        assertContains(on, "\"state\": \"running\"")
        val stopped = brickOf(forever, "--press", "run@2", "--press", "run@3", "--for", "5")
        assertContains(stopped, "\"state\": \"stopped\"")
    }

    @Test
    fun `the report of the brick has variables and datalog`() {
        val log = program(
            "int n = 7;\ntask main()\n{\n  CreateDatalog(5);\n  AddToDatalog(n);\n  n = -2;\n  AddToDatalog(n);\n}\n",
            "log.nqc",
        )
        val firmware = Json.parseToJsonElement(brickOf(log)).jsonObject.getValue("firmware").jsonObject
        assertEquals("[7,-2]", firmware.getValue("datalog").toString())
        assertEquals("-2", firmware.getValue("variables").jsonArray.first().toString())
        assertTrue("firmware" !in Json.parseToJsonElement(brickOf(square)).jsonObject)
    }

    @Test
    fun `each program of a brick runs on its own firmware`() {
        val show = program("show 3\nrepeat forever\nend\n", "show.robo")
        val presses = listOf("prgm@1", "run@2").flatMap { listOf("--press", it) }.toTypedArray()
        assertContains(brickOf(drive, show, *presses, "--for", "5"), "\"text\": \"3")
        val calls = motorLog(show, drive, *presses, "--for", "5")
        assertContains(calls, "motor A forward 7 ; 3")
    }

    @Test
    fun `firmware 1 knows less and NQC of version 1 has other names`() {
        val mute = program("task main()\n{\n  MuteSound();\n}\n", "mute.nqc")
        assertEquals(0, run(mute))
        assertEquals(2, run(mute, "--target", "rcx"))
        assertTrue(console.complaints.last().startsWith("$mute:3:3: "), console.complaints.last())
        val old = program("task main()\n{\n  Fwd(OUT_A, 7);\n  Sleep(10);\n  Off(OUT_A);\n}\n", "old.nqc")
        assertEquals(2, run(old))
        assertEquals(0, run(old, "--old-nqc"))
        assertEquals(2, run(mute, "--target", "scout"))
    }

    @Test
    fun `a robot with an NXT refuses it`() {
        assertEquals(2, run(drive, "--world", tree.resolve("worlds/nxt-square.world.json").path))
        assertContains(console.complaints.single(), "This program is for an RCX")
    }

    @Test
    fun `a remark about the run names its line`() {
        val divide = program("int zero = 0;\ntask main()\n{\n  int x = 5;\n  x = x / zero;\n}\n", "divide.nqc")
        assertEquals(0, run(divide))
        assertContains(console.complaints.single(), "Line 5: ")
    }

    @Test
    fun `a link holds a program with what it includes`() {
        program("void go()\n{\n  OnFwd(OUT_A);\n}\n", "moves.nqh")
        val main = program("#include \"moves.nqh\"\ntask main()\n{\n  go();\n  Off(OUT_A);\n}\n", "main.nqc")
        assertEquals(0, commandLine.execute(listOf("link", main)))
        val link = console.said.single()
        assertContains(motorLog(link), "motor A forward 7 ; moves.nqh:3")
    }
}
