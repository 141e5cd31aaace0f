package robotran.mpycompiler

import com.dylibso.chicory.runtime.Memory
import java.io.ByteArrayOutputStream

/** The files of one run of the compiler: its source, what it writes, and what it prints. */
internal class MpyCrossFiles(private val name: String, private val source: ByteArray) {
    private val output = ByteArrayOutputStream()
    private val words = ByteArrayOutputStream()
    private var place = 0

    /** The file that it has written; empty if it has not. */
    val written: ByteArray get() = output.toByteArray()

    /** What it has printed about mistakes. */
    val printed: String get() = words.toByteArray().decodeToString()

    /** Opens the file [path] and returns its number, or the error "no such file". */
    fun open(path: String, flags: Int): Long = when {
        flags and ACCESS != 0 -> OUTPUT
        path == name -> SOURCE.also { place = 0 }
        else -> NO_SUCH_FILE
    }

    /** Reads into the pieces of memory that [arguments] list: file, list, its length, where to write the sum. */
    fun read(memory: Memory, arguments: LongArray): Long = eachPiece(memory, arguments) { address, size ->
        val count = minOf(size, source.size - place)
        memory.write(address, source, place, count)
        place += count
        count
    }

    /** Writes the pieces of memory that [arguments] list. */
    fun write(memory: Memory, arguments: LongArray): Long = eachPiece(memory, arguments) { address, size ->
        (if (arguments[0] == OUTPUT) output else words).write(memory.readBytes(address, size), 0, size)
        size
    }

    private fun eachPiece(memory: Memory, arguments: LongArray, move: (Int, Int) -> Int): Long {
        val list = arguments[1].toInt()
        val sum = (0 until arguments[2].toInt()).sumOf {
            val piece = list + it * PIECE
            move(memory.readInt(piece), memory.readInt(piece + Int.SIZE_BYTES))
        }
        memory.writeI32(arguments[3].toInt(), sum)
        return 0
    }

    private companion object {
        /** The bits of the flags that ask for writing. */
        const val ACCESS = 3
        const val SOURCE = 3L
        const val OUTPUT = 4L
        const val NO_SUCH_FILE = -44L

        /** An address and a size. */
        const val PIECE = 8
    }
}
