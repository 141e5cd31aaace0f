package robotran.legofirmware.image

import robotran.language.Language
import robotran.legofirmware.messages.ImageMessages

/** What is wrong with an image file. */
sealed interface ImageFault {
    /** The file is larger than [FirmwareLimits.IMAGE_BYTES]. */
    data class TooLarge(val bytes: Int) : ImageFault

    /** The file does not begin with `RCXI`, or ends within its header. */
    data object NotAnImage : ImageFault

    /** The file's version, 0..65535 with the main version in the high byte, is greater than 1.02. */
    data class NewerVersion(val version: Int) : ImageFault

    /** The image is for another brick, such as the Scout, or for none that is known. */
    data class OtherBrick(val code: Int) : ImageFault

    /** A chunk that is neither task nor subroutine. */
    data class UnknownChunk(val type: Int) : ImageFault

    /** The file ends within a task or subroutine; null if within its kind and number. */
    data class ChunkCut(val id: ChunkId?) : ImageFault

    /** A task or subroutine with a number that the firmware does not have. */
    data class NumberTooHigh(val id: ChunkId) : ImageFault

    /** A second task or subroutine with one number. */
    data class ChunkTwice(val id: ChunkId) : ImageFault

    /** More symbols than [FirmwareLimits.SYMBOLS]. */
    data class TooManySymbols(val count: Int) : ImageFault

    /** A warning: the file ends within the names, so [missing] of them are unknown. */
    data class NamesCut(val missing: Int) : ImageFault

    /** A warning: a name of a kind that is unknown, or of a task or subroutine that is not there, is left out. */
    data class NameWithoutChunk(val name: String) : ImageFault

    /** A warning: [bytes] follow the end of the image. */
    data class ExtraBytes(val bytes: Int) : ImageFault

    /** A warning: the code has more bytes than fit into a brick, see [FirmwareLimits.PROGRAM_MEMORY]. */
    data class LargeProgram(val bytes: Int) : ImageFault

    /** A warning: there is no task 0, so Run starts nothing. */
    data object NoMainTask : ImageFault
}

/** A sentence or two in words a pupil knows. */
fun ImageFault.message(language: Language): String {
    val messages = ImageMessages.of(language)
    return when (this) {
        is ImageFault.TooLarge -> messages.tooLarge(bytes, FirmwareLimits.IMAGE_BYTES)
        ImageFault.NotAnImage -> messages.notAnImage()
        is ImageFault.NewerVersion -> messages.newerVersion(versionText(version))
        is ImageFault.OtherBrick -> messages.otherBrick(OTHER_BRICKS[code])
        is ImageFault.UnknownChunk -> messages.unknownChunk(type)
        is ImageFault.ChunkCut -> messages.chunkCut(id?.let { messages.chunk(it.isTask, it.number) })
        is ImageFault.NumberTooHigh -> messages.numberTooHigh(id.isTask, id.number, id.kind.limit - 1)
        is ImageFault.ChunkTwice -> messages.chunkTwice(messages.chunk(id.isTask, id.number))
        is ImageFault.TooManySymbols -> messages.tooManySymbols(count, FirmwareLimits.SYMBOLS)
        is ImageFault.NamesCut -> messages.namesCut(missing)
        is ImageFault.NameWithoutChunk -> messages.nameWithoutChunk(name)
        is ImageFault.ExtraBytes -> messages.extraBytes(bytes)
        is ImageFault.LargeProgram -> messages.largeProgram(bytes, FirmwareLimits.PROGRAM_MEMORY)
        ImageFault.NoMainTask -> messages.noMainTask()
    }
}

private val ChunkId.isTask: Boolean get() = kind == ChunkKind.TASK

private const val BYTE_MASK = 0xFF
private const val VERSION_DIGITS = 2
private const val HEX_RADIX = 16

private fun versionText(version: Int): String = (version shr Byte.SIZE_BITS).toString(HEX_RADIX) + "." +
    (version and BYTE_MASK).toString(HEX_RADIX).padStart(VERSION_DIGITS, '0')

/** The other bricks of NQC by their number in an image. */
private val OTHER_BRICKS = mapOf(1 to "CyberMaster", 2 to "Scout", 4 to "Spybotics", 5 to "Swan")
