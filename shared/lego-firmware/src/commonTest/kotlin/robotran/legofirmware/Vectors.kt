package robotran.legofirmware

import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.RcxImageResult
import robotran.legofirmware.image.readRcxImage

/** Programs with the images and listings that the original NQC compiler made of them. */
internal object Vectors {
    /** Names such as `06-loops.rcx2`. */
    val names: List<String> = vectorFiles.keys.filter { it.endsWith(".hex") }.map { it.removeSuffix(".hex") }.sorted()

    fun bytes(name: String): ByteArray = hexBytes(vectorFiles.getValue("$name.hex"))

    fun image(name: String): RcxImage = (readRcxImage(bytes(name)) as RcxImageResult.Success).image

    /** The text of the file [name]; null if there is none. */
    fun text(name: String): String? = vectorFiles[name]
}

/** The bytes of [text]: two hexadecimal digits each, separated by blanks and line ends. */
internal fun hexBytes(text: String): ByteArray =
    text.split(' ', '\n').filter { it.isNotEmpty() }.map { it.toInt(16).toByte() }.toByteArray()
