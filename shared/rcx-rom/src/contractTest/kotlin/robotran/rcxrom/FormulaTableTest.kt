package robotran.rcxrom

import robotran.rcxrom.sensors.Battery
import robotran.rcxrom.sensors.SensorReading
import robotran.rcxrom.sound.ToneTimer
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Compares every formula over its whole input with the tables of `resources/tables`. */
class FormulaTableTest {
    private fun table(name: String): List<List<Int>> =
        formulaTables.getValue(name).trim().lines().drop(1).map { row -> row.split(' ').map(String::toInt) }

    private fun rawTable(name: String): List<List<Int>> =
        table(name).also { rows -> assertEquals((0..1023).toList(), rows.map { it.first() }) }

    @Test
    fun `percent of every raw value`() {
        for ((raw, percent) in rawTable("percent.txt")) assertEquals(percent, SensorReading.percent(raw), "raw $raw")
    }

    @Test
    fun `temperatures of every raw value`() {
        for ((raw, celsius, fahrenheit) in rawTable("temperature.txt")) {
            assertEquals(celsius to fahrenheit, SensorReading.celsius(raw) to SensorReading.fahrenheit(raw), "raw $raw")
        }
    }

    @Test
    fun `the place of a rotation sensor at every raw value`() {
        for ((raw, place) in rawTable("angle.txt")) {
            assertEquals(place, SensorReading.anglePosition(raw) ?: -1, "raw $raw")
        }
    }

    @Test
    fun `volts of every raw value`() {
        for ((raw, millivolts, tenths) in rawTable("battery.txt")) {
            assertEquals(millivolts to tenths, Battery.millivolts(raw) to Battery.screenTenths(raw), "raw $raw")
        }
    }

    @Test
    fun `what the timer counts for every frequency`() {
        val rows = table("tones.txt")
        assertEquals(0, rows.first()[0])
        assertEquals(0xFFFF, rows.last()[1])
        rows.zipWithNext().forEach { (row, next) -> assertEquals(row[1] + 1, next[0]) }
        for ((from, to, count, control) in rows) {
            for (hertz in from..to) {
                val sound = ToneTimer.sound(hertz, duration = 9)
                assertEquals(Triple(count, 9, control), Triple(sound.kind, sound.value, sound.control), "$hertz Hz")
            }
        }
    }

    @Test
    fun `the real frequency is never below the one asked for and hardly above it`() {
        for (hertz in 31..20_000) {
            val real = checkNotNull(realHertz(hertz))
            assertTrue(real >= hertz && real < hertz * 1.02, "$hertz Hz become $real")
        }
    }

    @Test
    fun `the boolean value at every raw value and slope from either side`() {
        for (slope in 0..31) {
            for (raw in 0..1023) {
                for (before in 0..1) {
                    val boolean = SensorReading.boolean(raw, before, rawBefore = raw, modeAndSlope = slope)
                    assertEquals(expectedBoolean(raw, before, slope), boolean, "raw $raw, slope $slope, $before before")
                }
            }
        }
    }

    /** The expected result for a constant raw value. */
    private fun expectedBoolean(raw: Int, before: Int, slope: Int): Int {
        val (lowest, highest) = if (slope == 0) 460 to 563 else slope to 1023 - slope
        return if (raw < lowest) {
            1
        } else if (raw > highest) {
            0
        } else {
            before
        }
    }
}
