package robotran.legofirmware.listing

import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.instructions.PlacedInstruction
import robotran.legofirmware.instructions.instructionAt

/** A part of code: an instruction, or a byte that begins none. */
internal sealed interface CodePart {
    val address: Int
    val size: Int

    data class Command(val placed: PlacedInstruction) : CodePart {
        override val address: Int get() = placed.address
        override val size: Int get() = placed.instruction.opcode.size
    }

    data class Unknown(override val address: Int) : CodePart {
        override val size: Int get() = 1
    }
}

/** The parts of the code one after the other. After a byte that begins no instruction, the next byte is tried. */
internal fun CodeBytes.parts(): List<CodePart> {
    val parts = mutableListOf<CodePart>()
    var address = 0
    while (address < size) {
        val part = instructionAt(address)?.let { CodePart.Command(it) } ?: CodePart.Unknown(address)
        parts += part
        address += part.size
    }
    return parts
}
