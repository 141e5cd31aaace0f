package robotran.rcxrom.routines

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.display.Lcd
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.display.LcdLayout
import robotran.rcxrom.display.SegmentIcons
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.messages.BrickMessages

/**
 * The routines that show and hide the LCD's icons. Most codes are one segment; the men, the infrared range, the circle
 * and the row of dots change together or step by step. Sources: leJOS `rom.h`, brickEmu's ROM re-implementation.
 */
internal class LcdSegmentRoutines(
    private val memory: RcxMemory,
    private val lcd: Lcd,
    private val messages: BrickMessages,
) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.SET_LCD_SEGMENT to { (code) -> set(code) },
        RomAddress.CLEAR_LCD_SEGMENT to { (code) -> clear(code) },
    )

    private fun set(code: Int): RomEffect {
        when (code) {
            RomCode.SEGMENT_STANDING_MAN -> showOneOf(MEN, LcdIcon.STANDING_MAN)
            RomCode.SEGMENT_WALKING_MAN -> showOneOf(MEN, LcdIcon.WALKING_MAN)
            RomCode.SEGMENT_DATALOG -> advance(LcdLayout.CIRCLE_STEP, CIRCLE) { lcd.light(CIRCLE[it - 1], on = true) }
            RomCode.SEGMENT_DOWNLOAD -> advance(LcdLayout.DOTS_STEP, DOTS) { lcd.light(DOTS[it - 1], on = true) }
            RomCode.SEGMENT_UPLOAD -> advance(LcdLayout.DOTS_STEP, DOTS, ::shrinkDots)
            RomCode.SEGMENT_INFRARED_SHORT -> showOneOf(INFRARED, LcdIcon.INFRARED_SHORT)
            RomCode.SEGMENT_INFRARED_LONG -> INFRARED.forEach { lcd.light(it, on = true) }
            RomCode.SEGMENT_ALL -> lcd.lightAll()
            else -> lcd.light(SegmentIcons.single(code) ?: return refused(messages.unknownCode(code)), on = true)
        }
        return RomEffect(messages.segment(code, shown = true))
    }

    private fun clear(code: Int): RomEffect {
        when (code) {
            RomCode.SEGMENT_STANDING_MAN -> lcd.light(LcdIcon.STANDING_MAN, on = false)
            RomCode.SEGMENT_WALKING_MAN -> lcd.light(LcdIcon.WALKING_MAN, on = false)
            RomCode.SEGMENT_DATALOG -> restart(LcdLayout.CIRCLE_STEP, CIRCLE)
            RomCode.SEGMENT_DOWNLOAD, RomCode.SEGMENT_UPLOAD -> restart(LcdLayout.DOTS_STEP, DOTS)

            RomCode.SEGMENT_INFRARED_SHORT, RomCode.SEGMENT_INFRARED_LONG -> INFRARED.forEach {
                lcd.light(it, on = false)
            }

            else -> lcd.light(SegmentIcons.single(code) ?: return refused(messages.unknownCode(code)), on = false)
        }
        return RomEffect(messages.segment(code, shown = false))
    }

    private fun showOneOf(icons: List<LcdIcon>, icon: LcdIcon) {
        icons.forEach { lcd.light(it, on = false) }
        lcd.light(icon, on = true)
    }

    /** Performs the step after the one at [address]. After the last, all [icons] go dark and the steps start again. */
    private fun advance(address: Int, icons: List<LcdIcon>, change: (step: Int) -> Unit) {
        val step = memory.readByte(address) + 1
        if (step > icons.size) {
            restart(address, icons)
        } else {
            memory.writeByte(address, step)
            change(step)
        }
    }

    private fun restart(address: Int, icons: List<LcdIcon>) {
        memory.writeByte(address, 0)
        icons.forEach { lcd.light(it, on = false) }
    }

    private fun shrinkDots(step: Int) =
        if (step == 1) DOTS.forEach { lcd.light(it, on = true) } else lcd.light(DOTS[step - 2], on = false)

    companion object {
        private val MEN = listOf(LcdIcon.STANDING_MAN, LcdIcon.WALKING_MAN)
        private val INFRARED = listOf(LcdIcon.INFRARED_SHORT, LcdIcon.INFRARED_LONG)
        private val CIRCLE = listOf(
            LcdIcon.DATALOG_TOP_RIGHT,
            LcdIcon.DATALOG_BOTTOM_RIGHT,
            LcdIcon.DATALOG_BOTTOM_LEFT,
            LcdIcon.DATALOG_TOP_LEFT,
        )
        private val DOTS = listOf(LcdIcon.DOT_1, LcdIcon.DOT_2, LcdIcon.DOT_3, LcdIcon.DOT_4, LcdIcon.DOT_5)
    }
}
