package robotran.rcxrom.display

import robotran.rcxrom.call.RomCode

/** Maps the codes of the ROM's segment routines to display icons. */
internal object SegmentIcons {
    private val SINGLE_ICONS: Map<Int, LcdIcon> = buildMap {
        for (code in RomCode.SEGMENT_SENSOR_1_VIEW..RomCode.SEGMENT_MOTOR_C_FORWARD) {
            put(code, LcdIcon.entries[LcdIcon.SENSOR_1_VIEW.ordinal + code - RomCode.SEGMENT_SENSOR_1_VIEW])
        }
        put(RomCode.SEGMENT_LOW_BATTERY, LcdIcon.LOW_BATTERY)
    }

    /** The icon that [code] switches on or off; null if [code] changes several. */
    fun single(code: Int): LcdIcon? = SINGLE_ICONS[code]

    /** The single icon that [code] refers to; null for codes of several icons and for unknown codes. */
    fun of(code: Int): LcdIcon? = when (code) {
        RomCode.SEGMENT_STANDING_MAN -> LcdIcon.STANDING_MAN
        RomCode.SEGMENT_WALKING_MAN -> LcdIcon.WALKING_MAN
        RomCode.SEGMENT_INFRARED_SHORT -> LcdIcon.INFRARED_SHORT
        RomCode.SEGMENT_INFRARED_LONG -> LcdIcon.INFRARED_LONG
        else -> single(code)
    }
}
