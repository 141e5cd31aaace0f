package robotran.cli.run

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.double
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import robotran.cli.CommandTest
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class NxtRunTest : CommandTest() {
    private fun run(vararg arguments: String) = commandLine.execute(listOf("run") + arguments)

    private fun said(vararg arguments: String): JsonObject {
        console.said.clear()
        assertEquals(0, run(*arguments), console.complaints.joinToString())
        return Json.parseToJsonElement(console.said.single()).jsonObject
    }

    private val hello get() = nxjProgram(
        "Hello",
        """
        System.out.println("Hello");
        LCD.drawString("World", 2, 3);
        Button.waitForAnyPress();
        LCD.clear();
        """,
    )

    @Test
    fun `a program with imports of lejos runs on an NXT and the report has the display`() {
        val report = said(hello, "--report", "-", "--for", "5")
        assertEquals("running", report.getValue("status").jsonPrimitive.content)
        val screen = report.getValue("screen").jsonArray.map { it.jsonPrimitive.content }
        assertEquals(listOf("Hello", "", "", "  World"), screen.take(4))
        assertEquals(8, screen.size)
    }

    @Test
    fun `the buttons of an NXT can be pressed`() {
        val report = said(hello, "--report", "-", "--press", "enter@1", "--press", "escape@2")
        assertEquals("ended", report.getValue("status").jsonPrimitive.content)
        val again = said(hello, "--report", "-", "--for", "4", "--press", "enter@1")
        assertEquals("running", again.getValue("status").jsonPrimitive.content)
    }

    @Test
    fun `a button of the other brick is refused in a sentence`() {
        assertEquals(2, run(hello, "--press", "run@1"))
        assertEquals(
            "An NXT has no button run. Its buttons are enter, left, right and escape.",
            console.complaints.single(),
        )
        console.complaints.clear()
        assertEquals(2, run(square, "--press", "escape@1"))
        assertEquals(
            "An RCX has no button escape. Its buttons are on-off, view, prgm and run.",
            console.complaints.single(),
        )
    }

    @Test
    fun `memory and groups of calls of an RCX are refused in a sentence`() {
        assertEquals(2, run(hello, "--memory", "-"))
        assertEquals("The robot has an NXT: only the memory of an RCX can be shown.", console.complaints.single())
        console.complaints.clear()
        assertEquals(2, run(hello, "--rom-log", "-", "--rom-log-only", "display,infrared"))
        assertContains(console.complaints.single(), "An NXT has no calls of a group infrared.")
        console.complaints.clear()
        assertEquals(2, run(square, "--rom-log", "-", "--rom-log-only", "bluetooth"))
        assertContains(console.complaints.single(), "An RCX has no calls of a group bluetooth.")
    }

    @Test
    fun `the log has the calls of the NXT with the lines of the program`() {
        assertEquals(0, run(hello, "--rom-log", "-", "--rom-log-only", "display", "--for", "2"))
        val line = console.said.single().lines().single { "drawString" in it }
        assertTrue(Regex("""\d+ drawString "World" 2 3 .* ; 8""").matches(line), line)
        console.said.clear()
        val table = folder.resolve("log.csv")
        assertEquals(0, run(hello, "--rom-log", "$table", "--for", "2"))
        assertContains(table.toFile().readText(), "drawString")
    }

    @Test
    fun `the brick report has screen and degrees`() {
        val turn = nxjProgram("Turn", "Motor.B.rotate(90);\nLCD.drawInt(7, 0, 0);\nButton.waitForAnyPress();")
        val report = said(turn, "--brick-report", "-", "--for", "4")
        assertFalse("lcd" in report)
        assertEquals("7", report.getValue("screen").jsonArray.first().jsonPrimitive.content)
        val degrees = report.getValue("motors").jsonObject.getValue("B").jsonObject.getValue("degrees").jsonPrimitive
        assertTrue(abs(degrees.double - 90) <= 1, degrees.toString())
        assertEquals(4, report.getValue("sensors").jsonArray.size)
        val presses = report.getValue("inputs").jsonArray.map { it.jsonObject.getValue("button").jsonPrimitive.content }
        assertEquals(listOf("enter", "enter"), presses)
    }

    @Test
    fun `a square of a pilot ends where it began`() {
        val square = nxjProgram(
            "Square",
            """
            DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
            for (int side = 0; side < 4; side++) {
                pilot.travel(20);
                pilot.rotate(90);
            }
            """,
        )
        val start = said(nxjProgram("Stand", "Delay.msDelay(10);"), "--report", "-").getValue("pose").jsonObject
        val pose = said(square, "--report", "-").getValue("pose").jsonObject
        for (axis in listOf("x", "y")) {
            val moved = pose.getValue(axis).jsonPrimitive.double - start.getValue(axis).jsonPrimitive.double
            assertTrue(abs(moved) < 1.0, "$axis $moved")
        }
    }

    @Test
    fun `an exception in main fails with its line`() {
        val failing = nxjProgram("Fails", "int[] numbers = new int[2];\nnumbers[2] = 1;")
        assertEquals(1, run(failing))
        assertContains(console.complaints.first(), "Line 8: Nobody caught the ArrayIndexOutOfBoundsException.")
    }

    @Test
    fun `Robolang whose header names an NXT runs on one`() {
        val robolang = program("robot\n  brick nxt\nend\nshow 42\nwait 2 seconds\nforward 5 cm")
        val report = said(robolang, "--report", "-", "--for", "1")
        assertEquals("42", report.getValue("screen").jsonArray.first().jsonPrimitive.content.trim())
    }

    @Test
    fun `a program for an NXT in a world with an RCX is refused at its import`() {
        val plain = tree.resolve("worlds/plain.world.json").path
        assertEquals(2, run(hello, "--world", plain))
        assertEquals(
            "$hello:1:8: This program is for an NXT, but the robot has an RCX. Give it to a robot with an NXT.",
            console.complaints.single(),
        )
    }

    @Test
    fun `a robot file gives the robot of a world another brick`() {
        val plain = tree.resolve("worlds/plain.world.json").path
        val robot = tree.resolve("worlds/nxt-penbot.robot.json").path
        assertEquals(0, run(hello, "--world", plain, "--robot-file", "yellow=$robot", "--for", "1"))
        console.complaints.clear()
        assertEquals(2, run(hello, "--robot-file", "green=$robot"))
        assertEquals(
            "No robot in this world is called green. There is only one, called yellow.",
            console.complaints.single(),
        )
        console.complaints.clear()
        assertEquals(2, run(hello, "--robot-file", "yellow=missing.robot.json"))
        assertContains(console.complaints.single(), "missing.robot.json")
    }
}
