package robotran.build.wasm

/** Copies instructions with [copier], which replaces indices. Instructions for vectors (SIMD) are not known. */
internal class InstructionCopier(private val copier: WasmCopier) {
    /** The number of blocks that are open. */
    private var depth = 1

    fun expression() {
        while (depth > 0) {
            copier.mark()
            instruction(copier.byte())
        }
    }

    private fun instruction(code: Int) {
        when (code) {
            in BLOCKS -> open()
            TRY_TABLE -> tryTable()
            END -> close()
            DELEGATE -> delegate()
            CATCH, THROW -> copier.index(IndexSpace.TAG)
            BR, BR_IF, RETHROW, BR_ON_NULL, BR_ON_NON_NULL -> copier.anyNumber()
            BR_TABLE -> branches()
            in CALLS -> copier.index(IndexSpace.FUNCTION)
            in INDIRECT_CALLS -> indexOf(IndexSpace.TYPE, IndexSpace.TABLE)
            in REFERENCE_CALLS -> copier.index(IndexSpace.TYPE)
            SELECT_TYPED -> copier.vector(copier::valueType)
            in LOCALS -> copier.anyNumber()
            in GLOBALS -> copier.index(IndexSpace.GLOBAL)
            in TABLES -> copier.index(IndexSpace.TABLE)
            in LOADS_AND_STORES -> memoryArgument()
            in MEMORY_SIZES -> copier.index(IndexSpace.MEMORY)
            in CONSTANTS -> constant(code)
            REF_NULL -> copier.heapType()
            REF_FUNC -> copier.index(IndexSpace.REFERENCE)
            OBJECTS -> objectInstruction(copier.number())
            BULK -> bulkInstruction(copier.number())
            in WITHOUT_OPERANDS, in NUMERIC, in REFERENCES -> Unit
            else -> error("The instruction 0x${code.toString(radix = 16)} is not known.")
        }
    }

    private fun indexOf(vararg spaces: IndexSpace) = spaces.forEach(copier::index)

    private fun open() {
        depth++
        blockType()
    }

    private fun close() {
        depth--
    }

    private fun blockType() {
        when (copier.peek()) {
            in WasmCopier.REFERENCES -> copier.valueType()
            in WasmCopier.ABSTRACT -> copier.byte()
            else -> copier.heapType()
        }
    }

    private fun tryTable() {
        open()
        copier.vector {
            if (copier.byte() in CATCHES_OF_TAGS) copier.index(IndexSpace.TAG)
            copier.anyNumber()
        }
    }

    private fun delegate() {
        depth--
        copier.anyNumber()
    }

    private fun branches() {
        copier.vector(copier::anyNumber)
        copier.anyNumber()
    }

    /** The alignment, whose seventh bit says that a memory is named, and the offset. */
    private fun memoryArgument() {
        val isNamed = copier.number() and NAMED_MEMORY != 0
        if (isNamed) copier.index(IndexSpace.MEMORY) else copier.unnamed(IndexSpace.MEMORY)
        copier.anyNumber()
    }

    private fun constant(code: Int) = when (code) {
        F32_CONST -> copier.raw(Float.SIZE_BYTES)
        F64_CONST -> copier.raw(Double.SIZE_BYTES)
        else -> copier.anyNumber()
    }

    private fun objectInstruction(code: Int): Unit = when (code) {
        in STRUCT_FIELDS, ARRAY_NEW_FIXED -> {
            copier.index(IndexSpace.TYPE)
            copier.anyNumber()
        }

        ARRAY_NEW_DATA, ARRAY_INIT_DATA -> indexOf(IndexSpace.TYPE, IndexSpace.DATA)
        ARRAY_NEW_ELEMENTS, ARRAY_INIT_ELEMENTS -> indexOf(IndexSpace.TYPE, IndexSpace.ELEMENT)
        ARRAY_COPY -> indexOf(IndexSpace.TYPE, IndexSpace.TYPE)
        in CASTS -> copier.heapType()

        in BRANCHING_CASTS -> {
            copier.byte()
            copier.anyNumber()
            copier.heapType()
            copier.heapType()
        }

        ARRAY_LENGTH, in CONVERSIONS -> Unit
        in ON_TYPES -> copier.index(IndexSpace.TYPE)
        else -> error("The instruction 0xfb $code is not known.")
    }

    private fun bulkInstruction(code: Int): Unit = when (code) {
        in SATURATING -> Unit
        MEMORY_INIT -> indexOf(IndexSpace.DATA, IndexSpace.MEMORY)
        DATA_DROP -> copier.index(IndexSpace.DATA)
        MEMORY_COPY -> indexOf(IndexSpace.MEMORY, IndexSpace.MEMORY)
        MEMORY_FILL -> copier.index(IndexSpace.MEMORY)
        TABLE_INIT -> indexOf(IndexSpace.ELEMENT, IndexSpace.TABLE)
        ELEMENT_DROP -> copier.index(IndexSpace.ELEMENT)
        TABLE_COPY -> indexOf(IndexSpace.TABLE, IndexSpace.TABLE)
        in TABLE_SIZES -> copier.index(IndexSpace.TABLE)
        else -> error("The instruction 0xfc $code is not known.")
    }

    private companion object {
        /** `block`, `loop`, `if` and `try`. */
        val BLOCKS = setOf(0x02, 0x03, 0x04, 0x06)
        const val TRY_TABLE = 0x1f
        val CATCHES_OF_TAGS = 0..1
        const val END = 0x0b
        const val DELEGATE = 0x18
        const val CATCH = 0x07
        const val THROW = 0x08
        const val RETHROW = 0x09
        const val BR = 0x0c
        const val BR_IF = 0x0d
        const val BR_TABLE = 0x0e
        const val BR_ON_NULL = 0xd5
        const val BR_ON_NON_NULL = 0xd6

        /** Each of the three kinds of calls has one that returns. */
        val CALLS = setOf(0x10, 0x12)
        val INDIRECT_CALLS = setOf(0x11, 0x13)
        val REFERENCE_CALLS = setOf(0x14, 0x15)
        const val SELECT_TYPED = 0x1c
        val LOCALS = 0x20..0x22
        val GLOBALS = 0x23..0x24
        val TABLES = 0x25..0x26
        val LOADS_AND_STORES = 0x28..0x3e
        const val NAMED_MEMORY = 0x40
        val MEMORY_SIZES = 0x3f..0x40
        val CONSTANTS = 0x41..0x44
        const val F32_CONST = 0x43
        const val F64_CONST = 0x44

        /** `unreachable`, `nop`, `else`, `throw_ref`, `return`, `catch_all`, `drop` and `select`. */
        val WITHOUT_OPERANDS = setOf(0x00, 0x01, 0x05, 0x0a, 0x0f, 0x19, 0x1a, 0x1b)
        val NUMERIC = 0x45..0xc4
        const val REF_NULL = 0xd0
        const val REF_FUNC = 0xd2

        /** `ref.is_null`, `ref.eq` and `ref.as_non_null`. */
        val REFERENCES = setOf(0xd1, 0xd3, 0xd4)

        const val OBJECTS = 0xfb
        val STRUCT_FIELDS = 2..5
        const val ARRAY_NEW_FIXED = 8
        const val ARRAY_NEW_DATA = 9
        const val ARRAY_NEW_ELEMENTS = 10
        const val ARRAY_LENGTH = 15
        const val ARRAY_COPY = 17
        const val ARRAY_INIT_DATA = 18
        const val ARRAY_INIT_ELEMENTS = 19
        val CASTS = 20..23
        val BRANCHING_CASTS = 24..25
        val CONVERSIONS = 26..30
        val ON_TYPES = 0..16

        const val BULK = 0xfc
        val SATURATING = 0..7
        const val MEMORY_INIT = 8
        const val DATA_DROP = 9
        const val MEMORY_COPY = 10
        const val MEMORY_FILL = 11
        const val TABLE_INIT = 12
        const val ELEMENT_DROP = 13
        const val TABLE_COPY = 14
        val TABLE_SIZES = 15..17
    }
}
