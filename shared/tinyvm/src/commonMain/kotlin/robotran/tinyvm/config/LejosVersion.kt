package robotran.tinyvm.config

/**
 * The release of leJOS that a program is for. They differ in their classes and in the memory that their firmware leaves
 * ([BrickRoom]); their virtual machines run a program alike.
 *
 * @property label as pupils write it.
 */
enum class LejosVersion(val label: String) {
    V2_1("2.1"),
    V3_0("3.0"),
    ;

    companion object {
        /** The last release. */
        val DEFAULT: LejosVersion = V3_0

        /** The version with this [label], null if there is none. */
        fun of(label: String): LejosVersion? = entries.find { it.label == label }
    }
}
