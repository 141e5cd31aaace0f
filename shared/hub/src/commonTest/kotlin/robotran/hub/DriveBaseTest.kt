package robotran.hub

import robotran.hub.control.BaseScale
import robotran.hub.model.HubMotorKind
import robotran.hub.model.HubPort
import robotran.hub.program.DriveBaseSettings
import robotran.hub.program.HubCall
import robotran.hub.program.HubError
import robotran.hub.program.HubNative
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Driving bases against what Pybricks' own virtual hub did: times to 20 ms, ways to 3 mm and 2 degrees. */
class DriveBaseTest {
    private val bench = HubBench().apply { makeBase() }
    private val base = bench.base

    @Test
    fun `default speeds follow from motors, wheels and track as in Pybricks`() {
        val rows = driveBases.getValue("drive-bases.txt").lines().filter { it.isNotBlank() }
        assertEquals(21, rows.size)
        for (row in rows) {
            val words = row.split(' ')
            val n = words.drop(1).map { it.toDouble() }
            val kind = HubMotorKind.valueOf(words[0])
            val scale = BaseScale((n[0] * 1000).toInt(), (n[1] * 1000).toInt(), kind.highestSpeed)
            val known = DriveBaseSettings(n[2].toInt(), n[3].toInt(), n[4].toInt(), n[5].toInt())
            assertEquals(known, scale.defaults, row)
            assertEquals(n[6].toInt() to n[7].toInt(), scale.straightLimit to scale.turnLimit, row)
        }
    }

    @Test
    fun `settings are kept within limits, without their sign`() {
        assertEquals(DriveBaseSettings(195, 733, 166, 750), base.settings)
        assertEquals(null, bench.call(HubNative.DRIVE_BASE_SETTINGS, 200, 90))
        assertEquals(DriveBaseSettings(200, 733, 90, 750), base.settings)
        assertEquals(HubError.INVALID_ARGUMENT, bench.call(HubNative.DRIVE_BASE_SETTINGS, 2000, 90))
        assertEquals(HubError.INVALID_ARGUMENT, bench.call(HubNative.DRIVE_BASE_SETTINGS, 0, 90))
        assertEquals(null, bench.call(HubNative.DRIVE_BASE_SETTINGS, -100, 90))
        assertEquals(100, base.settings.straightSpeed)
        assertEquals(HubError.BUSY, bench.hub.call(HubCall.driveBase(HubPort.A, HubPort.B, 56_000, 112_000), TEST_LINE))
        assertEquals(
            HubError.INVALID_ARGUMENT,
            bench.hub.call(HubCall.driveBase(HubPort.A, HubPort.A, 56_000, 112_000), TEST_LINE),
        )
    }

    @Test
    fun `straights and turns take as long and end where they do with Pybricks`() {
        val moves = recorded("17-drive-moves").filter { Regex("(straight|turn) -?[0-9.]+ [0-9]+ \\(.*").matches(it) }
            .takeWhile { !it.startsWith("straight 100.9") }
        assertEquals(9, moves.size)
        var turned = 0.0
        val told = moves.map { line ->
            val (word, amount, time) = line.split(' ')
            move(word, amount.toInt())
            val took = bench.until { base.isDone }
            if (word == "turn") turned += amount.toInt()
            val state = numbersOf(line.substringAfter('('))
            val isNear = abs(took - time.toInt()) <= 20 && abs(base.distance - state[0]) <= 3 &&
                abs(base.angle - state[4]) <= 2
            if (isNear) "" else "$line: here $took ${base.distance} ${base.angle}"
        }
        assertEquals("", told.filter { it.isNotEmpty() }.joinToString("\n"))
        assertNear(turned, base.angle, 2.0, "all turns")
    }

    @Test
    fun `a slower straight takes longer`() {
        bench.call(HubNative.DRIVE_BASE_SETTINGS, 100, 166)
        bench.call(HubNative.DRIVE_BASE_STRAIGHT, 200)
        assertNear(2165.0, bench.until { base.isDone }.toDouble(), 20.0, "milliseconds")
    }

    @Test
    fun `a straight, a turn and a drive go through the same places at the same times`() {
        val parts = recorded("18-drive-trace")
        val told = follow(parts, "straight 200") { bench.call(HubNative.DRIVE_BASE_STRAIGHT, 200) } +
            follow(parts, "turn 90") { bench.call(HubNative.DRIVE_BASE_TURN, 90) } +
            follow(parts, "drive 150 45") { bench.call(HubNative.DRIVE_BASE_DRIVE, 150, 45) } +
            follow(parts, "stop") { bench.call(HubNative.DRIVE_BASE_STOP) }
        assertEquals("", told.joinToString("\n"))
    }

    /** The lines below [title] that are not so here. */
    private fun follow(lines: List<String>, title: String, command: () -> Unit): List<String> {
        val rows = lines.dropWhile { it != title }.drop(1).takeWhile { it[0].isDigit() }
        assertTrue(rows.isNotEmpty(), title)
        command()
        val begin = bench.milliseconds
        return rows.mapNotNull { row ->
            val (time, distance, speed, angle, rate) = numbersOf(row)
            bench.wait((begin + time.toInt() - bench.milliseconds).toInt())
            val isNear = abs(base.distance - distance) <= 3 && abs(base.angle.toInt() - angle) <= 2 &&
                abs(base.speed - speed) <= 25 && abs(base.turnRate - rate) <= 25
            if (isNear) null else "$title $row: here ${base.distance} ${base.speed} ${base.angle} ${base.turnRate}"
        }
    }

    @Test
    fun `a driving robot stops within the way that it needs with Pybricks`() {
        for ((native, way) in listOf(HubNative.DRIVE_BASE_STOP to 3, HubNative.DRIVE_BASE_BRAKE to 4)) {
            val line = recorded("19-drive-stops").first { it.startsWith(if (way == 3) "stop" else "brake") }
            assertTrue(line.contains("[$way, $way, "), line)
            bench.call(HubNative.DRIVE_BASE_DRIVE, 200, 0)
            bench.wait(1000)
            val at = base.distance
            bench.call(native)
            bench.wait(300)
            assertNear(way.toDouble(), (base.distance - at).toDouble(), 3.0, native.words)
            assertTrue(base.isDone)
        }
    }

    @Test
    fun `moves that follow each other do not add up their errors`() {
        repeat(4) {
            bench.call(HubNative.DRIVE_BASE_STRAIGHT, 100)
            bench.until { base.isDone }
            bench.call(HubNative.DRIVE_BASE_TURN, 90)
            bench.until { base.isDone }
        }
        val (distance, angle) = numbersOf(recorded("19-drive-stops").first { it.startsWith("square hold") })
        assertNear(distance, base.distance.toDouble(), 3.0, "distance")
        assertNear(angle, base.angle, 2.0, "angle")
    }

    @Test
    fun `a motor that is commanded by itself ends the drive, and the other rolls`() {
        val (left, right) = bench.motor(HubPort.A) to bench.motor(HubPort.B)
        bench.call(HubNative.DRIVE_BASE_DRIVE, 200, 0)
        val drive = base.commands
        bench.wait(500)
        assertTrue(left.speed > 300 && right.speed > 300 && base.isDone)
        bench.on(HubNative.MOTOR_BRAKE, HubPort.A)
        assertTrue(base.commands > drive)
        bench.wait(500)
        assertEquals(0 to 0, left.speed to right.speed)
        bench.on(HubNative.MOTOR_RUN, HubPort.A, 200)
        bench.on(HubNative.MOTOR_RUN, HubPort.B, 400)
        bench.wait(500)
        assertNear(199.0, left.speed.toDouble(), 10.0, "left")
        assertNear(399.0, right.speed.toDouble(), 10.0, "right")
        assertTrue(base.speed > 0 && base.turnRate < 0)
        bench.call(HubNative.DRIVE_BASE_STRAIGHT, 50)
        assertFalse(base.isDone)
        bench.until { base.isDone }
        assertTrue(base.isDone)
    }

    @Test
    fun `a square with a pen takes as long as with Pybricks`() {
        val lines = recorded("30-square-with-pen")
        val begin = bench.milliseconds
        bench.make(HubPort.C)
        pen(90)
        near(lines[0], begin, bench.motor(HubPort.C).angle.toDouble())
        for (side in 1..4) {
            move("straight", 200)
            bench.until { base.isDone }
            move("turn", -90)
            bench.until { base.isDone }
            val (_, time, distance, angle) = numbersOf(lines[side])
            assertNear(time, (bench.milliseconds - begin).toDouble(), 20.0 * (2 * side + 1), "side $side")
            assertNear(distance, base.distance.toDouble(), 3.0, "side $side")
            assertNear(angle, base.angle, 2.0, "side $side")
        }
        pen(0)
    }

    private fun pen(angle: Int) {
        bench.on(HubNative.MOTOR_RUN_TARGET, HubPort.C, 300, angle, 0)
        bench.until { bench.motor(HubPort.C).isDone }
    }

    private fun near(line: String, begin: Long, angle: Double) {
        val (time, known) = numbersOf(line)
        assertNear(time, (bench.milliseconds - begin).toDouble(), 20.0, line)
        assertNear(known, angle, 4.0, line)
    }

    private fun move(word: String, amount: Int) =
        bench.call(if (word == "turn") HubNative.DRIVE_BASE_TURN else HubNative.DRIVE_BASE_STRAIGHT, amount)
}
