package robotran.nqc.api

import robotran.legofirmware.image.FirmwareTarget

/** The names that every NQC program has: functions, values and constants of the brick. */
object NqcApi {
    /**
     * The entries for [target] by name, in the order in which a list of them makes sense.
     *
     * @param isOld whether the API is that of NQC 1.3.
     */
    fun of(target: FirmwareTarget, isOld: Boolean = false): Map<String, NqcApiEntry> = Prelude.of(target, isOld).entries
}
