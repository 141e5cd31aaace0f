package robotran.qrcode

/**
 * A square of light and dark modules that a phone's camera reads (ISO/IEC 18004).
 *
 * @property size modules along a side, without the light margin of [MARGIN] modules that belongs around it.
 */
class QrCode internal constructor(val size: Int, private val dark: BooleanArray) {
    /** Whether the module in [column] and [row], both from 0 at the upper left, is dark. */
    fun isDark(column: Int, row: Int): Boolean = dark[row * size + column]

    companion object {
        /** Light modules that there must be on all sides. */
        const val MARGIN = 4

        /**
         * The most bytes of UTF-8 that [of] makes a code of: more would make modules too small for a camera in front of
         * a screen.
         */
        val MAX_BYTES: Int get() = QrVersion(QrVersion.LARGEST).room

        /** The code that says [text]; null if that is longer than [MAX_BYTES]. */
        fun of(text: String): QrCode? {
            val bytes = text.encodeToByteArray()
            val version = (1..QrVersion.LARGEST).map(::QrVersion).firstOrNull { bytes.size <= it.room } ?: return null
            val modules = QrModules(version)
            modules.fill(version.codewordsOf(bytes))
            return (0..<QrMask.COUNT)
                .map { number -> modules.copy().apply { mask(QrMask(number)) } }
                .minBy { it.penalty() }
                .let { QrCode(version.size, it.darkModules()) }
        }
    }
}
