package robotran.tinyvm.link

/** The texts that stand in a program, each once. */
internal class StringPool {
    private val numbers = LinkedHashMap<String, Int>()

    val texts: List<String> get() = numbers.keys.toList()

    fun numberOf(text: String): Int = numbers.getOrPut(text) { numbers.size }
}
