package robotran.tinyvm.link

/** The effects of instructions that only rearrange operands. */
internal object StackShuffles {
    fun apply(opcode: Int, frameState: FrameState) {
        when (opcode) {
            Opcode.POP -> frameState.popSingle()
            Opcode.POP2 -> frameState.popPair()
            Opcode.DUP -> frameState.popSingle().let { repeat(2) { _ -> frameState.push(it) } }
            Opcode.DUP2 -> frameState.popPair().let { repeat(2) { _ -> frameState.pushPair(it) } }

            Opcode.SWAP -> {
                val upper = frameState.popSingle()
                val lower = frameState.popSingle()
                frameState.push(upper)
                frameState.push(lower)
            }

            Opcode.DUP_X1 -> {
                val upper = frameState.popSingle()
                val lower = frameState.popSingle()
                frameState.push(upper)
                frameState.push(lower)
                frameState.push(upper)
            }

            Opcode.DUP_X2 -> {
                val upper = frameState.popSingle()
                val lower = frameState.popPair()
                frameState.push(upper)
                frameState.pushPair(lower)
                frameState.push(upper)
            }

            Opcode.DUP2_X1 -> {
                val upper = frameState.popPair()
                val lower = frameState.popSingle()
                frameState.pushPair(upper)
                frameState.push(lower)
                frameState.pushPair(upper)
            }

            Opcode.DUP2_X2 -> {
                val upper = frameState.popPair()
                val lower = frameState.popPair()
                frameState.pushPair(upper)
                frameState.pushPair(lower)
                frameState.pushPair(upper)
            }
        }
    }
}
