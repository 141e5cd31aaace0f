package robotran.robolang.python

import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The shapes of a program: plain, and with tasks if it has a `whenever`. */
class PythonShapesTest {
    @Test
    fun `constants and variables that functions use are above them, in capitals if they never change`() {
        val lines =
            mainLinesOf("const stepWidth = 5\nvar n = 0\nprocedure go()\n  n = n + stepWidth\nend\ngo()\nforward n")
        val expected = listOf(
            "STEP_WIDTH = 5",
            "n = 0",
            "def go():",
            "    global n",
            "    n = n + STEP_WIDTH",
            "go()",
            "robot.straight(10 * n)",
        )
        assertEquals(expected, lines)
    }

    @Test
    fun `what a declaration calls is above it`() {
        val lines = mainLinesOf("var n = twice(2)\nfunction twice(x)\n  return x * 2\nend\nforward n")
        assertEquals(listOf("def twice(x):", "    return x * 2", "n = twice(2)"), lines.take(3))
    }

    @Test
    fun `decimal numbers stay decimal wherever they come from`() {
        val lines =
            mainLinesOf("var n = 3\nvar d = 0.5\nd = 2\nd = n\nvar list = [1, 2.5]\nlist[0] = 2\nshow list[0] + d")
        val expected = listOf(
            "n = 3",
            "d = 0.5",
            "d = 2.0",
            "d = float(n)",
            "list_ = [1.0, 2.5]  # in Robolang: list",
            "list_[0] = 2.0",
        )
        assertEquals(expected, lines.take(expected.size))
    }

    @Test
    fun `ranges are those of Python`() {
        assertContains(mainLinesOf("for i from 1 to 5\n  beep\nend"), "for i in range(1, 6):")
        assertContains(mainLinesOf("for i from 10 to 1 step -3\n  beep\nend"), "for i in range(10, 0, -3):")
        assertContains(mainLinesOf("const n = 3\nfor i from 0 to n - 1\n  beep\nend"), "for i in range(N):")
        val overList = "var all = [1, 2]\nfor i from 0 to length(all) - 1\n  show all[i]\nend"
        assertContains(mainLinesOf(overList), "for i in range(len(all)):")
        val unknown = "var s = 2\ns = s - 4\nfor i from 5 to 1 step s\n  beep\nend"
        assertContains(pythonLinesOf(unknown), "for i in count(5, 1, s):")
    }

    @Test
    fun `a loop over decimal numbers counts also before continue`() {
        val lines = mainLinesOf("for d from 0.5 to 2\n  if d < 1\n    continue\n  end\n  show d\nend")
        val expected = listOf(
            "d = 0.5",
            "while d <= 2:",
            "    if d < 1:",
            "        d = d + 1",
            "        continue",
            "    show(d)",
            "    d = d + 1",
        )
        assertEquals(expected, lines)
    }

    @Test
    fun `the lines of a behaviour that a later one can take over from end then`() {
        val lines =
            mainLinesOf(
                "whenever left bumper\n  backward 5\n  turn left 90\nend\nwhenever light < 40\n  beep\nend\nhalt",
            )
        val place = lines.indexOf("async def when_left_bumper():")
        val expected = listOf(
            "    await robot.straight(-50)",
            "    if acting != 1:",
            "        return",
            "    await robot.turn(-90)",
        )
        assertEquals(expected, lines.subList(place + 1, place + 5))
        assertContains(lines.map { it.trim() }, "whenever(2, is_light, when_light),")
    }

    @Test
    fun `a main program with tasks goes on for ever unless it halts`() {
        val endless = mainLinesOf("whenever left bumper\n  beep\nend\nforward 10")
        assertContains(endless, "        await wait(1000)")
        assertTrue(mainLinesOf("whenever left bumper\n  beep\nend\nforward 10\nhalt").none { "1000" in it })
    }

    @Test
    fun `a variable that has to be waited for is there before the tasks begin`() {
        val lines = mainLinesOf("var d = distance\nwhenever left bumper\n  show d\nend\nhalt", sonarRobot)
        assertContains(lines, "d = 0")
        assertContains(lines, "    d = await distance()")
        assertContains(lines, "    global d")
        assertTrue(lines.indexOf("d = 0") < lines.indexOf("run_task("))
    }

    @Test
    fun `powers of single wheels are speeds of single motors`() {
        val lines = mainLinesOf("power left 2\nstart forward\nwait 1 second\nstop")
        val expected = listOf(
            "right_speed = 360",
            "left_speed = 240",
            "left_motor.run(left_speed)",
            "right_motor.run(right_speed)",
            "wait(1000)",
            "left_motor.brake()",
            "right_motor.brake()",
        )
        assertEquals(expected, lines)
    }

    @Test
    fun `a power that changes while the robot drives takes effect at once`() {
        val lines = pythonLinesOf("start forward\nwait 1 second\npower 5\nwait 1 second\nstop")
        val place = lines.indexOf("    robot.settings(straight_speed=speed, turn_rate=turn_rate)")
        assertEquals("    if not robot.done():", lines[place + 1])
        assertEquals("        robot.drive(speed, 0)", lines[place + 2])
        assertTrue(pythonLinesOf("power 5\nforward 20").none { "done" in it })
        assertTrue(pythonLinesOf("power 5\nforward for 1 second").none { "done" in it })
    }

    @Test
    fun `a wheel whose power changes while it turns goes on with it`() {
        val lines = mainLinesOf("power left 2\nstart forward\nwait 1 second\npower right 5\nwait 1 second")
        val expected = listOf(
            "right_speed = 360",
            "left_speed = 240",
            "left_motor.run(left_speed)",
            "right_motor.run(right_speed)",
            "wait(1000)",
            "right_speed = 600",
            "run_on(right_motor, right_speed)",
        )
        assertEquals(expected, lines.take(expected.size))
    }

    @Test
    fun `a robot that drives more than one way remembers which`() {
        val base = pythonLinesOf("start forward\nwait 1 second\nstart turning left\npower 5\nwait 1 second")
        assertContains(base, "ahead, turn = 0, -1")
        assertContains(base, "        robot.drive(ahead * speed, turn * turn_rate)")
        val motors = mainLinesOf("motor B forward\nwait 1 second\nmotor B backward\nmotor B power 5", nxtRobot)
        assertContains(motors, "way_b = -1")
        assertContains(motors, "run_on(pen_motor, way_b * speed_b)")
    }

    @Test
    fun `single motors are told with those of the wheels`() {
        val notes = pythonOf("motor C forward").notes.map { it.message }
        assertContains(notes, "The wheels of this robot are motors A and B.")
    }
}
