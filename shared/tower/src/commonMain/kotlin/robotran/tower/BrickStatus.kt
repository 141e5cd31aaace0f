package robotran.tower

/**
 * What a brick says that it is. leJOS and a brick without firmware say the same: only the beginning of a program
 * download tells them apart, and that deletes the program on the brick.
 */
sealed interface BrickStatus {
    /** leJOS's firmware, or none. */
    data class LejosOrNoFirmware(val rom: RcxVersion) : BrickStatus

    /** LEGO's firmware. [millivolts] is null if the brick did not tell it. */
    data class LegoFirmware(val rom: RcxVersion, val firmware: RcxVersion, val millivolts: Int?) : BrickStatus

    /** It answers, but does not tell its versions: another kind of brick, or another firmware. */
    data object Unknown : BrickStatus
}

/** A version as the brick tells it: 3.1 for the ROM, 3.32 for a firmware. */
data class RcxVersion(val major: Int, val minor: Int) : Comparable<RcxVersion> {
    override fun compareTo(other: RcxVersion) = compareValuesBy(this, other, { it.major }, { it.minor })

    override fun toString() = "$major.$minor"
}
