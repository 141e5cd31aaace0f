package robotran.legofirmware.assembly

import robotran.legofirmware.image.ChunkId

/** A task or subroutine whose commands have addresses, while the targets of jumps may still be unknown. */
internal class AssembledChunk(val id: ChunkId, val frame: BlockDirective, val start: Token) {
    val commands = mutableListOf<Command>()

    /** The address of each label. */
    val labels = mutableMapOf<String, Int>()

    var size = 0
        private set

    fun add(word: Token, content: Content) {
        commands += Command(size, word, content)
        size += content.size
    }

    class Command(val address: Int, val word: Token, val content: Content)

    /** @property size in bytes. */
    sealed interface Content {
        val size: Int

        /** @property operands null if they have a mistake. */
        class Instruction(val form: CommandForm, val operands: List<Token>?) : Content {
            override val size: Int get() = form.opcode.size
        }

        class Bytes(val bytes: List<Int>) : Content {
            override val size: Int get() = bytes.size
        }
    }
}
