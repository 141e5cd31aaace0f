package robotran.tinyvm.link

/**
 * Where a `switch` continues.
 *
 * @param keys ascending.
 * @property targets the positions in the code for each key, and behind them that for all other numbers.
 */
internal class SwitchTable(private val keys: IntArray, val targets: IntArray) {
    private val first = keys.firstOrNull() ?: 0

    /** Whether the keys are all numbers from the first to the last. */
    private val isDense = keys.isNotEmpty() && keys.last().toLong() - keys.first() == keys.size - 1L

    /** The position for [value]. */
    fun target(value: Int): Int = targets[indexOf(value)]

    /** The index in [targets] for [value]. */
    fun indexOf(value: Int): Int {
        if (isDense) {
            val index = value.toLong() - first
            return if (index in keys.indices) index.toInt() else keys.size
        }
        var low = 0
        var high = keys.size - 1
        while (low <= high) {
            val middle = (low + high) ushr 1
            val key = keys[middle]
            when {
                key < value -> low = middle + 1
                key > value -> high = middle - 1
                else -> return middle
            }
        }
        return keys.size
    }

    /** The same table with other targets. */
    fun withTargets(targets: IntArray) = SwitchTable(keys, targets)
}
