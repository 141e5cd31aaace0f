package robotran.robolang.python

import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** What goes wrong on a hub without an error, and how the Python keeps clear of it. */
class PythonTrapsTest {
    @Test
    fun `a turn to the right is positive`() {
        assertEquals(listOf("robot.turn(90)", "robot.turn(-90)"), mainLinesOf("turn right 90\nturn left 90"))
        assertContains(mainLinesOf("start turning left\nstop"), "robot.drive(0, -TURN_RATE)")
    }

    @Test
    fun `centimetres become millimetres and seconds milliseconds, both whole`() {
        val lines =
            mainLinesOf(
                "forward 2.5\nbackward 20\nwait 0.3 seconds\nforward for 1.5 seconds\nvar d = 0.5\nd = d * 3\nforward d",
            )
        assertEquals(listOf("robot.straight(25)", "robot.straight(-200)", "wait(300)"), lines.drop(1).take(3))
        assertContains(lines, "wait(1500)")
        assertContains(lines, "robot.straight(round(10 * d))")
    }

    @Test
    fun `to stop is to brake, and the last line of a drawing waits until the robot stands`() {
        assertEquals(listOf("robot.brake()"), mainLinesOf("stop"))
        assertEquals("wait(200)  # Until the robot stands.", mainLinesOf("pen down\nforward 20").last())
        assertEquals("pen_up()", mainLinesOf("pen down\nforward 20\npen up").last())
    }

    @Test
    fun `a drive that goes on is braked at the end`() {
        assertEquals("robot.brake()", mainLinesOf("start forward\nwait 1 second").last())
        assertEquals(1, mainLinesOf("start forward\nwait 1 second\nstop").count { it == "robot.brake()" })
    }

    @Test
    fun `a drive ends near its goal, which is told`() {
        assertTrue(notesOf("forward 20").any { "near enough" in it })
    }

    @Test
    fun `many short moves are told`() {
        assertTrue(notesOf("repeat until light < 40\n  forward 1\nend").any { "start forward" in it })
        assertFalse(notesOf("repeat until light < 40\n  forward 10\nend").any { "start forward" in it })
    }

    @Test
    fun `in a task all that takes time is awaited, and nothing else`() {
        val lines = mainLinesOf(
            "whenever left bumper\n  beep\nend\nfunction dark()\n  return light < 40\nend\n" +
                "repeat until dark()\n  forward 10\n  wait 1 second\nend\nshow turned A\nhalt",
        ).map { it.trim() }
        val expected = listOf(
            "return await left_bumper.touched()",
            "await hub.speaker.beep()",
            "async def dark():",
            "return await light_sensor.reflection() < 40",
            "while not await dark():",
            "await robot.straight(100)",
            "await wait(1000)",
            "show(left_motor.angle())",
        )
        for (line in expected) assertContains(lines, line)
        assertFalse(lines.any { "await show" in it || "await left_motor" in it })
    }

    @Test
    fun `a function that only computes stays plain in a program with tasks`() {
        val lines =
            mainLinesOf(
                "whenever left bumper\n  stop\nend\nfunction double(x)\n  return x * 2\nend\nforward double(3)\nhalt",
            )
        assertContains(lines, "def double(x):")
        assertContains(lines.map { it.trim() }, "await robot.straight(10 * double(3))")
    }

    @Test
    fun `what calls something that waits waits, too`() {
        val source = "whenever left bumper\n  stop\nend\nprocedure a()\n  b()\nend\nprocedure b()\n  c()\nend\n" +
            "procedure c()\n  forward 10\nend\na()\nhalt"
        val lines = mainLinesOf(source)
        for (name in "abc") assertContains(lines, "async def $name():")
        for (name in "abc") assertContains(lines.map { it.trim() }, "await $name()")
    }

    @Test
    fun `devices are made before the tasks, each once`() {
        val lines = pythonLinesOf("whenever left bumper\n  turn left 90\nend\nforward 20\nhalt")
        val made = lines.filter { "Motor(" in it || "DriveBase(" in it || "ForceSensor(" in it }
        assertEquals(4, made.distinct().size)
        assertEquals(4, made.size)
        assertTrue(lines.indexOf(made.last()) < lines.indexOfFirst { it.startsWith("run_task") })
    }

    @Test
    fun `whole numbers are divided towards zero`() {
        assertEquals(listOf("A = 7", "show(A // 2)"), mainLinesOf("const a = 7\nshow a / 2"))
        assertContains(mainLinesOf("var a = 7\na = a - 9\nshow a / 2\nshow a mod 2"), "show(divide(a, 2))")
        assertContains(mainLinesOf("var a = 7\na = a - 9\nshow a mod 2"), "show(remainder(a, 2))")
        assertContains(mainLinesOf("show 7 / 2.0"), "show(7 / 2.0)")
        assertFalse(mainLinesOf("show 7 / 2").any { "def divide" in it })
    }

    @Test
    fun `numbers beyond 31 bits are refused with what to do`() {
        for (source in listOf("show 1073741824", "var a = -1073741825\nshow a")) {
            val note = pythonOf(source).notes.first { it.isLost }
            assertContains(note.message, "Use a smaller number")
        }
        assertTrue(pythonOf("show 1073741823").isComplete)
    }

    @Test
    fun `a comparison that is compared has brackets`() {
        assertContains(
            mainLinesOf("var x = 1\nvar ready = true\nif (x < 3) == ready\n  beep\nend"),
            "if (x < 3) == ready:",
        )
        assertContains(mainLinesOf("var x = 1\nif not (x < 3) == false\n  beep\nend"), "if not (x < 3) == False:")
        assertContains(mainLinesOf("var x = 3\nshow -(x - 1) mod 2").last(), "show(remainder(-(x - 1), 2))")
    }

    @Test
    fun `names that Python or the translation needs get an underscore`() {
        val lines = mainLinesOf("var class = 1\nvar list = 2\nvar hub = 3\nshow class + list + hub")
        val expected = listOf("class" to 1, "list" to 2, "hub" to 3).map { (name, value) ->
            "${name}_ = $value  # in Robolang: $name"
        }
        assertEquals(expected, lines.take(3))
        assertEquals("hub = 3", mainLinesOf("var hub = 3\nshow hub", essentialRobot).first())
    }

    @Test
    fun `letters beyond ASCII stay`() {
        assertContains(mainLinesOf("var größe = 3\nforward größe"), "robot.straight(10 * größe)")
    }

    @Test
    fun `an empty block has pass, also one with a comment alone`() {
        val lines = mainLinesOf("if light < 40\n  // nothing\nelse\n  beep\nend")
        assertEquals(listOf("    # nothing", "    pass"), lines.subList(1, 3))
        assertTrue(pythonLinesOf("repeat 2 times\n  beep\nend").none { '\t' in it })
    }

    @Test
    fun `a hub without speaker, display or buttons is not asked for them`() {
        val python = pythonOf("beep\nshow 3\nshow \"HI\"\nclear screen", essentialRobot).python
        for (part in listOf(".speaker", ".display", ".screen")) assertFalse(part in python, python)
        assertContains(python, "blink(100)")
        assertContains(notesOf("beep", essentialRobot).single(), "no speaker")
    }

    @Test
    fun `what a hub lacks is a mistake in the program, with what to do instead`() {
        assertEquals(
            "This hub has no such button. Use \"button enter\".",
            mistakeOf("if button left\n  beep\nend", essentialRobot),
        )
        assertEquals(
            "This hub has no such button. Use \"button enter\", \"button left\" or \"button right\".",
            mistakeOf("wait until button escape", bumperRobot),
        )
        assertContains(mistakeOf("show loudness", bumperRobot), "This hub has no sound sensor.")
    }

    @Test
    fun `firmware of before 4 has all that is called`() {
        val python = pythonOf("forward 20\nstop\nshow sqrt(2)").python
        assertFalse(".hold()" in python)
        assertContains(python, "from umath import sqrt")
    }

    @Test
    fun `a loop that waits for nothing waits for a moment`() {
        assertContains(mainLinesOf("repeat forever\n  show light\nend"), "    wait(10)")
        assertContains(mainLinesOf("wait until light < 40"), "    wait(10)")
        assertFalse(mainLinesOf("var x = 9\nrepeat while x > 0\n  x = x - 1\nend").any { "wait" in it })
        val skipping = mainLinesOf("repeat forever\n  if light < 40\n    continue\n  end\n  show light\nend")
        assertEquals("    wait(10)", skipping[1])
    }

    @Test
    fun `nothing keeps a program from being stopped`() {
        for ((name, source) in recordedPythonSources) {
            assertFalse("except" in pythonOf(source, hubRobotFor(source)).python, name)
        }
    }

    @Test
    fun `letters one after the other are told`() {
        assertTrue(notesOf("show \"HELLO\"").any { "one letter after the other" in it })
        assertContains(mainLinesOf("show \"A\""), "hub.display.char(\"A\")")
    }

    @Test
    fun `a motor whose degrees count begins with 0`() {
        assertContains(pythonLinesOf("motor A turn 90\nshow turned A"), "left_motor.reset_angle(0)")
        assertFalse(pythonOf("motor A turn 90").python.contains("reset_angle"))
        assertFalse(pythonOf("motor A turn 90\nshow turned A", nxtRobot).python.contains("reset_angle"))
    }

    @Test
    fun `the button in the middle is free for a program that asks for it`() {
        assertContains(pythonLinesOf("wait until button enter"), "hub.system.set_stop_button(Button.BLUETOOTH)")
        assertContains(pythonLinesOf("wait until button enter", essentialRobot), "hub.system.set_stop_button(None)")
        assertFalse(pythonOf("wait until button enter", nxtRobot).python.contains("set_stop_button"))
        assertContains(
            pythonOf("wait until button escape", ev3Robot).notes.first {
                it.isLost
            }.message,
            "Use another button",
        )
    }

    @Test
    fun `power 0 is no speed that a hub refuses`() {
        assertContains(mainLinesOf("power 0\nforward 10"), "robot.settings(straight_speed=20, turn_rate=20)")
        assertTrue(notesOf("power 0\nforward 10").any { "power 0" in it })
    }

    @Test
    fun `power 7 is no more than the motors of a hub can do`() {
        assertContains(mainLinesOf("power 7\nforward 10"), "robot.settings(straight_speed=411, turn_rate=420)")
        assertContains(
            mainLinesOf("power 7\nforward 10", ev3Robot),
            "robot.settings(straight_speed=390, turn_rate=400)",
        )
        val program = "power 2 + 5\nstart forward"
        assertContains(pythonOf(program).python, "    power = max(power, 1 / 3)\n")
        assertContains(pythonOf(program, ev3Robot).python, "    speed = min(round(58.643 * power), 390)\n")
    }

    private fun mistakeOf(source: String, robot: RobotTarget.Hub): String {
        val result = compileRobolang("test.robo", source, robot, RobolangMessages.of(Language.ENGLISH))
        return (result as RobolangResult.Failure).diagnostics.single().message
    }

    private fun notesOf(source: String, robot: RobotTarget.Hub = bumperRobot) = pythonOf(source, robot).notes.map {
        it.message
    }
}
