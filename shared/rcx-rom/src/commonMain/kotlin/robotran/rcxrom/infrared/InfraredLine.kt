package robotran.rcxrom.infrared

/**
 * Plain bytes over infrared light, past the ROM: what josx `LLC` works with. Once begun, the brick takes in each byte
 * that it sees, and the ROM neither sends nor receives messages until its serial port is initialized again. None of
 * these is a ROM call. Source: leJOS `llc.c`.
 */
interface InfraredLine {
    /** Takes the serial port from the ROM, with nothing received and nothing to send. */
    fun begin()

    /** Starts sending [bytes], each 0..255, in place of what is being sent. */
    fun write(bytes: List<Int>)

    /** The oldest received byte, 0..255; -1 if there is none. */
    fun read(): Int

    /** Whether bytes are still being sent. */
    val isSending: Boolean

    /** Whether the bytes written last met other light, so that the rest of them was not sent. */
    val hasCollided: Boolean

    companion object {
        /** A line on which nothing is sent or received. */
        val DARK: InfraredLine = object : InfraredLine {
            override fun begin() = Unit

            override fun write(bytes: List<Int>) = Unit

            override fun read(): Int = NOTHING

            override val isSending: Boolean get() = false
            override val hasCollided: Boolean get() = false
        }

        /** What [read] returns if no byte is there. */
        const val NOTHING = -1
    }
}
