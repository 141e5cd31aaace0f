package robotran.tinyvm.link

/** The effects of instructions that only rearrange operands. */
internal object StackShuffles {
    fun apply(opcode: Int, situation: FrameState) {
        when (opcode) {
            Opcode.POP -> {
                situation.popSingle()
            }

            Opcode.POP2 -> {
                situation.popPair()
            }

            Opcode.DUP -> {
                situation.popSingle().let { repeat(2) { _ -> situation.push(it) } }
            }

            Opcode.DUP2 -> {
                situation.popPair().let { repeat(2) { _ -> situation.pushPair(it) } }
            }

            Opcode.SWAP -> {
                val upper = situation.popSingle()
                val lower = situation.popSingle()
                situation.push(upper)
                situation.push(lower)
            }

            Opcode.DUP_X1 -> {
                val upper = situation.popSingle()
                val lower = situation.popSingle()
                situation.push(upper)
                situation.push(lower)
                situation.push(upper)
            }

            Opcode.DUP_X2 -> {
                val upper = situation.popSingle()
                val lower = situation.popPair()
                situation.push(upper)
                situation.pushPair(lower)
                situation.push(upper)
            }

            Opcode.DUP2_X1 -> {
                val upper = situation.popPair()
                val lower = situation.popSingle()
                situation.pushPair(upper)
                situation.push(lower)
                situation.pushPair(upper)
            }

            Opcode.DUP2_X2 -> {
                val upper = situation.popPair()
                val lower = situation.popPair()
                situation.pushPair(upper)
                situation.pushPair(lower)
                situation.pushPair(upper)
            }
        }
    }
}
