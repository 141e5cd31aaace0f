package robotran.legofirmware.image

/**
 * The firmware that an image is for. The second runs all images of the first.
 *
 * @property code its number in an image.
 * @property word the word for it on a command line and in messages, as in NQC.
 */
enum class FirmwareTarget(val code: Int, val word: String) {
    /** Firmware 1.0, file version 0309. */
    RCX(0, "RCX"),

    /** Firmware 2.0, file version 0328. */
    RCX2(3, "RCX2"),
    ;

    companion object {
        fun of(code: Int): FirmwareTarget? = entries.find { it.code == code }
    }
}
