package robotran.qrcode

/**
 * A square of light and dark modules for a phone's camera (ISO/IEC 18004).
 *
 * @property size modules per side, without the required light margin of [MARGIN] modules.
 */
class QrCode internal constructor(val size: Int, private val dark: BooleanArray) {
    /** Whether the module is dark; [column] and [row] are from 0 at the upper left. */
    fun isDark(column: Int, row: Int): Boolean = dark[row * size + column]

    companion object {
        /** Required light modules on all sides. */
        const val MARGIN = 4

        /**
         * Max UTF-8 length of a text for [of]: a longer one would make the modules too small for a camera in front of a
         * screen.
         */
        val MAX_BYTES: Int get() = QrVersion(QrVersion.MAX_VERSION).room

        /** The code for [text]; null if it is longer than [MAX_BYTES]. */
        fun of(text: String): QrCode? {
            val bytes = text.encodeToByteArray()
            val version =
                (1..QrVersion.MAX_VERSION).map(::QrVersion).firstOrNull { bytes.size <= it.room } ?: return null
            val modules = QrModules(version)
            modules.fill(version.codewordsOf(bytes))
            return (0..<QrMask.COUNT)
                .map { number -> modules.copy().apply { mask(QrMask(number)) } }
                .minBy { it.penalty() }
                .let { QrCode(version.size, it.darkModules()) }
        }
    }
}
