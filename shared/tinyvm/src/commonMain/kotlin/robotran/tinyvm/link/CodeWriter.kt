package robotran.tinyvm.link

/** Collects operations and operands, with the class file position that each word comes from. */
internal class CodeWriter {
    private var words = IntArray(INITIAL_CAPACITY)
    private var places = IntArray(INITIAL_CAPACITY)

    /** The positions of the words that are branch targets. */
    private val branches = ArrayList<Int>()

    var size = 0
        private set

    /** The tables of `switch` statements; their targets are byte positions until [finish]. */
    val switches = ArrayList<SwitchTable>()

    /** The byte position that the next words come from. */
    var place = 0

    fun write(word: Int) {
        if (size == words.size) {
            words = words.copyOf(size * 2)
            places = places.copyOf(size * 2)
        }
        words[size] = word
        places[size++] = place
    }

    fun write(operation: Int, operand: Int) {
        write(operation)
        write(operand)
    }

    fun write(operation: Int, first: Int, second: Int) {
        write(operation, first)
        write(second)
    }

    /** Writes an operation whose operand is the position of the instruction at [target], which [finish] fills in. */
    fun writeBranch(operation: Int, target: Int) {
        write(operation)
        branches += size
        write(target)
    }

    /** Writes a `switch` that continues at the instructions at the targets of [table], which [finish] fills in. */
    fun writeSwitch(table: SwitchTable) {
        write(Operation.SWITCH, switches.size)
        switches += table
    }

    /** Returns the words, with the branch targets looked up in [positions]. */
    fun finish(positions: IntArray): IntArray {
        for (branch in branches) words[branch] = positions[words[branch]]
        for (index in switches.indices) {
            val table = switches[index]
            switches[index] = table.withTargets(IntArray(table.targets.size) { positions[table.targets[it]] })
        }
        return words.copyOf(size)
    }

    fun finishedPositions(): IntArray = places.copyOf(size)

    private companion object {
        const val INITIAL_CAPACITY = 64
    }
}
