package robotran.workshop.send

import robotran.microbitlink.ImageError
import robotran.microbitlink.ImageResult
import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.image.MicroPythonFile
import robotran.workshop.state.ProgramSize

/** The program of [built] as the only file in [file], for all its boards. */
internal fun hexOf(file: MicroPythonFile, built: MicrobitTranslation.Success): ImageResult<String> =
    mistakeOf(file, built)?.let { ImageResult.Failure(it) } ?: file.textWith(mapOf(MAIN_FILE to built.bytes))

/** Why [built] cannot go into [file]; null if it can. */
internal fun mistakeOf(file: MicroPythonFile, built: MicrobitTranslation.Success): ImageError? =
    (file.imageFor(built.board) as? ImageResult.Failure)?.error
        ?: file.smallestImage.room.mistake(mapOf(MAIN_FILE to built.bytes))

/** How much of a board [built] fills, with MicroPython of [file] if there is one. */
internal fun sizeOf(file: MicroPythonFile?, built: MicrobitTranslation.Success): ProgramSize =
    ProgramSize(built.bytes.size, file?.smallestImage?.room?.largestMain ?: built.maxBytes, built.memoryShare)
