package robotran.programs

import robotran.rcxrom.RcxBrick
import robotran.rcxrom.call.RomCall
import kotlin.io.encoding.Base64

/** What leJOS's own linker and machine were given, and what they made of it. */
internal object OriginalCalls {
    /** The class files of the library and of the programs by internal name. */
    val library: Map<String, ByteArray> by lazy { classFiles("library.txt") }
    val programs: Map<String, ByteArray> by lazy { classFiles("programs.txt") }

    /** The images for a brick by the name of the program, or of several. */
    val images: Map<String, ByteArray> by lazy { classFiles("images-be.txt") }

    /** The ROM calls of each program. */
    val calls: Map<String, OriginalRun> by lazy {
        originalRuns.filterKeys { it.endsWith(".txt") }.entries.associate { (file, text) ->
            file.removeSuffix(".txt") to runOf(text)
        }
    }

    private fun classFiles(file: String): Map<String, ByteArray> =
        vectorFiles.getValue(file).lines().filter { it.isNotEmpty() }.associate { line ->
            line.substringBefore(' ') to Base64.decode(line.substringAfter(' '))
        }

    private fun runOf(text: String): OriginalRun {
        val (notes, calls) = text.lines().filter { it.isNotEmpty() }.partition { it.startsWith("#") }
        return OriginalRun(
            calls.map { line ->
                val words = line.split(' ')
                val arguments = words.drop(2).map { it.toInt() and WORD }
                TimedCall(words[0].toLong(), RomCall(words[1].removePrefix("0x").toInt(radix = 16), arguments))
            },
            notes.mapNotNull { EXCEPTION.find(it)?.groupValues?.get(1)?.toInt() },
            isCut = notes.any { "cut" in it },
        )
    }

    private const val WORD = 0xFFFF
    private val EXCEPTION = Regex("uncaught exception of class ([0-9]+)")
}

/** What the sensors measured when the original machine ran: a light plain sheet below, and nothing in the way. */
internal fun originalSensors(brick: RcxBrick, time: Long) {
    if (time == 0L) listOf(1023, 697, 1023).forEachIndexed { port, raw -> brick.setRawSensorValue(port, raw) }
}

/**
 * @property exceptions the numbers of the classes of exceptions that nobody caught.
 * @property isCut whether the program made more calls.
 */
internal class OriginalRun(val calls: List<TimedCall>, val exceptions: List<Int>, val isCut: Boolean)
