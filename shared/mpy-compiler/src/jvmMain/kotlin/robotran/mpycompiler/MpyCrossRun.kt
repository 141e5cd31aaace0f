package robotran.mpycompiler

import com.dylibso.chicory.runtime.ByteBufferMemory
import com.dylibso.chicory.runtime.HostFunction
import com.dylibso.chicory.runtime.ImportValues
import com.dylibso.chicory.runtime.Instance
import com.dylibso.chicory.runtime.Memory
import com.dylibso.chicory.wasm.ChicoryException
import com.dylibso.chicory.wasm.WasmModule
import com.dylibso.chicory.wasm.types.FunctionImport

/**
 * One run of the compiler, whose module was made with Emscripten: it exports and imports functions under single letters. It
 * reads its source from a file and writes another, and gets an answer of ours for both.
 */
internal class MpyCrossRun(module: WasmModule, private val fileName: String, source: ByteArray) {
    private val files = MpyCrossFiles(fileName, source)

    /** The upper half of a number of 64 bits that a function returns. */
    private var upperHalf = 0L

    private val instance: Instance = Instance.builder(module)
        .withMemoryFactory { ByteBufferMemory(it) }
        .withImportValues(imports(module))
        .build()

    private val memory: Memory get() = instance.memory()

    fun run(): MpyResult {
        call(INITIALISE)
        val arguments = call(ALLOCATE_ON_STACK, 3L * WORD).toInt()
        memory.writeI32(arguments, onStack("mpy-cross"))
        memory.writeI32(arguments + WORD, onStack(fileName))
        memory.writeI32(arguments + 2 * WORD, 0)
        val status = try {
            call(MAIN, 2, arguments.toLong()).toInt()
        } catch (exit: ExitException) {
            exit.status
        }
        return MpyResult.of(status, files.written, files.printed.lines())
    }

    private fun imports(module: WasmModule): ImportValues {
        val functions = module.importSection()
        val builder = ImportValues.builder()
        for (index in 0 until functions.importCount()) {
            val import = functions.getImport(index) as FunctionImport
            val type = module.typeSection().getType(import.typeIndex())
            val hasResult = type.returns().isNotEmpty()
            val handle = HostFunction(import.module(), import.name(), type) { _, arguments ->
                val result = answer(import.name(), arguments)
                if (hasResult) longArrayOf(result) else null
            }
            builder.addFunction(handle)
        }
        return builder.build()
    }

    /** Calls the function [name] of ours for the module. */
    private fun answer(name: String, arguments: LongArray): Long = when (name) {
        OPEN -> files.open(memory.readCString(arguments[0].toInt()), arguments[1].toInt())
        READ -> files.read(memory, arguments)
        WRITE -> files.write(memory, arguments)
        CLOSE -> 0
        GET_UPPER_HALF -> upperHalf
        SET_UPPER_HALF -> 0L.also { upperHalf = arguments[0] }
        THROW_LONG_JUMP -> throw LongJumpException()
        EXIT -> throw ExitException(arguments[0].toInt())
        in INVOKE -> invoke(arguments)
        else -> throw ChicoryException("the compiler cannot go on: $name")
    }

    /** Calls the function at the place of the table that comes first; a long jump out of it is told by two variables. */
    private fun invoke(arguments: LongArray): Long {
        val stack = call(SAVE_STACK)
        return try {
            val function = instance.table(0).requiredRef(arguments[0].toInt())
            instance.machine.call(function, arguments.copyOfRange(1, arguments.size))?.firstOrNull() ?: 0
        } catch (_: LongJumpException) {
            call(RESTORE_STACK, stack)
            call(SET_THREW, 1, 0)
            0
        }
    }

    private fun call(function: String, vararg arguments: Long): Long =
        instance.export(function).apply(*arguments)?.firstOrNull() ?: 0

    private fun onStack(text: String): Int {
        val bytes = text.encodeToByteArray() + 0
        return call(ALLOCATE_ON_STACK, bytes.size.toLong()).toInt().also { memory.write(it, bytes) }
    }

    private class LongJumpException : RuntimeException(null, null, false, false)

    private class ExitException(val status: Int) : RuntimeException(null, null, false, false)

    private companion object {
        const val WORD = 4

        // What the module exports, in version 2.0.0 of its package.
        const val INITIALISE = "s"
        const val MAIN = "u"
        const val SET_THREW = "x"
        const val SAVE_STACK = "y"
        const val RESTORE_STACK = "z"
        const val ALLOCATE_ON_STACK = "A"

        // What it imports. Of the others, "a" is a failed assertion, "m" seeks, "o" asks for more memory.
        const val GET_UPPER_HALF = "b"
        const val SET_UPPER_HALF = "c"
        const val EXIT = "f"
        const val WRITE = "i"
        const val CLOSE = "k"
        const val THROW_LONG_JUMP = "n"
        const val READ = "p"
        const val OPEN = "q"
        val INVOKE = setOf("d", "e", "g", "h", "j", "l")
    }
}
