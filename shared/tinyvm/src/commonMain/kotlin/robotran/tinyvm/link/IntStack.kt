package robotran.tinyvm.link

/** A growing stack of numbers. */
internal class IntStack {
    private var values = IntArray(16)

    var size = 0
        private set

    val isEmpty: Boolean get() = size == 0

    fun push(value: Int) {
        if (size == values.size) values = values.copyOf(size * 2)
        values[size++] = value
    }

    fun pop(): Int = values[--size]

    operator fun get(index: Int): Int = values[index]

    fun toArray(): IntArray = values.copyOf(size)
}
