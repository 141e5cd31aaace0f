package robotran.lejoslinker.link

import robotran.tinyvm.link.SpecialNumbers

/** Numbers the signatures of an image: the special ones first, then others in the order of their methods. */
internal class SignatureTable {
    private val numbers = LinkedHashMap<String, Int>()

    init {
        SpecialNumbers.SIGNATURES.forEach(::numberOf)
    }

    /** All signatures by number. */
    val all: List<String> get() = numbers.keys.toList()

    fun numberOf(signature: String): Int = numbers.getOrPut(signature) { numbers.size }

    companion object {
        /** Whether the firmware has a native method for the signature [number]. Source: leJOS `native.c`. */
        fun isNative(number: Int): Boolean = number in FIRST_NATIVE..LAST_NATIVE && number != GET_MESSAGE

        /** `notify`; before it are main, run and the initializers. */
        private const val FIRST_NATIVE = 4
        private const val LAST_NATIVE = 49
        private const val GET_MESSAGE = 25
    }
}
