package robotran.hublink

/** The version of a firmware, such as 4.0.1, or of the protocol that it speaks, such as 1.5.0. */
data class HubVersion(val major: Int, val minor: Int, val patch: Int = 0) : Comparable<HubVersion> {
    override fun compareTo(other: HubVersion) = compareValuesBy(this, other, { it.major }, { it.minor }, { it.patch })

    override fun toString() = "$major.$minor.$patch"

    companion object {
        /** Reads a text such as `4.1.0b2`, whose end behind the numbers does not count; null if it is no version. */
        fun read(text: String): HubVersion? {
            val parts = text.trim('\u0000', ' ').split('.').take(PARTS)
            val numbers = parts.map { part -> part.takeWhile { it in '0'..'9' }.toIntOrNull() ?: return null }
            return if (numbers.size < 2) null else HubVersion(numbers[0], numbers[1], numbers.getOrElse(2) { 0 })
        }

        private const val PARTS = 3
    }
}

/** What a version of the protocol has. Sources: Pybricks' technical information and the firmware, see `docs/hub-link.md`. */
object Profile {
    /** The first one that we speak, that of firmware 3.2. */
    val OLDEST = HubVersion(1, 2)

    /** Printed text comes as an event; before, over another service. */
    val WITH_OUTPUT = HubVersion(1, 3)

    /** A start names its slot. */
    val WITH_SLOTS = HubVersion(1, 4)

    /** The last one that we know. */
    val NEWEST = HubVersion(1, 6)

    /** The first firmware that speaks [OLDEST]. */
    val OLDEST_FIRMWARE = HubVersion(3, 2)
}
