package robotran.legofirmware

import robotran.legofirmware.assembly.CommandForm
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.hexByte
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.OpcodeUse
import robotran.legofirmware.instructions.ValueSource
import robotran.legofirmware.model.Assumptions
import robotran.legofirmware.run.BrickScript
import kotlin.test.Test
import kotlin.test.assertEquals

/** `docs/lego-firmware.md` agrees with the code. */
class DocumentTest {
    private val rows = documents.getValue("lego-firmware.md").lines().filter { it.startsWith("| ") }
        .map { row -> row.trim('|').split('|').map { it.trim().trim('`') } }

    @Test
    fun `its programs do what their comments say`() {
        assertEquals(PROGRAMS, documentedPrograms.size)
        documentedPrograms.forEach { (place, source) -> BrickScript(place, source).run() }
    }

    @Test
    fun `it has every command with its form, its firmware and where it is valid`() {
        val written = rows.filter { it.size == 5 && it[0].startsWith("0x") }.map { it.take(4) }
        val known = Opcode.entries.map {
            val use = when (it.use) {
                OpcodeUse.ANYWHERE -> "both"
                OpcodeUse.PROGRAM -> "program"
                OpcodeUse.REQUEST -> "request"
            }
            listOf("0x${hexByte(it.code)}", CommandForm(it).toString(), versionOf(it.firmware), use)
        }
        assertEquals(known, written)
    }

    @Test
    fun `it has every source`() {
        val written = rows.filter { it.size == 6 && it[0].toIntOrNull() != null }.map { it.take(4) }
        val known = ValueSource.entries.map {
            listOf("${it.code}", it.listingName, versionOf(it.firmware), if (it.isWritable) "yes" else "")
        }
        assertEquals(known, written)
    }

    @Test
    fun `it has the constants that were decided`() {
        val decided = mapOf(
            "TASK_PRIORITY" to Assumptions.TASK_PRIORITY,
            "DISPLAY_MILLISECONDS" to Assumptions.DISPLAY_MILLISECONDS,
            "STEP_MILLISECONDS" to Assumptions.STEP_MILLISECONDS,
            "BATTERY_MILLISECONDS" to Assumptions.BATTERY_MILLISECONDS,
            "EVENT_MILLISECONDS" to Assumptions.EVENT_MILLISECONDS,
            "CALIBRATION_MILLISECONDS" to Assumptions.CALIBRATION_MILLISECONDS,
            "CLICK_TIME" to Assumptions.CLICK_TIME,
            "LOW_BATTERY_MILLIVOLTS" to Assumptions.LOW_BATTERY_MILLIVOLTS,
            "LOOP_COUNT" to Assumptions.LOOP_COUNT,
            "UNKNOWN_VALUE" to Assumptions.UNKNOWN_VALUE,
            "RANDOM_SEED" to Assumptions.RANDOM_SEED,
        ).mapValues { "${it.value}" }
        val written = rows.filter { it.size == 3 && it[0].matches(Regex("[A-Z_]{4,}")) }.associate { it[0] to it[1] }
        assertEquals(decided, written)
    }

    private fun versionOf(target: FirmwareTarget): String = if (target == FirmwareTarget.RCX) "1.0" else "2.0"

    private companion object {
        const val PROGRAMS = 5
    }
}
