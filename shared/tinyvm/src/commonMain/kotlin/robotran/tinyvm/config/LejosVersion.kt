package robotran.tinyvm.config

/**
 * The release of leJOS that a program is run as.
 *
 * @property label as pupils write it.
 * @property avoidsPriorityInversion whether a thread that holds a monitor runs in place of a more important one that
 * waits for it.
 */
enum class LejosVersion(val label: String, internal val avoidsPriorityInversion: Boolean) {
    V2_1("2.1", avoidsPriorityInversion = false),
    V3_0("3.0", avoidsPriorityInversion = true),
    ;

    companion object {
        /** The last release. */
        val DEFAULT: LejosVersion = V3_0

        /** The version with this [label], null if there is none. */
        fun of(label: String): LejosVersion? = entries.find { it.label == label }
    }
}
