package robotran.projects

import java.io.ByteArrayOutputStream
import java.util.zip.DataFormatException
import java.util.zip.Deflater
import java.util.zip.Inflater

actual suspend fun deflate(bytes: ByteArray): ByteArray {
    val deflater = Deflater(Deflater.BEST_COMPRESSION, true)
    try {
        deflater.setInput(bytes)
        deflater.finish()
        val compressed = ByteArrayOutputStream()
        val part = ByteArray(PART)
        while (!deflater.finished()) compressed.write(part, 0, deflater.deflate(part))
        return compressed.toByteArray()
    } finally {
        deflater.end()
    }
}

actual suspend fun inflate(compressed: ByteArray, max: Int): ByteArray? {
    val inflater = Inflater(true)
    try {
        inflater.setInput(compressed)
        val bytes = ByteArrayOutputStream()
        val part = ByteArray(PART)
        while (!inflater.finished()) {
            val length = inflater.inflate(part)
            if (length == 0 && !inflater.finished()) return null
            if (bytes.size() + length > max) return null
            bytes.write(part, 0, length)
        }
        return bytes.toByteArray().takeIf { inflater.remaining == 0 }
    } catch (_: DataFormatException) {
        return null
    } finally {
        inflater.end()
    }
}

private const val PART = 8192
