package robotran.hublink.program

import robotran.hublink.HubError
import robotran.hublink.fourBytes

/**
 * A compiled module of a program.
 *
 * @property name what `import` calls it.
 */
class HubModule(val name: String, val mpy: ByteArray) {
    init {
        require(name.isNotEmpty() && '\u0000' !in name) { "a module needs a name" }
    }

    companion object {
        /** The name that every firmware takes for the first module. */
        const val MAIN = "__main__"
    }
}

/** A program for a hub. The first of its [modules] is the one that runs. */
class HubProgram(val modules: List<HubModule>) {
    init {
        require(modules.isNotEmpty()) { "a program has a module" }
    }

    /** A program of one module. */
    constructor(mpy: ByteArray) : this(listOf(HubModule(HubModule.MAIN, mpy)))

    /** As it is sent, the format "multi-mpy6": of each module its size, its name, a zero byte, its bytes. */
    val bytes: ByteArray by lazy {
        modules.map { fourBytes(it.mpy.size) + it.name.encodeToByteArray() + 0 + it.mpy }.reduce(ByteArray::plus)
    }

    /**
     * Why no hub could run it: the hub itself would say so only at the start, without a word on the reason. Null if nothing
     * is wrong with it.
     */
    fun mistake(): HubError? = modules.firstNotNullOfOrNull { mistakeOf(it) }

    private fun mistakeOf(module: HubModule): HubError? {
        val file = MpyFile.read(module.mpy) ?: return HubError.NotAProgram
        val isForOthers = file.nativeCode || file.smallIntegerBits > SMALL_INTEGER_BITS
        return if (isForOthers) HubError.NotAProgram else file.longNumbers.firstOrNull()?.let(HubError::NumberTooLarge)
    }

    private companion object {
        const val SMALL_INTEGER_BITS = 31
    }
}
