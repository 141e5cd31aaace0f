package robotran.lejoslinker.config

import robotran.tinyvm.config.LejosVersion

/** The order of the bytes of two-byte numbers in an image's tables. Bytecode is big-endian in both. */
enum class ByteOrder {
    /** Of a brick. */
    BIG_ENDIAN,

    /** Of leJOS's emulator on a PC. */
    LITTLE_ENDIAN,
}

/**
 * How to link an image.
 *
 * @property version the firmware that the image is for. Images for all versions are the same; their room is not.
 * @property keepsAllMethods whether methods stay that nothing can call.
 * @property isTrimmed whether everything is left out that the program does not need: classes, methods, static fields,
 * texts and numbers. leJOS's own linker keeps much of it.
 */
data class ImageOptions(
    val version: LejosVersion = LejosVersion.DEFAULT,
    val byteOrder: ByteOrder = ByteOrder.BIG_ENDIAN,
    val keepsAllMethods: Boolean = false,
    val isTrimmed: Boolean = false,
)
