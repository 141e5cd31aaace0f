package robotran.tinyvm.link

import robotran.tinyvm.link.RegisterCode.Companion.EXIT_HEADER

/**
 * Compiles a method's stack code to [RegisterCode].
 *
 * @param code the stack code.
 * @param handlerTargets the positions in it at which exception handlers start.
 * @param blocks compiles single blocks of it.
 */
internal class RegisterCompiler(
    private val code: IntArray,
    private val handlerTargets: List<Int>,
    private val blocks: BlockCompiler,
) {
    private val entries = IntArray(code.size) { NO_BLOCK }
    private val words = IntStack()
    private val exits = IntStack()
    private val exitTable = IntStack()
    private val successors = ArrayList<Int>()
    private val queue = ArrayDeque<Int>()

    /** Returns the compiled code, null if the method is one of the rare ones that only stack code can express. */
    fun compile(): RegisterCode? {
        if (hasSubroutines()) return null
        queue += 0
        queue += handlerTargets
        while (queue.isNotEmpty()) {
            val start = queue.removeFirst()
            if (entries[start] != NO_BLOCK) continue
            entries[start] = words.size
            val block = blocks.compile(start)
            if (block.instructions.any { !it.isEncodable }) return null
            write(block)
        }
        val finished = words.toArray()
        for (index in successors) finished[index] = entries[finished[index]]
        return RegisterCode(finished, entries, exits.toArray(), exitTable.toArray())
    }

    private fun hasSubroutines(): Boolean {
        var position = 0
        while (position < code.size) {
            val operation = code[position]
            if (operation == Operation.SUBROUTINE || operation == Operation.END_SUBROUTINE) return true
            position += lengthOf(operation)
        }
        return false
    }

    private fun write(block: RegisterBlock) {
        addWord(block.bytecodes or (block.statements shl STATEMENTS_SHIFT), addExit(block, block.start, counted = 0))
        for (instruction in block.instructions) {
            addWord(instruction.word, instruction.exit?.let { addExit(block, it, block.statements) } ?: NO_EXIT)
            instruction.words.forEach { addWord(it, NO_EXIT) }
            for (successor in instruction.successors) {
                successors += words.size
                addWord(successor, NO_EXIT)
                queue += successor
            }
        }
        queue += block.next
    }

    private fun addWord(word: Int, exit: Int) {
        words.push(word)
        exits.push(exit)
    }

    /** Adds an entry to the exit table, for a place where [counted] statements of [block] are counted. */
    private fun addExit(block: RegisterBlock, exit: BlockExit, counted: Int): Int {
        val entry = exitTable.size
        exitTable.push(exit.position)
        exitTable.push(block.bytecodes - exit.bytecodes)
        exitTable.push(maxOf(0, counted - exit.statements))
        exitTable.push(exit.end)
        exitTable.push(exit.delayed.size / RegisterCode.DELAYED_OPERAND_WORDS)
        check(exitTable.size == entry + EXIT_HEADER)
        exit.delayed.forEach { exitTable.push(it) }
        return entry
    }

    private companion object {
        const val NO_BLOCK = -1
        const val NO_EXIT = -1
        const val STATEMENTS_SHIFT = 16
    }
}
