package robotran.microbitlink.image

/**
 * A file with MicroPython, as it is published. A file is one of these if its checksum is that of [sha256].
 *
 * @property v1 the version for V1, null if it holds none.
 * @property v2 the version for V2, null if it holds none.
 */
enum class MicroPythonRelease(val v1: String?, val v2: String?, private val sha256: String) {
    V1_1_1("1.1.1", null, "d3686e669677d456ece9d206a44b8acbe73ddf73e1a3211ff89b93972b953152"),
    V2_1_2(null, "2.1.2", "66fae07b71777e9e3a6b5122a27930b24cc0be5002ab9a67e92494c54a1645ef"),
    BOTH("1.1.1", "2.1.2", "06790e5a2bfc09c2d4a4a7a223fb93c456a3741b17fdd65f5042b9d9c9d61c6c"),

    /** Built by Debian: it has half of the room for files. */
    V1_0_1_OF_DEBIAN("1.0.1", null, "b76c8e56b4566d7bcb3607ffa5402639b106e4784a0711c45c3573d90d85e9d5"),
    ;

    companion object {
        /** The release with the [text]; null if we do not know it, or if it was changed. */
        fun of(text: String): MicroPythonRelease? {
            val sum = sha256(text.encodeToByteArray())
            return entries.firstOrNull { it.sha256 == sum }
        }
    }
}
