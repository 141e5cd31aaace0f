package robotran.microbitlink

import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.image.MicroPythonFile
import kotlin.test.assertIs

/** The value of a result that must be a success. */
internal fun <T> ImageResult<T>.value(): T = assertIs<ImageResult.Success<T>>(this).value

/** The error of a result that must be none. */
internal fun ImageResult<*>.error(): ImageError = assertIs<ImageResult.Failure>(this).error

internal fun vector(name: String): String = vectors.getValue(name)

/** A made-up image for [board]: no MicroPython, but laid out like it. */
internal fun madeUp(board: MicrobitBoard): MicroPythonFile =
    MicroPythonFile.read(vector("madeup-${board.name.lowercase()}.hex")).value()

/** Made-up images for both boards. */
internal val madeUpForBoth: MicroPythonFile get() = madeUp(MicrobitBoard.V1).joinedWith(madeUp(MicrobitBoard.V2))

/** A file system with one program. */
internal fun mainOf(program: String): Map<String, ByteArray> = mapOf(MAIN_FILE to program.encodeToByteArray())

/** The same texts, to compare. */
internal fun Map<String, ByteArray>.texts(): Map<String, String> = mapValues { it.value.decodeToString() }
