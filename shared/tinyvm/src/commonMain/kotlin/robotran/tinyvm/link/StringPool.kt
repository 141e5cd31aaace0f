package robotran.tinyvm.link

/** The distinct string constants of a program. */
internal class StringPool {
    private val numbers = LinkedHashMap<String, Int>()

    val texts: List<String> get() = numbers.keys.toList()

    fun numberOf(text: String): Int = numbers.getOrPut(text) { numbers.size }
}
