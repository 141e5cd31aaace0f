package robotran.nqc.api

import robotran.legofirmware.image.FirmwareTarget

/** The names that every NQC program has: functions, values and constants of the brick. */
object NqcApi {
    private val now: List<NqcApiEntry> = OUTPUT_API + SENSOR_API + SOUND_API + DISPLAY_API + DATALOG_API + TIME_API +
        EVENT_API + MESSAGE_API + TASK_API + SERIAL_API + REMOTE_API + OTHER_API

    private val entries = mapOf(false to now, true to OLD_API).mapValues { (_, all) ->
        FirmwareTarget.entries.associateWith { target -> all.filter { target in it.targets }.associateBy { it.name } }
    }

    /**
     * The entries for [target] by name, in the order in which a list of them makes sense.
     *
     * @param isOld whether the API is that of NQC 1.3.
     */
    fun of(target: FirmwareTarget, isOld: Boolean = false): Map<String, NqcApiEntry> =
        entries.getValue(isOld).getValue(target)
}
