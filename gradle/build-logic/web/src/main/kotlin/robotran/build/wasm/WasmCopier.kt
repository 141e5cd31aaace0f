package robotran.build.wasm

/** What an index in a module refers to. */
internal enum class IndexSpace {
    TYPE,

    /** A function that is called, exported or started. */
    FUNCTION,

    /** A function whose reference is taken. It has the same index as a [FUNCTION]. */
    REFERENCE,
    TABLE,
    MEMORY,
    GLOBAL,
    TAG,
    ELEMENT,
    DATA,
    ;

    /** The kind of an import or export of this. */
    val kind: Int get() = KINDS.indexOf(this)

    companion object {
        /** The kinds of imports and exports, by their number in the binary format. */
        private val KINDS = listOf(FUNCTION, TABLE, MEMORY, GLOBAL, TAG)

        /** What an import or export of [kind] is. */
        fun ofKind(kind: Int): IndexSpace =
            KINDS.getOrNull(kind) ?: error("Imports and exports of kind $kind are not known.")
    }
}

/** The new value of an index. */
internal fun interface IndexMap {
    fun map(space: IndexSpace, index: Int): Int
}

/**
 * Copies parts of a module from [input] to [output] and replaces each index by that of [indices]. The format is that of
 * the WebAssembly specification 3.0, chapter 5.
 *
 * @param marks adds instructions before those that read the memory; null if nothing is added.
 */
internal class WasmCopier(
    private val input: WasmReader,
    private val output: WasmWriter = WasmWriter(),
    private val marks: ReadMarks? = null,
    private val indices: IndexMap,
) {
    fun bytes(): ByteArray = output.bytes()

    fun peek(): Int = input.peek()

    fun byte(): Int = input.byte().also { output.byte(it) }

    fun number(): Int = input.number().also { output.number(it) }

    /** A number whose value does not matter, of any size. */
    fun anyNumber() {
        do {
            val part = byte()
        } while (part >= MORE)
    }

    fun raw(length: Int) {
        output.raw(input.take(length))
    }

    fun index(space: IndexSpace) {
        output.number(indices.map(space, input.number()))
    }

    /** The first of [space], which an instruction uses without naming it, so its index must stay. */
    fun unnamed(space: IndexSpace) {
        check(indices.map(space, 0) == 0) { "The $space 0 must be the first of each part." }
    }

    /** Adds what marks the instruction that comes next. */
    fun mark() {
        if (marks != null) output.raw(marks.before(WasmReader(input.bytes, input.position)))
    }

    inline fun vector(element: () -> Unit) {
        repeat(number()) { element() }
    }

    /** A negative number is an abstract type such as `func`; the others are indices. */
    fun heapType() {
        if (input.peek() in ABSTRACT) byte() else output.signed(indices.map(IndexSpace.TYPE, input.number()))
    }

    /** The type of a value, or of a field that is narrower than a value. */
    fun valueType() {
        if (byte() in REFERENCES) heapType()
    }

    fun field() {
        valueType()
        byte()
    }

    /** The type and the initial value of a global. */
    fun global() {
        field()
        expression()
    }

    fun limits() {
        val hasMaximum = byte() and 1 == 1
        anyNumber()
        if (hasMaximum) anyNumber()
    }

    fun tableType() {
        valueType()
        limits()
    }

    /** What follows the names and the kind of an import. */
    fun importType(space: IndexSpace) = when (space) {
        IndexSpace.FUNCTION -> index(IndexSpace.TYPE)
        IndexSpace.TABLE -> tableType()
        IndexSpace.MEMORY -> limits()
        IndexSpace.GLOBAL -> field()
        else -> tagType()
    }

    fun tagType() {
        byte()
        index(IndexSpace.TYPE)
    }

    /** A group of types that may refer to each other, or a single type. */
    fun typeGroup() {
        if (input.peek() == WasmTypes.GROUP) {
            byte()
            vector(::type)
        } else {
            type()
        }
    }

    fun type() {
        var kind = byte()
        if (kind == WasmTypes.OPEN || kind == WasmTypes.FINAL) {
            vector { index(IndexSpace.TYPE) }
            kind = byte()
        }
        when (kind) {
            WasmTypes.FUNCTION_TYPE -> repeat(2) { vector(::valueType) }
            WasmTypes.STRUCT -> vector(::field)
            WasmTypes.ARRAY -> field()
            else -> error("Types of kind $kind are not known.")
        }
    }

    /** The locals and the instructions of a function, without the length. */
    fun body() {
        locals()
        expression()
    }

    fun locals() {
        vector {
            number()
            valueType()
        }
    }

    /** Instructions up to the `end` that closes them. */
    fun expression() {
        InstructionCopier(this).expression()
    }

    /** A segment of functions for tables. */
    fun elements() {
        val flags = number()
        val isActive = flags and 1 == 0
        if (isActive && flags and EXPLICIT != 0) index(IndexSpace.TABLE)
        if (isActive) expression()
        val hasExpressions = flags and EXPRESSIONS != 0
        if (flags and (1 or EXPLICIT) != 0) {
            if (hasExpressions) {
                valueType()
            } else {
                byte()
            }
        }
        vector { if (hasExpressions) expression() else index(IndexSpace.REFERENCE) }
    }

    /** A segment of bytes for memories and arrays. */
    fun data() {
        val flags = number()
        val isActive = flags and PASSIVE == 0
        if (flags and EXPLICIT != 0) {
            index(IndexSpace.MEMORY)
        } else if (isActive) {
            unnamed(IndexSpace.MEMORY)
        }
        if (isActive) expression()
        raw(number())
    }

    companion object {
        /** Where the flag of a segment for tables says that it is no active one. */
        const val PASSIVE = 1

        /** Where the flags of a segment name a table or memory, or say that one that is not active only declares. */
        const val EXPLICIT = 2
        private const val EXPRESSIONS = 4
        private const val MORE = 0x80

        /** The first byte of an abstract type: a negative number of one byte. */
        val ABSTRACT = 0x40..0x7f

        /** How the types of references begin whose target is named: nullable or not. */
        val REFERENCES = 0x63..0x64
    }
}
