package robotran.cli.run

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import robotran.cli.CommandTest
import kotlin.io.path.readText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class PressTest : CommandTest() {
    /** Presses the buttons and returns the brick report. */
    private fun press(text: String, vararg presses: String, status: Int = 0): Brick {
        val file = folder.resolve("brick.json")
        val arguments =
            listOf("run", program(text), "--brick-report", "$file") + presses.flatMap { listOf("--press", it) }
        assertEquals(status, commandLine.execute(arguments), console.complaints.joinToString())
        return Brick(Json.parseToJsonElement(file.readText()).jsonObject)
    }

    private class Brick(private val json: JsonObject) {
        val poweredOn = json.getValue("poweredOn").jsonPrimitive.content.toBoolean()
        val state = json.getValue("state").jsonPrimitive.content
        val explanation = json.getValue("explanation").jsonPrimitive.content
        val lcd = json.getValue("lcd").jsonObject.getValue("text").jsonPrimitive.content
        val icons = json.getValue("lcd").jsonObject.getValue("icons").jsonArray.map { it.jsonPrimitive.content }
        val sounds = json.getValue("sounds").jsonArray.map { it.jsonObject }
        val inputs = json.getValue("inputs").jsonArray.map { it.jsonObject }

        fun pitches() = sounds.mapNotNull { it["hertz"]?.jsonPrimitive?.content?.toDouble()?.toInt() }

        private fun time(event: JsonObject) = event.getValue("milliseconds").jsonPrimitive.content.toLong()

        fun inputTimes() = inputs.map { it.getValue("at").jsonPrimitive.content.toLong() }
    }

    @Test
    fun `a brick that is only looked at shows its volts, program 0 and the standing man, after two beeps`() {
        val brick = press(FOREVER, "view@0.5")
        assertEquals("9.0 0", brick.lcd)
        assertEquals(listOf("standing man"), brick.icons)
        assertEquals(listOf(1000, 1000), brick.pitches())
        assertEquals("idle", brick.state)
    }

    @Test
    fun `a program starts when Run is let go and the walking man walks`() {
        val early = press(FOREVER, "run@1+5", "view@3", status = 0)
        assertEquals(listOf(1000L, 3000L, 3100L, 6000L), early.inputTimes())
        assertEquals("running", early.state)
        assertEquals(listOf("walking man"), early.icons)
    }

    @Test
    fun `nothing but the presses is done, so without Run no program starts`() {
        assertEquals("idle", press("beep", "view@1").state)
    }

    @Test
    fun `Prgm beeps and stays at the only program`() {
        val brick = press(FOREVER, "prgm@1", "prgm@2")
        assertEquals("9.0 0", brick.lcd)
        assertEquals(listOf(1000, 1000, 2000, 2000), brick.pitches())
    }

    @Test
    fun `On-Off switches the brick off with one beep, and on again with two`() {
        val off = press(FOREVER, "run@1", "on-off@2")
        assertEquals(false, off.poweredOn)
        assertEquals("", off.lcd)
        assertEquals(emptyList(), off.icons)
        assertEquals(2000, off.pitches().last())
        val on = press(FOREVER, "run@1", "on-off@2", "on-off@4")
        assertTrue(on.poweredOn)
        assertEquals("idle", on.state)
        assertEquals("9.0 0", on.lcd)
        assertEquals(listOf(1000, 1000), on.pitches().takeLast(2))
    }

    @Test
    fun `On-Off while Run is held ends the program, and the brick stays on`() {
        val brick = press(FOREVER, "run@1", "run@2+1", "on-off@2.4")
        assertTrue(brick.poweredOn)
        assertEquals("stopped", brick.state)
        assertEquals("9.0 0", brick.lcd)
        assertEquals(listOf("standing man"), brick.icons)
        assertEquals(listOf(1000, 1000), brick.pitches().takeLast(2))
    }

    @Test
    fun `the buttons belong to the program while it runs`() {
        val brick = press(FOREVER, "run@1", "prgm@2", "view@3", "run@4")
        assertEquals("running", brick.state)
        assertEquals(listOf(1000, 1000), brick.pitches())
    }

    @Test
    fun `a program that fails buzzes, shows its line and says what it means, until On-Off is pressed`() {
        val failed = press(FAILING, "run@1", status = 1)
        assertEquals("failed", failed.state)
        assertEquals(100, failed.pitches().last())
        assertContains(failed.lcd, "2")
        assertContains(failed.icons, "sensor 1 view")
        assertContains(failed.explanation, "Press On-Off")
        val left = press(FAILING, "run@1", "on-off@4", status = 1)
        assertEquals("9.0 0", left.lcd)
        assertEquals("null", left.explanation)
    }

    @Test
    fun `eight minutes after the last button the brick switches itself off`() {
        val file = program(FOREVER)
        val report = folder.resolve("brick.json")

        fun poweredOn(vararg rest: String): Boolean {
            val arguments = listOf("run", file, "--for", "600", "--brick-report", "$report", "--press", "prgm@1")
            assertEquals(0, commandLine.execute(arguments + rest))
            return Brick(Json.parseToJsonElement(report.readText()).jsonObject).poweredOn
        }
        assertTrue(poweredOn("--press", "view@480"))
        assertEquals(false, poweredOn("--press", "view@482"))
    }

    @Test
    fun `the same presses make the same run`() {
        val presses = arrayOf("run@1", "on-off@5", "on-off@6", "run@7.25+0.3")
        val reports = List(2) {
            val arguments =
                listOf("run", program("forward 5"), "--report", "-") + presses.flatMap { listOf("--press", it) }
            console.said.clear()
            assertEquals(0, commandLine.execute(arguments))
            console.said.single()
        }
        assertEquals(reports[0], reports[1])
    }

    @Test
    fun `presses that cannot be understood are refused in a sentence`() {
        for ((press, word) in listOf(
            "go@1" to "go",
            "run" to "run",
            "run@soon" to "soon",
            "run@-1" to "-1",
            "run@1+x" to "x",
            "run@1+0" to "0",
        )) {
            console.complaints.clear()
            assertEquals(2, commandLine.execute(listOf("run", program("beep"), "--press", press)), press)
            assertContains(console.complaints.single(), word)
        }
    }

    @Test
    fun `presses that cannot be done are refused in a sentence`() {
        for ((presses, words) in listOf(
            listOf("run@70") to "run@70 comes after the end of the run",
            listOf("run@1+3", "run@2") to "run@2 comes while run@1+3 still holds the button down",
        )) {
            console.complaints.clear()
            assertEquals(
                2,
                commandLine.execute(
                    listOf("run", program("beep")) + presses.flatMap {
                        listOf("--press", it)
                    },
                ),
            )
            assertContains(console.complaints.single(), words)
        }
    }

    private companion object {
        const val FOREVER = "repeat forever\n  wait 2 seconds\nend"
        const val FAILING = "var zero = 0\nshow 5 / zero"
    }
}
